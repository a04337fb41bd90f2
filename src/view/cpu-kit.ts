import type { TreeKit } from './tree-kit.ts';

/** Where a GPU lacks `floatTargets`, which the wind pass draws into, trees are posed by `TreeKit.cpuPoser`. */
export { type Capabilities, capabilitiesOf } from '../gpu/capabilities.ts';

/** What poses trees there, for a page that has not got it. */
export async function loadCpuPoser(): Promise<TreeKit['cpuPoser']> {
  const { CpuPoser } = await import('../gpu/cpu-poser.ts');
  return (textures, near) => new CpuPoser(textures, near);
}
