import { describe, expect, it } from 'vitest';
import { STAGES } from '../../src/core/link/document.ts';
import { contrastOnSky, inkOnSky } from '../../src/editor/sky-ink.ts';

const hours = Array.from({ length: 97 }, (_, quarter) => quarter / 4);

describe('the ink of what stands on the sky', () => {
  it('is dark by day and light by night, in either theme', () => {
    for (const dark of [false, true]) {
      expect(inkOnSky('meadow', 12, dark)).toBe('dark');
      expect(inkOnSky('golden', null, dark)).toBe('dark');
      expect(inkOnSky('park', 10, dark)).toBe('dark');
      expect(inkOnSky('meadow', 23, dark)).toBe('light');
    }
    expect(inkOnSky('studio', null, false)).toBe('dark');
    expect(inkOnSky('studio', null, true)).toBe('light');
  });

  it('is read at each hour of each stage: large letters need a contrast of 3', () => {
    for (const stage of STAGES) {
      for (const dark of [false, true]) {
        for (const hour of hours) {
          const contrast = contrastOnSky(inkOnSky(stage, hour, dark), stage, hour, dark);
          expect(contrast, `${stage} at ${hour}${dark ? ', dark' : ''}`).toBeGreaterThan(3);
        }
      }
    }
  });
});
