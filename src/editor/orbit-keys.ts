import type { CameraPose } from '../core/link/link.ts';
import type { Picture } from '../view/picture/picture.ts';
import type { Actions } from './actions.ts';

/** Degrees and share of the distance that one press moves the camera. */
const TURN = 5;
const CLOSER = 0.9;

/** Walks around the tree with the arrow keys while the picture has the focus; plus and minus come closer and go away. */
export function listenToOrbitKeys(picture: Picture, actions: Actions): void {
  const moves: Record<string, (c: CameraPose) => Partial<CameraPose>> = {
    ArrowLeft: (c) => ({ azimuth: c.azimuth - TURN }),
    ArrowRight: (c) => ({ azimuth: c.azimuth + TURN }),
    ArrowUp: (c) => ({ elevation: Math.min(85, c.elevation + TURN) }),
    ArrowDown: (c) => ({ elevation: Math.max(-15, c.elevation - TURN) }),
    '+': (c) => ({ distance: c.distance * CLOSER }),
    '=': (c) => ({ distance: c.distance * CLOSER }),
    '-': (c) => ({ distance: c.distance / CLOSER }),
  };
  picture.canvas.addEventListener('keydown', (event) => {
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const { camera } = picture;
    actions.setCamera({ ...camera, ...move(camera) });
  });
}
