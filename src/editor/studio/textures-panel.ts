import { html, nothing, type TemplateResult } from 'lit';
import { POSE_TARGETS } from '../../core/pack/layout.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { placeOfPiece } from '../../core/wind/probe-place.ts';
import type { TextureImages, TextureLayer } from '../../view/picture/picture.ts';
import { choice } from '../ui/choice.ts';
import { placeText } from '../words/probe.ts';
import { textureWords } from '../words/studio-panels.ts';
import { onTheme, plotColours } from './plot-colours.ts';
import { StudioPart } from './studio-part.ts';
import type { StudioState } from './studio-state.ts';
import { TexelCanvas } from './texel-canvas.ts';
import { amounts, pieceAt, type TexelView, texelText, wordsOf } from './texel-image.ts';
import { threeDigits } from './units.ts';

/** Milliseconds from one reading of the GPU's textures to the next, and from one look for the branch under the pointer to the next. */
const READ_EVERY = 200;
const PICK_EVERY = 80;

/** The textures in which the GPU keeps the tree's state, as images: every texel is a piece of a branch. */
class TexturesPanel extends StudioPart {
  static override properties = {
    ...StudioPart.properties,
    layer: { state: true },
    view: { state: true },
    images: { state: true },
    failed: { state: true },
  };
  declare layer: TextureLayer['id'];
  declare view: TexelView;
  declare images: TextureImages | null;
  declare failed: boolean;
  private canvas: TexelCanvas | null = null;
  private reading = false;
  private last = 0;
  private picked = 0;
  private ends: (() => void)[] = [];
  private readonly onBranch = (event: PointerEvent): void => this.pointAtBranch(event);

  constructor() {
    super();
    this.layer = 'P3';
    this.view = 'much';
    this.images = null;
    this.failed = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const { canvas } = this.studio.picture;
    canvas.addEventListener('pointermove', this.onBranch);
    this.ends = [
      () => canvas.removeEventListener('pointermove', this.onBranch),
      this.editor.onFrame(() => this.read()),
      onTheme(() => this.requestUpdate()),
    ];
    this.read();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const end of this.ends) end();
    this.canvas = null;
    this.editor.actions.setHighlight(null);
  }

  protected override answers(now: StudioState, before: StudioState): boolean {
    return now.place !== before.place;
  }

  protected override render(): TemplateResult {
    const { images } = this;
    if (this.failed) return html`<p class="studio-empty">${textureWords.none}</p>`;
    if (!images) return html`<p class="studio-empty">${textureWords.reading}</p>`;
    const layer = this.shown(images);
    return html`<div class="texel-side">
        ${choice({
          name: 'texture',
          legend: textureWords.texture,
          value: layer.id,
          options: images.layers.map(({ id, label, unit }) => ({ value: id, label: id, title: `${label}, ${unit}` })),
          onChoose: (id) => {
            this.layer = id;
          },
        })}
        <p class="soft">${layer.label}</p>
        ${choice({
          name: 'texel-view',
          legend: textureWords.show,
          value: this.view,
          options: [
            { value: 'much', label: wordsOf(layer.id).much },
            { value: 'colours', label: textureWords.colours },
          ],
          onChoose: (view) => {
            this.view = view;
          },
        })}
        <p class="soft">${textureWords.size(images.width, images.height, images.pieceCount)}</p>
      </div>
      <div class="texel-image">
        <canvas tabindex="0" role="application" aria-describedby="texel-values" aria-label=${textureWords.image(layer.id)}
          @pointermove=${this.onMove} @pointerleave=${this.onLeave} @click=${this.onClick} @keydown=${this.onKey}></canvas>
      </div>
      ${this.values(images, layer)}`;
  }

  private values(images: TextureImages, layer: TextureLayer): TemplateResult {
    const { highlight } = this.session;
    const { tree, index } = this.studio;
    const piece = highlight !== null && highlight < images.pieceCount ? highlight : null;
    return html`<div class="texel-values" id="texel-values">${
      piece === null || !tree || !index
        ? html`<p class="soft">${textureWords.point}</p>`
        : html`<p><strong>${textureWords.piece(piece)}</strong> <span class="chip" data-level=${Math.min(3, index.level[piece]!)}></span> ${textureWords.level(index.level[piece]!)}<br>
            <span class="soft">${placeText(placeOfPiece(tree, index, piece))}</span></p>
          <dl class="figures">${texelText(layer, piece).map(
            ({ name, value, unit }) =>
              html`<div><dt>${name}</dt><dd>${value}${unit ? html`<span class="unit">${unit}</span>` : nothing}</dd></div>`,
          )}</dl>`
    }
      ${this.view === 'much' ? this.scale(images, layer) : html`<p class="soft">${textureWords.coloursSay}</p>`}
    </div>`;
  }

  private scale(images: TextureImages, layer: TextureLayer): TemplateResult {
    const { much, muchUnit, colour } = wordsOf(layer.id);
    const most = this.amounts(images, layer).reduce((a, b) => Math.max(a, b), 0);
    return html`<figure class="texel-scale"><figcaption>${much}</figcaption>
      <div class="ramp" style="background: linear-gradient(to right, var(--paper), var(--${colour}))"></div>
      <div class="ends"><span>0</span><span>${threeDigits(most / 4)}</span><span>${threeDigits(most)}\u2009${muchUnit}</span></div></figure>`;
  }

  protected override updated(): void {
    const { images } = this;
    const element = this.querySelector<HTMLCanvasElement>('.texel-image canvas');
    if (!images || !element) return;
    if (this.canvas?.element !== element) this.canvas = new TexelCanvas(element);
    const layer = this.shown(images);
    const colours = plotColours();
    if (this.view === 'colours') this.canvas.paintColours(images, layer);
    else
      this.canvas.paintAmounts(images, this.amounts(images, layer), colours.paper, colours[wordsOf(layer.id).colour]);
    this.canvas.mark(this.session.highlight, this.state.place?.piece ?? null, colours);
  }

  private shown(images: TextureImages): TextureLayer {
    return images.layers.find(({ id }) => id === this.layer) ?? images.layers[images.layers.length - 1]!;
  }

  private amounts(images: TextureImages, layer: TextureLayer): Float32Array {
    const { tree } = this.studio;
    const target = { P0: POSE_TARGETS.P0, P1: POSE_TARGETS.P1, P2: POSE_TARGETS.P2, P3: POSE_TARGETS.P3 }[
      layer.id as 'P0'
    ];
    const rest =
      tree && target !== undefined && tree.pieceCount === images.pieceCount
        ? tree.restPose.data.subarray(layerStart(tree.restPose, target))
        : null;
    return amounts(layer, images.pieceCount, rest);
  }

  private read(): void {
    const now = performance.now();
    if (this.reading || now - this.last < READ_EVERY) return;
    this.last = now;
    this.reading = true;
    const side = this.session.side === 'B' && this.doc.compare ? 'B' : 'A';
    void this.studio.picture
      .readTextures(side)
      .then((images) => {
        this.failed = false;
        this.images = images;
      })
      .catch(() => {
        this.failed = this.images === null;
      })
      .finally(() => {
        this.reading = false;
      });
  }

  private pieceOf(event: MouseEvent): number | null {
    const { images } = this;
    if (!images) return null;
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * images.width;
    const y = ((event.clientY - box.top) / box.height) * images.height;
    return pieceAt(images, x, y);
  }

  private onMove(event: PointerEvent): void {
    this.editor.actions.setHighlight(this.pieceOf(event));
  }

  private onLeave(): void {
    this.editor.actions.setHighlight(null);
  }

  private onClick(event: MouseEvent): void {
    const piece = this.pieceOf(event);
    if (piece !== null) this.editor.actions.setProbe(piece);
  }

  private onKey(event: KeyboardEvent): void {
    const { images } = this;
    if (!images) return;
    const now = this.session.highlight ?? this.state.place?.piece ?? 0;
    if (event.key === 'Enter') {
      event.preventDefault();
      this.editor.actions.setProbe(now);
      return;
    }
    const by = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -images.width, ArrowDown: images.width }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const next = Math.min(images.pieceCount - 1, Math.max(0, now + by));
    this.editor.actions.setHighlight(next);
    const { tree, index } = this.studio;
    if (tree && index) this.editor.actions.say(textureWords.said(next, placeText(placeOfPiece(tree, index, next))));
  }

  /** The branch under the pointer in the picture marks its texel. */
  private pointAtBranch(event: PointerEvent): void {
    if (event.buttons !== 0 || event.timeStamp - this.picked < PICK_EVERY) return;
    this.picked = event.timeStamp;
    this.editor.actions.setHighlight(this.studio.picture.pickPiece(event.clientX, event.clientY));
  }
}

customElements.define('wg-studio-textures', TexturesPanel);
