import { Pace } from './pace.ts';
import {
  QUALITY_SETTINGS,
  type Quality,
  type QualityLevel,
  QualityMeter,
  type QualitySettings,
  USUAL,
} from './quality.ts';

/** How finely a picture is drawn at the moment: as the reader wants it, and on a slow machine less while things move. */
export class Fineness {
  /** What the reader chose. */
  quality: Quality = 'auto';
  readonly #pace = new Pace();
  readonly #meter = new QualityMeter();
  #hurried = false;
  #scale = 1;
  #level: QualityLevel = USUAL;

  /** Part of the pixels in each direction that is drawn. */
  get scale(): number {
    return this.#scale;
  }

  get level(): QualityLevel {
    return this.#level;
  }

  get settings(): QualitySettings {
    return QUALITY_SETTINGS[this.#level];
  }

  /** Pixels of the screen to each of the page. */
  get pixelRatio(): number {
    return Math.min(this.settings.pixelRatio, window.devicePixelRatio) * this.#scale;
  }

  /** A frame follows the last after `passed` milliseconds; `hurried`: another follows at once. Tells what is another than before. */
  frame(hurried: boolean, passed: number): { readonly scale: boolean; readonly level: boolean } {
    if (hurried && this.#hurried) {
      this.#pace.frame(passed);
      this.#meter.frame(passed);
    } else {
      this.#pace.restart();
      this.#meter.restart();
    }
    this.#hurried = hurried;
    // What stands is drawn in full, and by `auto` always the same: a link shows what it showed.
    const scale = hurried ? this.#pace.scale : 1;
    const level = this.quality !== 'auto' ? this.quality : hurried ? this.#meter.level : USUAL;
    const changed = { scale: scale !== this.#scale, level: level !== this.#level };
    this.#scale = scale;
    this.#level = level;
    return changed;
  }
}
