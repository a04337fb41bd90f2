import { type PropertyDeclaration, type PropertyDeclarations, ReactiveElement } from '@lit/reactive-element';
import { ALL_LEVELS } from '../core/link/document.ts';
import type { Season } from '../core/species/season.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { attributeProperty } from './attribute-property.ts';
import type { CameraOrbit } from './attribute-rules.ts';
import {
  ATTRIBUTES,
  type AttributeName,
  type ElementDebug,
  type ElementDetail,
  type ElementEnvironment,
  type ElementGround,
  type ElementLoading,
  type ElementModel,
  type ElementReveal,
  type ElementTouchAction,
} from './attributes.ts';

/** How the properties of the table are read and written; that of the time, which is the clock's, is the element's own. */
const OF_TABLE: Readonly<Record<string, PropertyDeclaration>> = Object.fromEntries(
  (Object.keys(ATTRIBUTES) as AttributeName[])
    .filter((name) => name !== 'time')
    .map((name) => [ATTRIBUTES[name].property, attributeProperty(name)]),
);

/** The properties of `<wind-tree>` and their attributes; what they do is in wind-tree-element.ts. */
export class WindTreeProperties extends ReactiveElement {
  static override properties: PropertyDeclarations = {
    ...OF_TABLE,
    alt: { reflect: true },
    cameraControls: { type: Boolean, attribute: 'camera-controls', reflect: true },
    paused: { type: Boolean, reflect: true },
    speciesData: { attribute: false },
    windData: { attribute: false },
  };

  #restoring = false;

  /** Puts a text of `time` that may not be back as it was: that attribute is not reflected, and where it stands it makes a still. */
  override attributeChangedCallback(name: string, before: string | null, text: string | null): void {
    if (this.#restoring) return;
    super.attributeChangedCallback(name, before, text);
    if (name !== 'time' || text === null || ATTRIBUTES.time.rule.read(text) !== undefined) return;
    this.#restoring = true;
    if (before === null) this.removeAttribute(name);
    else this.setAttribute(name, before);
    this.#restoring = false;
  }

  /** Id of a species that ships, such as `quaking-aspen`, or the address of a species file. */
  species = '';

  /** Address of a species file of your own; goes before `species`. */
  src = '';

  /** Which tree of the species: a whole number from 0; the same seed is the same tree everywhere. Default 1. */
  seed = 1;

  /** How finely it is drawn: `auto` (default, as the machine can), `low`, `medium`, `high`. */
  detail: ElementDetail = 'auto';

  /** Id of a wind that ships, such as `light-breeze`, or the address of a wind file. Default `breeze`. */
  wind = 'breeze';

  /** Mean speed of the wind in metres a second; the attribute has its unit, `6m/s` or `20km/h`. null: the wind's own. */
  windSpeed: number | null = null;

  /** Where the wind blows to, in degrees: 0 to the right of the first view, 90 away from the viewer; the attribute as `240deg`, `4.2rad` or `0.5turn`. null: the wind's own. */
  windDirection: number | null = null;

  /** Strength of a gust that comes every nine seconds, 0 (none) to 1. null: the wind's own gusts. */
  gust: number | null = null;

  /** How branches answer: `direct` (at once), `spring` (they swing), `sway` (Weber and Penn). null: as the wind has it. */
  model: ElementModel | null = null;

  /** Whether time runs as soon as the tree is there: `on` (default) or `off`. It never does by itself where the reader wants less motion. */
  autoplay = true;

  /** Seconds of the wind a second, 0.1 to 2. Default 1. */
  playbackRate = 1;

  /** When it is loaded: `lazy` (default, near the window) or `eager`. */
  loading: ElementLoading = 'lazy';

  /** When the poster goes: `auto` (default, with the first picture), `interaction` (when it is pressed), `manual` (`dismissPoster()`). */
  reveal: ElementReveal = 'auto';

  /** Address of a picture that stands until the tree does; the slot `poster` goes before it. */
  poster = '';

  /** What the picture shows, for those who do not see it; an empty text: it is decoration. By default the names of tree and wind. */
  alt: string | null = null;

  /** Lets the reader turn the camera, by pointer and by keys. */
  cameraControls = false;

  /** Where the camera stands: angle about the tree, angle from straight above, distance; the attribute as `30deg 75deg 12m`, each part may be `auto`. null: the whole tree. */
  cameraOrbit: CameraOrbit | null = null;

  /** What a finger does beside turning the camera: `pan-y` (default) scrolls the page up and down, `pan-x` sideways, `none` nothing. */
  touchAction: ElementTouchAction = 'pan-y';

  /** What is around the tree: `sky` (default), `park`, `golden`, `studio`, or `none`, which is transparent. */
  environment: ElementEnvironment = 'sky';

  /** Hour of the day by the sun, 0 to 24, which lights it. null: the environment's own. */
  hour: number | null = null;

  /** What it stands on: `grass`, `plain`, `none`, or `auto` (default): grass under a sky, nothing without one. */
  ground: ElementGround = 'auto';

  /** Whether it throws shadows: `on` (default) or `off`. */
  shadow = true;

  /** How many levels of branches are drawn, from the trunk on: 1 to 9, all by default. */
  levels = ALL_LEVELS;

  /** Whether leaves are drawn, where all levels are: `on` (default) or `off`. */
  leaves = true;

  /** `spring`, `summer` (default), `autumn` or `winter`: leaves, blossom and fruit. */
  season: Season = 'summer';

  /** Pixels of the screen to each of the page at most, 0.25 to 2. Default 2. */
  maxPixelRatio = 2;

  /** What is shown for those who look inside: `none` (default), `levels`, `skeleton`, `mesh`, `field`, the force of the wind over the ground, or `state`, the textures that the GPU keeps of the branches. */
  debug: ElementDebug = 'none';

  /** Holds time still; set by the reader's button, too. */
  paused = false;

  /** A species in place of one by name; goes before `src`. */
  speciesData: Species | null = null;

  /** A wind in place of one by name. */
  windData: Wind | null = null;
}
