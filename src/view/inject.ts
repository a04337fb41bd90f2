import type { IUniform, Material } from 'three';

/** One change of a stock shader: text put at an anchor, or in its place. */
export interface Patch {
  /** A line of the stock shader, such as '#include <begin_vertex>'. */
  readonly anchor: string;
  readonly before?: string;
  readonly instead?: string;
  readonly after?: string;
}

/** The patches of one material. */
export interface Injection {
  readonly vertex: readonly Patch[];
  readonly fragment: readonly Patch[];
}

/** Shader code that most materials never need, by the name of the pragma that it stands in for. */
const parts = new Map<string, string>();

/** Puts `text` in place of each `#pragma name` of what is compiled from now on: code that travels only with those who need it. */
export function providePart(name: string, text: string): void {
  parts.set(name, text);
}

/** `source` with the patches applied. Throws Error naming the anchor that is not there exactly once: another three. */
export function patched(source: string, patches: readonly Patch[]): string {
  const whole = patches.reduce((text, { anchor, before = '', instead = anchor, after = '' }) => {
    const around = text.split(anchor);
    if (around.length !== 2) throw new Error(`shader anchor ${anchor} found ${around.length - 1} times, not once`);
    return `${around[0]}${before}\n${instead}\n${after}${around[1]}`;
  }, source);
  // A pragma that nobody knows is no fault: compilers pass over it.
  return whole.replace(/^#pragma (\w+)$/gm, (line, name: string) => parts.get(name) ?? line);
}

/**
 * Makes a stock material run the patches; programs are shared between materials of the same `key` and defines.
 *
 * The uniform objects are handed over as they are, so whoever holds them changes the material.
 */
export function inject(
  material: Material,
  key: string,
  injection: Injection,
  uniforms: Record<string, IUniform>,
): void {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = patched(shader.vertexShader, injection.vertex);
    shader.fragmentShader = patched(shader.fragmentShader, injection.fragment);
  };
  material.customProgramCacheKey = () => key;
}
