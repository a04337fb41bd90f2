import { levelShape } from '../core/mesh/level-shape.ts';
import type { Species } from '../core/species/species.ts';
import { barkDefines, type StemForm } from './bark-look.ts';

/** The parts of the deformer's programs that a level needs; each that is left out saves work at every vertex. */
export function stemDefines(level: number, species: Species, paper: boolean, form: StemForm = 'tube'): string[] {
  const { taper, lobeDepth, bulgeDepth } = levelShape(species, level);
  const plain = level > 0 && bulgeDepth === 0 && lobeDepth === 0 && taper <= 1;
  const shape = [level === 0 ? 'FLARED' : '', plain ? 'PLAIN_STEM' : '', paper ? 'PAPER_FORMS' : ''].filter(Boolean);
  return [...shape, ...barkDefines(level, species, form), ...(form === 'ribbon' ? ['RIBBON'] : [])];
}
