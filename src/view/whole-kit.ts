import { barkImage } from '../core/look/bark-image.ts';
import { leafForm } from '../core/look/leaf-shapes.ts';
import { organMesh } from '../core/look/organ-mesh.ts';
import { CpuPoser } from '../gpu/cpu-poser.ts';
import './bark-own.ts';
import { channelTexels } from './channel-texels.ts';
import { controlLines, setControlLines } from './control-lines.ts';
import { pickBranch, pickCrown } from './pick.ts';
import type { TreeKit } from './tree-kit.ts';

/** All of it: what a scene draws its trees with. */
export const wholeKit: TreeKit = {
  barkImage,
  leafForm,
  organMesh,
  cpuPoser: (textures, near) => new CpuPoser(textures, near),
  pick: { branch: pickBranch, crown: pickCrown },
  lines: { make: controlLines, fit: setControlLines },
  channelTexels,
};
