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

/** `source` with the patches applied. Throws Error naming the anchor that is not there exactly once: another three. */
export function patched(source: string, patches: readonly Patch[]): string {
  return patches.reduce((text, { anchor, before = '', instead = anchor, after = '' }) => {
    const parts = text.split(anchor);
    if (parts.length !== 2) throw new Error(`shader anchor ${anchor} found ${parts.length - 1} times, not once`);
    return `${parts[0]}${before}\n${instead}\n${after}${parts[1]}`;
  }, source);
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
