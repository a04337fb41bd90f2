import { Color, DoubleSide, GLSL3, GreaterDepth, type IUniform, LessEqualDepth, ShaderMaterial, Vector2 } from 'three';

/** Colours by meaning (force, answer) and of the page, as they stand on screen: what is drawn over the scene takes no light. */
const COLOURS = {
  light: { force: '#1f6feb', glow: '#dcebff', answer: '#1a7f37', paper: '#fbfaf6', ink: '#1d2021' },
  dark: { force: '#6cb2ff', glow: '#cfe5ff', answer: '#56d364', paper: '#10151a', ink: '#e6e9ea' },
} as const;

/** The uniforms that all overlays share; their shaders work in sRGB. */
export function overlayUniforms() {
  return {
    overlayPixels: { value: new Vector2(1, 1) },
    forceColour: { value: new Color() },
    forceGlow: { value: new Color() },
    answerColour: { value: new Color() },
    paperColour: { value: new Color() },
    inkColour: { value: new Color() },
  };
}

export type OverlayUniforms = ReturnType<typeof overlayUniforms>;

/** Sets the colours of a theme. */
export function setOverlayColours(uniforms: OverlayUniforms, dark: boolean): void {
  const { force, glow, answer, paper, ink } = COLOURS[dark ? 'dark' : 'light'];
  for (const [uniform, colour] of [
    [uniforms.forceColour, force],
    [uniforms.forceGlow, glow],
    [uniforms.answerColour, answer],
    [uniforms.paperColour, paper],
    [uniforms.inkColour, ink],
  ] as const) {
    uniform.value.set(colour).convertLinearToSRGB();
  }
}

/** Where a mark is drawn: before what stands behind it, or as a faint ghost where something hides it. */
export type Layer = 'seen' | 'hidden';

/** How much of a mark shows through what hides it. */
const GHOST = 0.28;

/** A material for what is drawn over the scene: blended, in the colours of the screen, without a trace in the depth buffer; `ghost`: how much shows through what hides it. */
export function overlayMaterial(
  vertexShader: string,
  fragmentShader: string,
  uniforms: Record<string, IUniform>,
  layer: Layer = 'seen',
  ghost = GHOST,
): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: { ...uniforms, overlayAlpha: { value: layer === 'seen' ? 1 : ghost } },
    side: DoubleSide,
    transparent: true,
    depthWrite: false,
    depthFunc: layer === 'seen' ? LessEqualDepth : GreaterDepth,
    fog: false,
    toneMapped: false,
  });
}
