import { html, type TemplateResult } from 'lit';
import { fileName } from '../../core/io/export-tree.ts';
import { takePng } from '../export/png.ts';
import '../styles/photo.css';
import { choice } from '../ui/choice.ts';
import { icon } from '../ui/icons.ts';
import { Part } from '../ui/panel.ts';
import { photoWords } from '../words/scene.ts';
import { ownFocalLength } from './focal-length.ts';
import { photoControls } from './photo-controls.ts';
import { ASPECTS, type Frame, frameIn, pictureSize } from './photo-frame.ts';
import { NO_SETTINGS, type PhotoSettings, shotOf } from './photo-settings.ts';

/** As they were left: who comes back goes on with them. */
let last = NO_SETTINGS;

/** Pixels between the bar and what is around it, above and below. */
const AROUND = 24;

/** The picture alone, in a thin frame, with exposure, lens and a shutter: what is in the frame becomes a PNG. */
class PhotoMode extends Part {
  static override properties = {
    ...Part.properties,
    settings: { state: true },
    taking: { state: true },
    foot: { state: true },
  };
  declare settings: PhotoSettings;
  declare taking: boolean;
  /** Pixels of the window's height that the bar takes. */
  declare foot: number;
  private readonly onResize = (): void => this.requestUpdate();
  /** What the picture was told last. */
  private told = '';

  constructor() {
    super();
    this.settings = last;
    this.taking = false;
    this.foot = 0;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('resize', this.onResize);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>('.shutter')?.focus());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('resize', this.onResize);
    this.editor.picture.setShot?.(null);
  }

  private get frame(): Frame {
    return frameIn(window.innerWidth, window.innerHeight, this.settings.aspect, this.foot);
  }

  private get own(): number {
    return ownFocalLength(this.frame, window.innerHeight);
  }

  protected override updated(): void {
    this.foot = AROUND + (this.querySelector<HTMLElement>('.photo-bar')?.offsetHeight ?? 0);
    // The page keeps the tree within the frame.
    this.dispatchEvent(new Event('photo-frame', { bubbles: true }));
    const told = JSON.stringify([this.settings, this.own]);
    if (told !== this.told) this.editor.picture.setShot?.(shotOf(this.settings, this.own));
    this.told = told;
  }

  private readonly set = (change: Partial<PhotoSettings>): void => {
    last = { ...this.settings, ...change };
    this.settings = last;
  };

  protected override render(): TemplateResult {
    const { left, top, width, height } = this.frame;
    const { aspect, thirds } = this.settings;
    return html`<div class="photo-frame" ?data-thirds=${thirds}
        style="left:${left}px;top:${top}px;width:${width}px;height:${height}px"></div>
      <section class="photo-bar paper" aria-label=${photoWords.title}>
        ${this.editor.picture.setShot ? html`<div class="photo-controls">${photoControls(this.settings, this.own, this.set)}</div>` : ''}
        <div class="photo-row">
        ${choice({
          name: 'aspect',
          legend: photoWords.aspect,
          quiet: true,
          value: aspect,
          options: ASPECTS.map((value) => ({ value, label: photoWords.aspects[value] })),
          onChoose: (next) => this.set({ aspect: next }),
        })}
        <button type="button" class="shutter" aria-label=${this.taking ? photoWords.taking : photoWords.shutter}
          title=${photoWords.shutter} aria-disabled=${this.taking} @click=${this.take}></button>
        <button type="button" class="quiet" @click=${() => this.editor.actions.setPhoto(false)}>
          ${icon('close')}<span class="wide-only">${photoWords.leave}</span></button>
        </div>
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
      // From where it is seen now, or a tree that fills its frame would be framed anew for the picture.
      const { camera } = picture;
      const shot = shotOf(this.settings, this.own);
      const capture = await picture.openCapture({ ...size, transparent: false, camera, shot });
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
