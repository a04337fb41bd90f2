import { html, type TemplateResult } from 'lit';
import { fileName } from '../../core/io/export-tree.ts';
import { takePng } from '../export/png.ts';
import '../styles/photo.css';
import { choice } from '../ui/choice.ts';
import { icon } from '../ui/icons.ts';
import { Part } from '../ui/panel.ts';
import { photoWords } from '../words/scene.ts';
import { ASPECTS, type Aspect, type Frame, frameIn, pictureSize } from './photo-frame.ts';

/** The picture alone, in a thin frame, with a shutter: what is in the frame becomes a PNG. */
class PhotoMode extends Part {
  static override properties = { ...Part.properties, aspect: { state: true }, taking: { state: true } };
  declare aspect: Aspect;
  declare taking: boolean;
  private readonly onResize = (): void => this.requestUpdate();

  constructor() {
    super();
    this.aspect = 'free';
    this.taking = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('resize', this.onResize);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>('.shutter')?.focus());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('resize', this.onResize);
  }

  private get frame(): Frame {
    return frameIn(window.innerWidth, window.innerHeight, this.aspect);
  }

  protected override updated(): void {
    // The page keeps the tree within the frame.
    this.dispatchEvent(new Event('photo-frame', { bubbles: true }));
  }

  protected override render(): TemplateResult {
    const { left, top, width, height } = this.frame;
    return html`<div class="photo-frame" style="left:${left}px;top:${top}px;width:${width}px;height:${height}px"></div>
      <section class="photo-bar paper" aria-label=${photoWords.title}>
        ${choice({
          name: 'aspect',
          legend: photoWords.aspect,
          quiet: true,
          value: this.aspect,
          options: ASPECTS.map((value) => ({ value, label: photoWords.aspects[value] })),
          onChoose: (aspect) => {
            this.aspect = aspect;
          },
        })}
        <button type="button" class="shutter" aria-label=${this.taking ? photoWords.taking : photoWords.shutter}
          title=${photoWords.shutter} aria-disabled=${this.taking} @click=${this.take}></button>
        <button type="button" class="quiet" @click=${() => this.editor.actions.setPhoto(false)}>
          ${icon('close')}<span class="wide-only">${photoWords.leave}</span></button>
      </section>`;
  }

  private readonly take = async (): Promise<void> => {
    if (this.taking) return;
    const { actions, picture } = this.editor;
    const { tree } = this.session;
    this.taking = true;
    actions.say(photoWords.taking);
    try {
      const size = pictureSize(this.frame, window.devicePixelRatio);
      const capture = await picture.openCapture({ ...size, transparent: false });
      try {
        const png = await takePng(capture, actions.time(), new AbortController().signal);
        const name = fileName(tree?.species.name ?? '', tree?.seed ?? 0);
        actions.saveFile(`${name}-${size.width}x${size.height}.png`, png);
        actions.say(photoWords.taken);
      } finally {
        capture.close();
      }
    } catch (error) {
      actions.notify('error', photoWords.failed, [error instanceof Error ? error.message : String(error)]);
    } finally {
      this.taking = false;
    }
  };
}

customElements.define('wg-photo', PhotoMode);
