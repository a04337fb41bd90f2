import { describe, expect, test } from 'vitest';
import { createWindState, type WindState } from '../../src/core/wind/fade.ts';
import { definesOf, type ProgramOf, variantOf, variantsToWarm } from '../../src/gpu/step-variants.ts';

const wind = (changes: Partial<WindState> = {}): WindState => ({ ...createWindState(), ...changes });
const record = new Float32Array(4);

describe('variants', () => {
  test('each says what the wind asks for, and no two that differ share a number', () => {
    const seen = new Map<number, string>();
    for (const program of ['pose', 'spring', 'spring seed'] as ProgramOf[])
      for (const count of [3, 7, 12])
        for (const gustCount of [0, 2])
          for (const profiled of [0, 1] as const)
            for (const recorded of [null, record])
              for (const model of ['direct', 'spring', 'sway'] as const)
                for (const from of [null, 'direct', 'spring', 'sway'] as const)
                  for (const paper of [false, true]) {
                    if (from === model) continue;
                    const state = wind({ count, gustCount, profiled, record: recorded, model, from, paper });
                    const variant = variantOf(program, state);
                    const words = JSON.stringify(definesOf(variant));
                    expect(seen.get(variant) ?? words).toBe(words);
                    seen.set(variant, words);
                    const { defines } = definesOf(variant);
                    const blows = program !== 'pose' || model === 'direct' || from === 'direct';
                    expect(defines.WIND_WAVES).toBe(blows ? (count > 8 ? 16 : count > 4 ? 8 : 4) : 4);
                    expect(defines.WIND_GUSTS).toBe(blows ? 8 * Math.min(1, gustCount) : 0);
                    expect('SPRING_SEED' in defines).toBe(program === 'spring seed');
                    if (program !== 'pose') expect(Object.keys(defines)).not.toContain('WIND_MODEL');
                    else expect(defines.WIND_MODEL).toBe(['direct', 'spring', 'sway'].indexOf(model));
                  }
    expect(new Set(seen.values()).size).toBe(seen.size);
  });

  test('a pose of springs alone is one shader, whatever blows', () => {
    const some = [wind({ model: 'spring' }), wind({ model: 'spring', count: 12, gustCount: 3, record })];
    expect(new Set(some.map((state) => variantOf('pose', state))).size).toBe(1);
  });

  test('springs at a step read one state, and while they stand, the shader for when they run is made ready', () => {
    const [between, whole] = [false, true].map((at) => variantOf('pose', wind({ model: 'spring' }), at));
    expect(definesOf(between!).defines).not.toHaveProperty('SPRING_WHOLE');
    expect(definesOf(whole!).defines).toHaveProperty('SPRING_WHOLE', 1);
    expect([variantsToWarm(between!), variantsToWarm(whole!)]).toEqual([[whole], [between]]);
    expect(variantOf('pose', wind(), true)).toBe(variantOf('pose', wind(), false));
  });

  test('where the force is evaluated, a fade and a gust are made ready; elsewhere nothing is', () => {
    const words = (program: ProgramOf, state: WindState) =>
      variantsToWarm(variantOf(program, state)).map((variant) => {
        const { defines } = definesOf(variant);
        return [defines.WIND_WAVES, defines.WIND_GUSTS];
      });
    const ready = [
      [8, 0],
      [4, 8],
      [8, 8],
    ];
    expect(words('pose', wind({ count: 4 }))).toEqual(ready);
    expect(words('spring', wind({ count: 4, model: 'spring' }))).toEqual(ready);
    expect(words('pose', wind({ model: 'sway' }))).toEqual([]);
    expect(words('spring seed', wind({ model: 'spring' }))).toEqual([]);
    expect(words('pose', wind({ model: 'direct', from: 'spring' }))).toEqual([]);
  });
});
