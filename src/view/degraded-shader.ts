import lineFragment from '../../shaders/branch/line-fragment.glsl';
import lineVertex from '../../shaders/branch/line-vertex.glsl';
import pointVertex from '../../shaders/leaf/point-vertex.glsl';
import { BRANCH_STANDARD } from './branch-shader.ts';
import type { Injection, Patch } from './inject.ts';
import { LEAF_DEPTH, LEAF_STANDARD } from './leaf-shader.ts';

/** For MeshStandardMaterial on lines: the middle of a ribbon, drawn as the line that it is from afar. */
export const BRANCH_LINE: Injection = {
  vertex: [
    ...BRANCH_STANDARD.vertex,
    { anchor: '#include <fog_pars_vertex>', before: lineVertex },
    {
      anchor: '#include <project_vertex>',
      after: `vWide = 2.0 * here.radius * length(modelViewMatrix[0].xyz) * lineScale * projectionMatrix[1][1] / gl_Position.w;`,
    },
  ],
  fragment: [
    ...BRANCH_STANDARD.fragment,
    { anchor: '#include <fog_pars_fragment>', before: lineFragment },
    { anchor: '#include <clipping_planes_fragment>', before: 'if (lineGap()) discard;' },
  ],
};

/** Where a point gets its size; one that is not drawn leaves the picture. In a shadow map `normalMatrix` is still that of the last picture's eye. */
const pointSize: readonly Patch[] = [
  { anchor: '#include <clipping_planes_pars_vertex>', before: pointVertex },
  {
    anchor: '#include <project_vertex>',
    after: `gl_PointSize = leafPointSize(mvPosition.xyz, normalize(mat3(modelViewMatrix) * here.normal), gl_Position.w, gl_InstanceID * leafRange.y + int(blade.z), here.own);
if (gl_PointSize == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);`,
  },
];

const pointRound: readonly Patch[] = [
  {
    anchor: '#include <clipping_planes_pars_fragment>',
    before: 'flat in float vLeafFront;\nflat in float vLeafRound;',
  },
  {
    anchor: '#include <clipping_planes_fragment>',
    before: 'if (vLeafRound > 0.5 && length(gl_PointCoord - 0.5) > 0.5) discard;',
  },
];

/** Points have no sides: the vertex says which face of the leaf is seen. */
const faced = (patch: Patch): Patch =>
  patch.after?.includes('gl_FrontFacing')
    ? { ...patch, after: patch.after.replace('gl_FrontFacing', 'vLeafFront > 0.5') }
    : patch;

/** For MeshStandardMaterial on points. */
export const LEAF_POINT: Injection = {
  vertex: [...LEAF_STANDARD.vertex, ...pointSize],
  fragment: [...LEAF_STANDARD.fragment.map(faced), ...pointRound],
};

/** For MeshDepthMaterial and MeshDistanceMaterial on points. */
export const LEAF_POINT_DEPTH: Injection = { vertex: [...LEAF_DEPTH.vertex, ...pointSize], fragment: pointRound };
