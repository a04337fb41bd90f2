import type { IUniform } from 'three';
import grassGround from '../../../shaders/forest/grass-ground.glsl';
import look from '../../../shaders/forest/terrain-look.glsl';
import groundGlsl from '../../../shaders/stage/ground.glsl';
import type { ForceField } from '../force-field.ts';
import type { Injection, Patch } from '../inject.ts';
import { GRASS_INJECTION, Meadow } from '../meadow.ts';
import type { Terrain } from './terrain.ts';

/** Where the meadow colours its tips as nothing but light grass: on straw, shade and litter such tips stand out as white specks. */
const TIP = 'mix(groundDiffuse() * 0.82, grassLight * (';

/** Text of the meadow's shader: its functions of the ground, or calls of them. */
const terrainText = (text: string): string =>
  text.includes(groundGlsl)
    ? text.replace(groundGlsl, () => look)
    : text.replace(TIP, 'terrainBlade(groundDiffuse(), (').replace(/\bground(Diffuse|Sky|Fade)\(\)/g, 'terrain$1()');

/** The meadow's own patch with what is the ground's replaced by what is the terrain's. */
const onTerrain = ({ anchor, ...patch }: Patch): Patch => {
  const texts = Object.entries(patch).map(([key, text]) => [key, terrainText(text as string)]);
  return { anchor, ...Object.fromEntries(texts) };
};

/** Where three's Lambert material takes grass that stands on a terrain. */
export const FOREST_GRASS_INJECTION: Injection = {
  vertex: GRASS_INJECTION.vertex.map((patch: Patch, i) =>
    i === 0 ? { ...patch, after: `${grassGround}\n${patch.after}` } : patch,
  ),
  fragment: GRASS_INJECTION.fragment.map(onTerrain),
};

/** The meadow's grass on the ground of a forest, in its colours and under the same wind. */
export const forestMeadow = (terrain: Terrain, field: ForceField, sky: Readonly<Record<string, IUniform>>): Meadow =>
  new Meadow(terrain, field, sky, ['windgrove forest grass', FOREST_GRASS_INJECTION]);
