/** Functions of the cases that belong to features not built yet. A name leaves this list when its adapter arrives. */
export const later: readonly string[] = [
  'murray',
  'half_move',
  'mitre_corner',
  'pn_triangle',
  'pn_tri_normal',
  'pn_quad',
  'pn_quad_normal',
  'pn_circle',
  'catmull_clark',
  'swivel',
  'leaf_normals',
  'lsys',
  'morphology',
  'gvf',
  'snake_implicit',
  'snake_explicit',
];
