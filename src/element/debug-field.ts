import type { BareStage } from '../view/bare-stage.ts';
import { Arrows } from '../view/overlay/arrows.ts';
import { overlayUniforms, setOverlayColours } from '../view/overlay/overlay-material.ts';

/** Arrows of the wind's force over the ground, on the stage that the elements share. */
export class DebugField {
  readonly #uniforms = overlayUniforms();
  readonly #arrows: Arrows;

  constructor(stage: BareStage) {
    this.#arrows = new Arrows(this.#uniforms, stage.field);
    this.#arrows.rotation.x = -Math.PI / 2; // z up to y up
    this.#arrows.visible = false;
    stage.scene.add(this.#arrows);
  }

  /** Shows them in the next picture, of this size in CSS pixels, for a tree of this reach in metres. */
  show(dark: boolean, reach: number, width: number, height: number): void {
    this.#uniforms.overlayPixels.value.set(width, height);
    setOverlayColours(this.#uniforms, dark);
    this.#arrows.fit(reach);
    this.#arrows.update();
    this.#arrows.visible = true;
  }

  hide(): void {
    this.#arrows.visible = false;
  }

  dispose(): void {
    this.#arrows.removeFromParent();
    this.#arrows.dispose();
  }
}
