import type { Stems, Tree } from '../grow/tree.ts';
import { hashPcg, hashUnit } from '../math/hash.ts';
import type { Pieces } from '../pieces/pieces.ts';
import type { Species } from '../species/species.ts';
import { MECHANICS, MECHANICS_SIZE } from './layout.ts';

/** Slowest and fastest natural angular frequency of a stem, rad/s (equations.md 6.8). */
export const OMEGA_RANGE = [0.5, 12] as const;
/** How much stems of one size differ in frequency, as a part of it: no two neighbours swing in unison. */
const VARIATION = 0.15;
const GRAVITY = 9.81;
/** Part of the square around a blade that it covers. */
const BLADE = 0.65;

/** The entry of a list by level: levels beyond the last use the last (weber-penn.md, row 51). */
const byLevel = <T>(list: readonly T[], level: number): T => list[Math.min(level, list.length - 1)];

/** What swings with a stem, kg: the stem's own wood, and all that grows on it, weighted by its place. */
interface Masses {
  readonly own: Float64Array;
  readonly carried: Float64Array;
}

/**
 * The mechanics of every piece, MECHANICS_SIZE numbers each: what its stem is as a spring.
 *
 * The natural frequency is that of a rod on a spring at its foot with the stiffness 3 E I/L of a cantilever:
 * 1.5 sqrt(E/density) radius/length^2, lowered by what it carries, of which a mass at the part z of the rod counts 3 z^2 times. To
 * its square comes that of a pendulum, 1.5 g/length: weight draws what hangs back to its rest, and what stands must be that much
 * stiffer than its grown radius (a floor of 0.1 mm) says, or it would hang. Source: equations.md 6.8; weight is ours.
 */
export function packMechanics(tree: Tree, pieces: Pieces): Float32Array {
  const { stems, species } = tree;
  const omega = stemFrequencies(tree);
  const flexibility = species.wind.stiffness.map((stiffness) => 1 / stiffness);
  const out = new Float32Array(MECHANICS_SIZE * pieces.count);
  for (let i = 0; i < pieces.count; i++) {
    const s = pieces.stem[i];
    const at = MECHANICS_SIZE * i;
    out[at + MECHANICS.Z0] = pieces.span[2 * i];
    out[at + MECHANICS.Z1] = pieces.span[2 * i + 1];
    out[at + MECHANICS.LENGTH] = stems.length[s];
    out[at + MECHANICS.RADIUS] = stems.baseRadius[s];
    out[at + MECHANICS.OMEGA] = omega[s];
    out[at + MECHANICS.LEVEL] = pieces.level[i];
    out[at + MECHANICS.PHASE] = hashUnit(hashPcg(stems.path[s] ^ 0x73776179));
    out[at + MECHANICS.FLEXIBILITY] = byLevel(flexibility, pieces.level[i]);
    out[at + MECHANICS.DAMPING] = species.wind.damping;
  }
  return out;
}

/** Natural angular frequency of each stem of a tree with all that grows on it, rad/s. */
export function stemFrequencies(tree: Tree): Float64Array {
  const { stems, species } = tree;
  const { own, carried } = stemMasses(tree);
  const speed = 1.5 * Math.sqrt((species.wind.modulus * 1e9) / species.wind.density);
  const out = new Float64Array(stems.count);
  for (let i = 0; i < stems.count; i++) {
    const l = Math.max(stems.length[i], 1e-6);
    const loaded = Math.sqrt(own[i] / Math.max(own[i] + carried[i], 1e-12));
    const varied = 1 + VARIATION * (2 * hashUnit(hashPcg(stems.path[i] ^ 0x6f6d6567)) - 1);
    const bending = (speed * stems.baseRadius[i] * loaded) / (l * l);
    const omega = Math.sqrt(bending * bending + (1.5 * GRAVITY) / l);
    // The limit varies too: most twigs reach it.
    const most = OMEGA_RANGE[1] / (1 + VARIATION);
    out[i] = Math.max(Math.min(omega, most) * varied, OMEGA_RANGE[0]);
  }
  return out;
}

function stemMasses({ species, stems, leaves }: Tree): Masses {
  const { count, parent, parentZ, clone, zStart } = stems;
  const own = new Float64Array(count);
  const carried = new Float64Array(count);
  const total = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    own[i] = woodMass(species, stems, i, 0);
    // A clone bends as its twin does and has the same foot; what hangs on the twin is its own part alone.
    total[i] = clone[i] === 1 ? woodMass(species, stems, i, zStart[i]) : own[i];
  }
  const area = BLADE * species.leaves.scaleX * species.foliage.size * species.foliage.size;
  for (let i = 0; i < leaves.count; i++) {
    const mass = species.wind.leafMass * area * leaves.length[i] * leaves.length[i];
    const z = leaves.z[i];
    carried[leaves.stem[i]] += 3 * z * z * mass;
    total[leaves.stem[i]] += mass;
  }
  // Children stand behind their parents: the last first, all that a stem bears is known before its parent asks.
  for (let i = count - 1; i > 0; i--) {
    if (parent[i] < 0) continue;
    carried[parent[i]] += 3 * parentZ[i] * parentZ[i] * total[i];
    total[parent[i]] += total[i];
  }
  return { own, carried };
}

/** Wood of a stem from the part `from` of its length to its tip, kg: a cone, blunt as its taper says; flare and lobes are left out. */
function woodMass({ levels, wind }: Species, { baseRadius, length, level }: Stems, i: number, from: number): number {
  const { taper } = byLevel(levels, level[i]);
  const t = taper < 1 ? taper : Math.max(2 - taper, 0);
  // The integral of (1 - t z)^2.
  const part = (z: number): number => z * (1 - t * z * (1 - (t * z) / 3));
  return wind.density * Math.PI * baseRadius[i] * baseRadius[i] * length[i] * (part(1) - part(from));
}
