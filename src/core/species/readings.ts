import type { Species } from './species.ts';

/** The species with the switches that it asks for: where `paper` is set, the printed forms (weber-penn.md rows 5, 31, 38). */
export const withReadings = (species: Species): Species =>
  species.switches.paper
    ? {
        ...species,
        switches: { ...species.switches, branchesAboveBase: false, halveCloning: true, paperAttraction: true },
      }
    : species;
