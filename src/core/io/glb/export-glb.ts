import type { WriteFormat } from '../export-tree.ts';
import { writeGlb } from './write-glb.ts';

/** One GLB file. */
export const exportGlb: WriteFormat = async ({ grown, options, wind, name, report }) => [
  { name: `${name}.glb`, bytes: await writeGlb(grown(), options, { wind, report }), type: 'model/gltf-binary' },
];
