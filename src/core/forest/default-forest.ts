import type { ClearingsDensity, ForestDocument, HillsTerrain } from './forest.ts';

export const DEFAULT_HILLS: HillsTerrain = {
  kind: 'hills',
  seed: 1,
  relief: 30,
  scale: 220,
  octaves: 5,
  rise: 40,
  valley: 0,
  riseTo: 90,
};

export const DEFAULT_CLEARINGS: ClearingsDensity = { kind: 'clearings', seed: 1, bare: 0.15, scale: 90 };

/** What a forest is where its file or link says nothing. */
export const DEFAULT_FOREST: ForestDocument = {
  name: 'Forest',
  seed: 1,
  size: 500,
  count: 1500,
  spacing: 3,
  mix: [{ species: 'quaking-aspen', share: 1 }],
  terrain: DEFAULT_HILLS,
  density: DEFAULT_CLEARINGS,
  season: 'summer',
  stage: 'park',
  hour: null,
  wind: 'breeze',
  windSpeed: null,
  windTurn: 0,
  budget: 16.7,
  camera: null,
};
