/** A tree file as Arbaro's programs write them, with numbers of our own: a small round tree of three levels. */
export const ARBARO = `<?xml version='1.0' ?>
<!-- a tree of our own -->
<arbaro>
  <species name='Garden apple'>
    <param name='Shape' value='1'/>
    <param name='Levels' value='3'/>
    <param name='Scale' value='5.5'/>
    <param name='ScaleV' value='0.5'/>
    <param name='BaseSize' value='0.25'/>
    <param name='Ratio' value='0.025'/>
    <param name='RatioPower' value='1.3'/>
    <param name='Flare' value='0.4'/>
    <param name='Lobes' value='3'/>
    <param name='LobeDepth' value='0.05'/>
    <param name='Smooth' value='0.5'/>
    <param name='Leaves' value='12'/>
    <param name='LeafShape' value='0'/>
    <param name='LeafScale' value='0.09'/>
    <param name='LeafScaleX' value='0.7'/>
    <param name='LeafQuality' value='1'/>
    <param name='LeafStemLen' value='0.4'/>
    <param name='LeafDistrib' value='4'/>
    <param name='LeafBend' value='0.2'/>
    <param name='AttractionUp' value='0.3'/>
    <param name='PruneRatio' value='0'/>
    <param name='PruneWidth' value='0.5'/>
    <param name='PruneWidthPeak' value='0.5'/>
    <param name='PrunePowerLow' value='0.5'/>
    <param name='PrunePowerHigh' value='0.5'/>
    <param name='0Scale' value='1'/>
    <param name='0ScaleV' value='0.1'/>
    <param name='0BaseSplits' value='1'/>
    <param name='0Length' value='0.9'/>
    <param name='0LengthV' value='0'/>
    <param name='0Taper' value='1'/>
    <param name='0SegSplits' value='0.2'/>
    <param name='0SplitAngle' value='12'/>
    <param name='0SplitAngleV' value='3'/>
    <param name='0CurveRes' value='6'/>
    <param name='0Curve' value='5'/>
    <param name='0CurveBack' value='0'/>
    <param name='0CurveV' value='60'/>
    <param name='0DownAngle' value='0'/>
    <param name='0Branches' value='1'/>
    <param name='1DownAngle' value='55'/>
    <param name='1DownAngleV' value='-20'/>
    <param name='1Rotate' value='140'/>
    <param name='1RotateV' value='10'/>
    <param name='1Branches' value='22'/>
    <param name='1BranchDist' value='0'/>
    <param name='1Length' value='0.45'/>
    <param name='1LengthV' value='0.05'/>
    <param name='1Taper' value='1'/>
    <param name='1CurveRes' value='7'/>
    <param name='1Curve' value='-25'/>
    <param name='1CurveV' value='70'/>
    <param name='2DownAngle' value='40'/>
    <param name='2Rotate' value='137'/>
    <param name='2Branches' value='14'/>
    <param name='2Length' value='0.35'/>
    <param name='2Taper' value='1'/>
    <param name='2CurveRes' value='4'/>
    <param name='2CurveV' value='50'/>
    <param name='3DownAngle' value='45'/>
    <param name='3Rotate' value='77'/>
  </species>
</arbaro>
`;

/** As it stands, with one change of its text. */
export const arbaroWith = (from: string | RegExp, to: string): string => ARBARO.replace(from, to);

/** A tree as ez-tree's application saves it, with numbers of our own. */
export const EZ_TREE = {
  seed: 4711,
  type: 'deciduous',
  bark: { type: 'birch', tint: 0xfff4e0, flatShading: false, textured: true, textureScale: { x: 1, y: 2 } },
  branch: {
    levels: 2,
    angle: { 1: 48, 2: 52, 3: 60 },
    children: { 0: 9, 1: 5, 2: 3 },
    force: { direction: { x: 0, y: 1, z: 0 }, strength: 0.008 },
    gnarliness: { 0: 0.03, 1: 0.12, 2: 0.15, 3: 0.02 },
    length: { 0: 34, 1: 14, 2: 8, 3: 1 },
    radius: { 0: 1.1, 1: 0.6, 2: 0.65, 3: 0.7 },
    sections: { 0: 11, 1: 9, 2: 7, 3: 5 },
    segments: { 0: 8, 1: 6, 2: 4, 3: 3 },
    start: { 1: 0.45, 2: 0.2, 3: 0.3 },
    taper: { 0: 0.75, 1: 0.7, 2: 0.7, 3: 0.7 },
    twist: { 0: 0.1, 1: 0, 2: 0, 3: 0 },
  },
  leaves: {
    type: 'aspen',
    billboard: 'double',
    angle: 40,
    count: 8,
    start: 0.1,
    size: 2.2,
    sizeVariance: 0.5,
    tint: 0xe8ffd0,
    alphaTest: 0.5,
  },
  trellis: { enabled: false },
};
