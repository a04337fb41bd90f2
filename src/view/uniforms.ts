import {
  Color,
  type Data3DTexture,
  type DataArrayTexture,
  type DataTexture,
  type Texture,
  Vector2,
  Vector3,
  Vector4,
} from 'three';

/** The uniforms that all materials of one tree share; the objects live as long as the WindTree, their values change. */
export function sharedUniforms() {
  return {
    poseEven: { value: [] as Texture[] },
    poseOdd: { value: [] as Texture[] },
    poseLog2Width: { value: 0 },
    branches: { value: null as DataArrayTexture | null },
    branchLog2Width: { value: 0 },
    leaves: { value: null as DataArrayTexture | null },
    leafLog2Width: { value: 0 },
    crownCentre: { value: new Vector3() },
    crownRadii: { value: new Vector3(1, 1, 1) },
    crownLight: { value: null as Data3DTexture | null },
    crownLow: { value: new Vector3() },
    crownSize: { value: new Vector3(1, 1, 1) },
  };
}

/** What the materials of a grove have besides: its trees, and how they fade. */
export function groveUniforms() {
  return {
    trees: { value: null as DataArrayTexture | null },
    treeLog2Width: { value: 0 },
    forestEye: { value: new Vector3() },
    forestScale: { value: 1 },
    forestFade: { value: new Vector4(-1, 0, 1e9, 2e9) },
  };
}

/** The uniforms of the bark. */
export function barkUniforms() {
  return {
    barkMap: { value: null as DataTexture | null },
    barkGrowth: { value: null as DataTexture | null },
    barkTile: { value: new Vector4(1, 0, 0, 0) },
    barkColour: { value: new Color() },
    barkDark: { value: new Color() },
    barkTwig: { value: new Color() },
    barkYoung: { value: 0.035 },
    barkRelief: { value: 0 },
    barkMoss: { value: new Vector4() },
    barkLichen: { value: new Vector4() },
  };
}

/** The uniforms of one level of stems. */
export function levelUniforms() {
  return {
    branchRange: { value: new Vector3() },
    stemGrowth: { value: 1 },
    stemShape: { value: [new Vector4(), new Vector4()] },
    levelTint: { value: new Vector4(0, 0, 0, 0) },
    barkDepth: { value: new Vector2() },
    gridMorph: { value: new Vector4(0, 1, 1, 0) },
  };
}

/** The uniforms of the leaves. */
export function leafUniforms() {
  return {
    leafRange: { value: new Vector2() },
    leafSize: { value: new Vector2(1, 1) },
    leafFlutter: { value: new Vector2() },
    leafWind: { value: new Vector2() },
    crownRounding: { value: 0.5 },
    leafColour: { value: new Color() },
    leafUnder: { value: new Color() },
    leafGlow: { value: new Color() },
    leafSecond: { value: new Color() },
    leafTurned: { value: 0 },
    leafVariation: { value: 0 },
    leafThin: { value: 1 },
    leafVeins: { value: new Vector2() },
    leafLobes: { value: [new Vector2(), new Vector2(), new Vector2()] },
    leafHang: { value: 0 },
    levelTint: { value: new Vector4(0, 0, 0, 0) },
  };
}

export type SharedUniforms = ReturnType<typeof sharedUniforms>;
export type GroveUniforms = ReturnType<typeof groveUniforms>;
export type BarkUniforms = ReturnType<typeof barkUniforms>;
export type LevelUniforms = ReturnType<typeof levelUniforms>;
export type LeafUniforms = ReturnType<typeof leafUniforms>;
