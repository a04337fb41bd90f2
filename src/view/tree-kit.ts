import type { Box3, InstancedBufferGeometry, LineSegments, ShaderMaterial } from 'three';
import type { BarkImage } from '../core/look/bark-image.ts';
import type { LeafForm } from '../core/look/blade.ts';
import type { LeafGrain, LeafMesh } from '../core/look/leaf-mesh.ts';
import type { LeafSpec } from '../core/look/leaf-spec.ts';
import type { BarkKind, OrganKind } from '../core/species/species.ts';
import type { Poser } from '../gpu/poser.ts';
import type { Near } from '../gpu/state-run.ts';
import type { TreeTextures } from '../gpu/tree-textures.ts';
import type { channelTexels } from './channel-texels.ts';
import type { pickBranch, pickCrown } from './pick.ts';
import type { SharedUniforms } from './uniforms.ts';

/** Lines that show what the GPU moves. */
export interface LineKit {
  make(shared: SharedUniforms): LineSegments<InstancedBufferGeometry, ShaderMaterial>;
  fit(
    lines: LineSegments<InstancedBufferGeometry, ShaderMaterial>,
    count: number,
    ends: readonly number[],
    box: Box3,
  ): void;
}

/** Answers to rays. */
export interface PickKit {
  readonly branch: typeof pickBranch;
  readonly crown: typeof pickCrown;
}

/**
 * What trees are made with of which one tree needs little: every kind of bark, leaf and organ, and what most pages never ask for.
 *
 * A scene has all of it at hand (whole-kit.ts), since a tree is set at once. A page that shows one tree, and can wait for it, gives what the
 * tree needs: that is a seventh of all that travels to it.
 */
export interface TreeKit {
  /** As barkImage of core/look/bark-image.ts, leafForm and organMesh: of the kinds of the trees that are set. */
  barkImage(kind: BarkKind, size: number): BarkImage;
  leafForm(spec: Pick<LeafSpec, 'shape' | 'margin'>): LeafForm;
  organMesh(kind: OrganKind, grain: LeafGrain, bundle: number): LeafMesh;
  /** Poses where the GPU lacks float targets. */
  cpuPoser(textures: TreeTextures, near: Near): Poser;
  /** null: rays meet nothing, lines and channels are not shown. */
  readonly pick: PickKit | null;
  readonly lines: LineKit | null;
  readonly channelTexels: typeof channelTexels | null;
}
