/** A small tree as Arbaro writes one; made for these tests. */
export const ARBARO = `<?xml version='1.0' ?>
<arbaro>
 <species name='test_tree'>
    <!-- general params -->
    <param name='Shape' value='7'/>
    <param name='Levels' value='3'/>
    <param name='Scale' value='12'/>
    <param name='ScaleV' value='2'/>
    <param name='BaseSize' value='0.3'/>
    <param name='Ratio' value='0.02'/>
    <param name='RatioPower' value='1.2'/>
    <param name='Flare' value='0.6'/>
    <param name='Leaves' value='20'/>
    <param name='LeafShape' value='oval'/>
    <param name='LeafScale' value='0.2'/>
    <param name='0Length' value='1'/>
    <param name='0CurveRes' value='4'/>
    <param name='1DownAngle' value='55'/>
    <param name='1Branches' value='30'/>
    <param name='1Length' value='0.35'/>
    <param name='2DownAngle' value='45'/>
    <param name='2Branches' value='15'/>
 </species>
</arbaro>
`;

/** A small tree as ez-tree's page saves one; made for these tests. */
export const EZ_TREE = JSON.stringify(
  {
    seed: 4242,
    type: 'deciduous',
    bark: { type: 'oak', tint: 13416118, flatShading: false, textured: true, textureScale: { x: 0.5, y: 5 } },
    branch: {
      levels: 3,
      angle: { 1: 50, 2: 60, 3: 45 },
      children: { 0: 7, 1: 4, 2: 3 },
      force: { direction: { x: 0, y: 1, z: 0 }, strength: 0.01 },
      gnarliness: { 0: 0.05, 1: 0.1, 2: 0.2, 3: 0.1 },
      length: { 0: 30, 1: 15, 2: 10, 3: 4 },
      radius: { 0: 1.2, 1: 0.6, 2: 0.7, 3: 0.7 },
      sections: { 0: 12, 1: 10, 2: 8, 3: 6 },
      segments: { 0: 8, 1: 6, 2: 4, 3: 3 },
      start: { 1: 0.4, 2: 0.3, 3: 0.1 },
      taper: { 0: 0.7, 1: 0.7, 2: 0.7, 3: 0.7 },
      twist: { 0: 0.1, 1: -0.05, 2: 0, 3: 0 },
    },
    leaves: {
      type: 'oak',
      billboard: 'double',
      angle: 20,
      count: 12,
      start: 0.1,
      size: 2,
      sizeVariance: 0.6,
      tint: 16777215,
      alphaTest: 0.5,
    },
  },
  null,
  2,
);
