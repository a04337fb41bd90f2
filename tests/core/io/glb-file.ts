import { type AnimationClip, AnimationMixer, type Bone, Box3, type Group, type SkinnedMesh } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { DEFAULT_EXPORT, type ExportOptions } from '../../../src/core/io/export-options.ts';
import { type GlbExtras, writeGlb } from '../../../src/core/io/glb/write-glb.ts';
import type { GrownPacked } from '../../../src/core/pack/grow-packed.ts';

/** A GLB written and read again by three's own loader. */
export interface Reloaded {
  readonly bytes: Uint8Array;
  readonly scene: Group;
  readonly animations: AnimationClip[];
  readonly box: Box3;
  /** Puts the bones where the clip has them at a time, seconds. */
  readonly seek: (time: number) => void;
  readonly bones: () => Bone[];
  readonly skinned: () => SkinnedMesh[];
}

/** Without images: those take a browser to read. */
export const options = (more: Partial<ExportOptions>): ExportOptions => ({
  ...DEFAULT_EXPORT,
  textures: 'none',
  ...more,
});

export async function reload(
  grown: GrownPacked,
  more: Partial<ExportOptions>,
  extras: GlbExtras = {},
): Promise<Reloaded> {
  const bytes = await writeGlb(grown, options(more), extras);
  const { scene, animations } = await new GLTFLoader().parseAsync(bytes.slice().buffer, '');
  scene.updateMatrixWorld(true);
  const mixer = new AnimationMixer(scene);
  for (const clip of animations) mixer.clipAction(clip).play();
  const found = <T>(what: 'isBone' | 'isSkinnedMesh'): T[] => {
    const list: T[] = [];
    scene.traverse((object) => {
      if (what in object) list.push(object as T);
    });
    return list;
  };
  return {
    bytes,
    scene,
    animations,
    box: new Box3().setFromObject(scene, true),
    seek: (time) => {
      mixer.setTime(time);
      scene.updateMatrixWorld(true);
    },
    bones: () => found<Bone>('isBone'),
    skinned: () => found<SkinnedMesh>('isSkinnedMesh'),
  };
}
