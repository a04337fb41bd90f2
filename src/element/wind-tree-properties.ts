import { LitElement } from 'lit';
import { property } from 'lit/decorators.js';
import { ALL_LEVELS } from '../core/link/document.ts';
import type { Season } from '../core/species/season.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { attributeProperty } from './attribute-property.ts';
import type { CameraOrbit } from './attribute-rules.ts';
import type {
  ElementDebug,
  ElementDetail,
  ElementEnvironment,
  ElementGround,
  ElementLoading,
  ElementModel,
  ElementReveal,
  ElementTouchAction,
} from './attributes.ts';

/** The properties of `<wind-tree>` and their attributes; what they do is in wind-tree-element.ts. */
export class WindTreeProperties extends LitElement {
  /** Id of a species that ships, such as `quaking-aspen`, or the address of a species file. */
  @property(attributeProperty('species')) species = '';

  /** Address of a species file of your own; goes before `species`. */
  @property(attributeProperty('src')) src = '';

  /** Which tree of the species: a whole number from 0; the same seed is the same tree everywhere. Default 1. */
  @property(attributeProperty('seed')) seed = 1;

  /** How finely it is drawn: `auto` (default, as the machine can), `low`, `medium`, `high`. */
  @property(attributeProperty('detail')) detail: ElementDetail = 'auto';

  /** Id of a wind that ships, such as `light-breeze`, or the address of a wind file. Default `breeze`. */
  @property(attributeProperty('wind')) wind = 'breeze';

  /** Mean speed of the wind in metres a second; the attribute has its unit, `6m/s` or `20km/h`. null: the wind's own. */
  @property(attributeProperty('wind-speed')) windSpeed: number | null = null;

  /** Where the wind blows to, in degrees: 0 to the right of the first view, 90 away from the viewer; the attribute as `240deg`, `4.2rad` or `0.5turn`. null: the wind's own. */
  @property(attributeProperty('wind-direction')) windDirection: number | null = null;

  /** Strength of a gust that comes every nine seconds, 0 (none) to 1. null: the wind's own gusts. */
  @property(attributeProperty('gust')) gust: number | null = null;

  /** How branches answer: `direct` (at once), `spring` (they swing), `sway` (Weber and Penn). null: as the wind has it. */
  @property(attributeProperty('model')) model: ElementModel | null = null;

  /** Whether time runs as soon as the tree is there: `on` (default) or `off`. It never does by itself where the reader wants less motion. */
  @property(attributeProperty('autoplay')) autoplay = true;

  /** Seconds of the wind a second, 0.1 to 2. Default 1. */
  @property(attributeProperty('playback-rate')) playbackRate = 1;

  /** When it is loaded: `lazy` (default, near the window) or `eager`. */
  @property(attributeProperty('loading')) loading: ElementLoading = 'lazy';

  /** When the poster goes: `auto` (default, with the first picture), `interaction` (when it is pressed), `manual` (`dismissPoster()`). */
  @property(attributeProperty('reveal')) reveal: ElementReveal = 'auto';

  /** Address of a picture that stands until the tree does; the slot `poster` goes before it. */
  @property(attributeProperty('poster')) poster = '';

  /** What the picture shows, for those who do not see it; an empty text: it is decoration. By default the names of tree and wind. */
  @property({ reflect: true }) alt: string | null = null;

  /** Lets the reader turn the camera, by pointer and by keys. */
  @property({ type: Boolean, attribute: 'camera-controls', reflect: true }) cameraControls = false;

  /** Where the camera stands: angle about the tree, angle from straight above, distance; the attribute as `30deg 75deg 12m`, each part may be `auto`. null: the whole tree. */
  @property(attributeProperty('camera-orbit')) cameraOrbit: CameraOrbit | null = null;

  /** What a finger does beside turning the camera: `pan-y` (default) scrolls the page up and down, `pan-x` sideways, `none` nothing. */
  @property(attributeProperty('touch-action')) touchAction: ElementTouchAction = 'pan-y';

  /** What is around the tree: `sky` (default), `park`, `golden`, `studio`, or `none`, which is transparent. */
  @property(attributeProperty('environment')) environment: ElementEnvironment = 'sky';

  /** Hour of the day by the sun, 0 to 24, which lights it. null: the environment's own. */
  @property(attributeProperty('hour')) hour: number | null = null;

  /** What it stands on: `grass`, `plain`, `none`, or `auto` (default): grass under a sky, nothing without one. */
  @property(attributeProperty('ground')) ground: ElementGround = 'auto';

  /** Whether it throws shadows: `on` (default) or `off`. */
  @property(attributeProperty('shadow')) shadow = true;

  /** How many levels of branches are drawn, from the trunk on: 1 to 9, all by default. */
  @property(attributeProperty('levels')) levels = ALL_LEVELS;

  /** Whether leaves are drawn, where all levels are: `on` (default) or `off`. */
  @property(attributeProperty('leaves')) leaves = true;

  /** `spring`, `summer` (default), `autumn` or `winter`: leaves, blossom and fruit. */
  @property(attributeProperty('season')) season: Season = 'summer';

  /** Pixels of the screen to each of the page at most, 0.25 to 2. Default 2. */
  @property(attributeProperty('max-pixel-ratio')) maxPixelRatio = 2;

  /** What is shown for those who look inside: `none` (default), `levels`, `skeleton`, `mesh`, `field`, the force of the wind over the ground, or `state`, the textures that the GPU keeps of the branches. */
  @property(attributeProperty('debug')) debug: ElementDebug = 'none';

  /** Holds time still; set by the reader's button, too. */
  @property({ type: Boolean, reflect: true }) paused = false;

  /** A species in place of one by name; goes before `src`. */
  @property({ attribute: false }) speciesData: Species | null = null;

  /** A wind in place of one by name. */
  @property({ attribute: false }) windData: Wind | null = null;
}
