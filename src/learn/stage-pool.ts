import { Stage } from '../view/stage.ts';
import { words } from './words.ts';

/** Who draws on a stage of the pool. */
export interface StageUser {
  /** Its stage goes to another: what it has on that GPU context is to be freed. */
  lose(stage: Stage): void;
}

/** WebGL contexts of a page at most: browsers drop the oldest of about sixteen, and each costs memory. */
const MOST = 2;

interface Place {
  readonly stage: Stage;
  user: StageUser | null;
}

/** The places, the one that was used last at the end. */
const places: Place[] = [];

/**
 * A stage to draw on, off the page: its picture is copied from `stage.renderer.domElement`. The one that has not been used for longest changes
 * hands. Throws where the browser gives no WebGL 2.
 */
export function stageFor(user: StageUser): Stage {
  const at = places.findIndex((place) => place.user === user);
  let place = at >= 0 ? places.splice(at, 1)[0] : undefined;
  place ??= places.length < MOST ? undefined : places.shift();
  if (!place) {
    const canvas = document.createElement('canvas');
    // A clear word in place of three's own.
    const gives = document.createElement('canvas').getContext('webgl2');
    if (!gives) throw new Error(words.noWebGl);
    gives.getExtension('WEBGL_lose_context')?.loseContext();
    place = { stage: new Stage(canvas, { shadows: 512, antialias: true }), user: null };
  }
  if (place.user !== user) {
    place.user?.lose(place.stage);
    place.user = user;
  }
  places.push(place);
  return place.stage;
}

/** Gives a stage and its context back, for one that is far from the window. */
export function releaseStage(user: StageUser): void {
  const at = places.findIndex((place) => place.user === user);
  if (at < 0) return;
  const [place] = places.splice(at, 1) as [Place];
  user.lose(place.stage);
  place.stage.dispose();
  place.stage.renderer.forceContextLoss();
}
