import type { Control, DraggedNumber, Value, Values } from './controls.ts';
import type { Colours } from './figure-colours.ts';
import type { Handle } from './handle.ts';
import { LivePage } from './live-page.ts';
import { MountedFigure } from './mounted-figure.ts';

export {
  type Control,
  choiceOf,
  numberOf,
  switchOf,
  type Value,
  type Values,
} from './controls.ts';
export type { Colours } from './figure-colours.ts';
export type { Handle } from './handle.ts';

/** A number, or a word, that a figure tells beside its picture. */
export interface Readout {
  readonly id: string;
  readonly label: string;
  readonly unit?: string;
}

/** A figure that lives: a stage, at most three controls, numbers that follow. */
export interface FigureSpec {
  /** That of `<figure data-figure>`. */
  readonly id: string;
  readonly title: string;
  /** Width / height of the stage. */
  readonly aspect: number;
  /** The same on a narrow screen; default `aspect`, or 5 : 4 where that is flatter. */
  readonly narrow?: number;
  readonly controls: readonly Control[];
  /** What is dragged in the stage and has no row among the controls. */
  readonly dragged?: readonly DraggedNumber[];
  readonly readouts: readonly Readout[];
  /** It moves by itself: gets a button to play and pause; under reduced motion it begins paused. */
  readonly moves?: boolean;
  /** Gets a button that stops its time and makes one step. */
  readonly steps?: boolean;
  /** Seconds at which its time begins; default 0. */
  readonly begin?: number;
  /** What stands behind `#` in the editor's address, for "Open in editor". */
  readonly open?: (values: Values) => string;
  /** Another page of the site that shows the same; `address` begins at the site's root. */
  readonly page?: { readonly name: string; readonly address: (values: Values) => string };
  /** Called once the figure comes near the window. What it throws is told in the figure's place. */
  readonly stage: (host: FigureHost) => FigureStage;
}

/** What a stage draws on, and whom it asks. */
export interface FigureHost {
  /** Its bitmap has `pixelRatio` pixels to a CSS pixel; sized before each `draw`. */
  readonly canvas: HTMLCanvasElement;
  /** CSS pixels. */
  readonly size: { readonly width: number; readonly height: number };
  readonly pixelRatio: number;
  /** True in the dark theme. */
  readonly dark: boolean;
  values(): Values;
  /** A handle is held: what the drag reads its numbers from must stay where it is. */
  readonly held: boolean;
  /** A drag in the stage sets a number; what is not allowed there is made so. */
  set(id: string, value: Value): void;
  /** Asks for another `draw`. */
  redraw(): void;
  colours(): Colours;
}

/** What a figure shows. */
export interface FigureStage {
  /** Draws, and says what the readouts are: numbers as they are to be read (`toFixed`), or words. `time`: seconds since it began to move. */
  draw(values: Values, time: number): Readonly<Record<string, number | string>>;
  /** The button of `steps`. */
  step?(): void;
  /** Puts back what is no value of the figure. */
  reset?(): void;
  /** What can be dragged, as it lies after the last `draw`. */
  handles?(values: Values): readonly Handle[];
  /** What screen readers are told in place of the picture, as it is now: a sentence or two. */
  text?(values: Values): string;
  /** The first picture waits for this; what it rejects with is told in the figure's place. */
  readonly ready?: Promise<void>;
  dispose?(): void;
}

/**
 * Fills every `<figure data-figure>` of the page.
 *
 * Each gets its stage, controls, readouts and links, and is drawn only while it is near the window and something has changed.
 * `document.documentElement.dataset.ready` is 'true' once all figures in the window have drawn. Throws where a figure has no spec or a spec no figure.
 */
export function mountFigures(specs: readonly FigureSpec[]): void {
  const places = new Map(
    [...document.querySelectorAll<HTMLElement>('figure[data-figure]')].map((element) => [
      element.dataset.figure ?? '',
      element,
    ]),
  );
  const page = new LivePage();
  for (const spec of specs) {
    const element = places.get(spec.id);
    if (!element) throw new Error(`This page has no <figure data-figure="${spec.id}">.`);
    places.delete(spec.id);
    page.add(new MountedFigure(element, spec, page));
  }
  if (places.size > 0) throw new Error(`No figure is written for: ${[...places.keys()].join(', ')}.`);
  page.start();
}
