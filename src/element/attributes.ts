import { ALL_LEVELS, type StageId } from '../core/link/document.ts';
import { LINK_NUMBERS } from '../core/link/numbers.ts';
import { SEASONS } from '../core/species/season.ts';
import { ANGLE, type AttributeRule, numberBy, ORBIT, oneOf, SECONDS, SPEED, SWITCH, TEXT } from './attribute-rules.ts';

export const DETAILS = ['auto', 'low', 'medium', 'high'] as const;
export const MODELS = ['direct', 'spring', 'sway'] as const;
export const LOADINGS = ['lazy', 'eager'] as const;
export const REVEALS = ['auto', 'interaction', 'manual'] as const;
export const ENVIRONMENTS = ['none', 'sky', 'park', 'golden', 'studio'] as const;
export const GROUNDS = ['auto', 'grass', 'plain', 'none'] as const;
export const TOUCH_ACTIONS = ['pan-y', 'pan-x', 'none'] as const;
export const DEBUGS = ['none', 'levels', 'skeleton', 'mesh', 'field', 'state'] as const;

export type ElementDetail = (typeof DETAILS)[number];
export type ElementModel = (typeof MODELS)[number];
export type ElementLoading = (typeof LOADINGS)[number];
export type ElementReveal = (typeof REVEALS)[number];
export type ElementEnvironment = (typeof ENVIRONMENTS)[number];
export type ElementGround = (typeof GROUNDS)[number];
export type ElementTouchAction = (typeof TOUCH_ACTIONS)[number];
export type ElementDebug = (typeof DEBUGS)[number];

/** The stage that an environment is lit by. */
export const STAGE_OF: Readonly<Record<ElementEnvironment, StageId>> = {
  none: 'meadow',
  sky: 'meadow',
  park: 'park',
  golden: 'golden',
  studio: 'studio',
};

/** An attribute of the element: its property, how it is read, and what holds where it is not there. */
export interface AttributeRow<T = unknown> {
  readonly property: string;
  readonly rule: AttributeRule<T>;
  /** null: the wind's, the camera's or the page's own. */
  readonly usual: T | null;
}

const row = <T>(property: string, rule: AttributeRule<T>, usual: T | null): AttributeRow<T> => ({
  property,
  rule,
  usual,
});

/** All attributes with a value. `camera-controls` and `paused`, which are only there or not, are none of them. */
export const ATTRIBUTES = {
  species: row('species', TEXT, ''),
  src: row('src', TEXT, ''),
  seed: row('seed', numberBy(LINK_NUMBERS.seed), 1),
  detail: row('detail', oneOf(DETAILS), 'auto'),
  wind: row('wind', TEXT, 'breeze'),
  'wind-speed': row('windSpeed', SPEED, null),
  'wind-direction': row('windDirection', ANGLE, null),
  gust: row('gust', numberBy({ label: 'gust', unit: '', min: 0, max: 1, decimals: 3 }), null),
  model: row('model', oneOf(MODELS), null),
  time: row('time', SECONDS, null),
  autoplay: row('autoplay', SWITCH, true),
  'playback-rate': row('playbackRate', numberBy(LINK_NUMBERS.rate), 1),
  loading: row('loading', oneOf(LOADINGS), 'lazy'),
  reveal: row('reveal', oneOf(REVEALS), 'auto'),
  poster: row('poster', TEXT, ''),
  'camera-orbit': row('cameraOrbit', ORBIT, null),
  'touch-action': row('touchAction', oneOf(TOUCH_ACTIONS), 'pan-y'),
  environment: row('environment', oneOf(ENVIRONMENTS), 'sky'),
  hour: row('hour', numberBy(LINK_NUMBERS.hour), null),
  ground: row('ground', oneOf(GROUNDS), 'auto'),
  shadow: row('shadow', SWITCH, true),
  levels: row('levels', numberBy(LINK_NUMBERS.levels), ALL_LEVELS),
  leaves: row('leaves', SWITCH, true),
  season: row('season', oneOf(SEASONS), 'summer'),
  'max-pixel-ratio': row('maxPixelRatio', numberBy({ label: '', unit: '', min: 0.25, max: 2, decimals: 2 }), 2),
  debug: row('debug', oneOf(DEBUGS), 'none'),
} as const;

export type AttributeName = keyof typeof ATTRIBUTES;

/** What a bad attribute says: which, what stands there, what may. */
export const attributeFault = (name: AttributeName, found: unknown): string => {
  const text = String(found);
  const short = text.length > 60 ? `${text.slice(0, 60)}…` : text;
  return `${name}="${short}" is not allowed: it may be ${ATTRIBUTES[name].rule.allowed}.`;
};

/** A value that a property was given, as its attribute would read it; undefined where it may not be. */
export function readProperty(name: AttributeName, value: unknown): unknown {
  const { rule, usual } = ATTRIBUTES[name] as AttributeRow;
  if (value === null || value === undefined) return usual;
  if (typeof value === 'string') return rule.read(value);
  try {
    return rule.read(rule.write(value)) === undefined ? undefined : value;
  } catch {
    return undefined; // an object of another kind
  }
}
