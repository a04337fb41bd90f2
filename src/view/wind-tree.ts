import { KitTree, type WindTreeOptions } from './kit-tree.ts';
import { wholeKit } from './whole-kit.ts';

export type { Degradation, DrawnElements, Mode, PaperRange, Which, WindTreeOptions } from './kit-tree.ts';

/**
 * A tree in the wind, at home in any three.js scene: standard lights, shadows, fog, environment maps, clipping.
 *
 * Give it a packed tree and a wind, and call `update` once a frame before rendering. Metres; y is up outside. Several trees
 * may share a scene; each feels the wind at the place where it stands.
 */
export class WindTree extends KitTree {
  constructor(options: WindTreeOptions = {}) {
    super(wholeKit, options);
  }
}
