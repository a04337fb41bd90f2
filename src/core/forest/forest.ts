import type { StageId } from '../link/document.ts';
import type { Season } from '../species/season.ts';

/** From `least` to `most`, both within; beyond each end what is asked for fades out over `soft`, in the same unit. */
export interface HabitatRange {
  readonly least: number;
  readonly most: number;
  readonly soft: number;
}

/** Where a species may stand (Weber & Penn 1995, section 6: feature maps); what is absent does not matter to it. */
export interface Habitat {
  /** Metres, as heights of the field are. */
  readonly altitude?: HabitatRange;
  /** Degrees, 0..90. */
  readonly slope?: HabitatRange;
  /** 0 dry ridge, 0.5 even ground, 1 hollow. */
  readonly wetness?: HabitatRange;
}

export interface ForestSpecies {
  /** Id of a species that ships. */
  readonly species: string;
  /** Part of the trees where it suits all species alike, of the sum of all shares; 0..1. */
  readonly share: number;
  readonly where?: Habitat;
}

/** Hills of summed gradient noise on a slope and in a valley. */
export interface HillsTerrain {
  readonly kind: 'hills';
  /** Unsigned 32-bit integer; apart from the forest's, so that other trees may stand on the same hills. */
  readonly seed: number;
  /** Metres between the lowest hollow and the highest top that the noise makes, 0..400. */
  readonly relief: number;
  /** Metres from hill to hill, 20..4000. */
  readonly scale: number;
  /** Each octave is half as long and less than half as high as the last, 1..7. */
  readonly octaves: number;
  /** Metres that the ground rises besides from one side to the other: level at the foot and at the top, steep between; 0..1000. */
  readonly rise: number;
  /** Metres that the ground rises besides to both sides of a line through the middle, 0..1000. */
  readonly valley: number;
  /** Degrees to which `rise` goes up and across which the valley lies: 0 east (+x), 90 north (+y). */
  readonly riseTo: number;
}

/** A grey picture; the picture itself is no part of the document. */
export interface MapTerrain {
  readonly kind: 'map';
  /** The name of the file, for people. */
  readonly name: string;
  /** Metres of black and of white, -500..2000. */
  readonly black: number;
  readonly white: number;
}

export type TerrainSpec = HillsTerrain | MapTerrain;

/** Clearings where noise is low. */
export interface ClearingsDensity {
  readonly kind: 'clearings';
  /** Unsigned 32-bit integer. */
  readonly seed: number;
  /** Part of the ground that is bare, 0..0.9. */
  readonly bare: number;
  /** Metres from clearing to clearing, 10..1000. */
  readonly scale: number;
}

/** A grey picture, black bare and white full; the picture itself is no part of the document. */
export interface MapDensity {
  readonly kind: 'map';
  readonly name: string;
}

export type DensitySpec = ClearingsDensity | MapDensity;

/** The eye in forest space: metres, and degrees. */
export interface ForestCamera {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Where it looks: 0 east (+x), 90 north (+y). */
  readonly yaw: number;
  /** Degrees above the horizon, -90..90. */
  readonly pitch: number;
}

/** All that a forest is but for pictures that were put in: the same document, the same forest. */
export interface ForestDocument {
  readonly name: string;
  /** Unsigned 32-bit integer. */
  readonly seed: number;
  /** Side of the square in metres, centred on 0, 0. */
  readonly size: number;
  /** Trees; fewer stand where there is no room for so many. */
  readonly count: number;
  /** Least metres from trunk to trunk, where the forest is full. */
  readonly spacing: number;
  readonly mix: readonly ForestSpecies[];
  readonly terrain: TerrainSpec;
  readonly density: DensitySpec;
  readonly season: Season;
  readonly stage: StageId;
  /** Hour of the day by the sun, 0..24; null: the stage's own. */
  readonly hour: number | null;
  /** Id of a wind that ships. */
  readonly wind: string;
  /** Mean speed in metres a second to which the wind is brought; null: its own. */
  readonly windSpeed: number | null;
  /** Degrees by which the wind is turned anticlockwise from above. */
  readonly windTurn: number;
  /** Milliseconds a frame. */
  readonly budget: number;
  /** null: at the south edge, looking north. */
  readonly camera: ForestCamera | null;
}

/** Where trees stand; entry i is the tree of rank i, and any prefix is spread over the whole forest. */
export interface TreePlaces {
  readonly count: number;
  /** Metres in forest space; z on the ground. */
  readonly x: Float32Array;
  readonly y: Float32Array;
  readonly z: Float32Array;
  /** Radians about the vertical, 0..2 pi. */
  readonly turn: Float32Array;
  /** Index in the mix. */
  readonly species: Uint8Array;
  /** Rank of the tree among its species: its variant is this modulo the number of variants. */
  readonly variant: Uint32Array;
}
