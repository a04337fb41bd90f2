import type { WebGLRenderer, WebGLRenderTarget } from 'three';

/**
 * The settings of a renderer that a pass changes, to be put back afterwards.
 *
 * Viewport and scissor of the canvas need no saving: drawing into a target uses the target's own. One object is made per
 * pass and used again, so that a frame allocates nothing.
 */
export class PassState {
  #target: WebGLRenderTarget | null = null;
  #face = 0;
  #mip = 0;
  #autoClear = true;
  #xr = false;
  #shadows = true;
  #autoReset = true;
  #calls = 0;
  #triangles = 0;

  /** Notes the settings of `renderer` and sets those of a pass. */
  begin(renderer: WebGLRenderer): void {
    this.#target = renderer.getRenderTarget();
    this.#face = renderer.getActiveCubeFace();
    this.#mip = renderer.getActiveMipmapLevel();
    this.#autoClear = renderer.autoClear;
    this.#xr = renderer.xr.enabled;
    this.#shadows = renderer.shadowMap.autoUpdate;
    this.#autoReset = renderer.info.autoReset;
    this.#calls = renderer.info.render.calls;
    this.#triangles = renderer.info.render.triangles;
    renderer.autoClear = false; // a clear would wipe the texels that this draw does not write
    renderer.xr.enabled = false; // else the camera of the headset and its target are used
    renderer.shadowMap.autoUpdate = false;
    renderer.info.autoReset = false;
  }

  /** Puts the settings back. The pass's draws are not counted: `info` tells of the picture. */
  end(renderer: WebGLRenderer): void {
    renderer.autoClear = this.#autoClear;
    renderer.xr.enabled = this.#xr;
    renderer.shadowMap.autoUpdate = this.#shadows;
    renderer.info.autoReset = this.#autoReset;
    renderer.info.render.calls = this.#calls;
    renderer.info.render.triangles = this.#triangles;
    renderer.setRenderTarget(this.#target, this.#face, this.#mip);
    this.#target = null;
  }
}
