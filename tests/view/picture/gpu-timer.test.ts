import { expect, test } from 'vitest';
import { GpuTimer } from '../../../src/view/picture/gpu-timer.ts';

/** A graphics card that answers queries at once, as long as they are of the context that made them. */
function card() {
  let life = 0;
  const foreign: number[] = [];
  const gl = {
    canvas: new EventTarget(),
    QUERY_RESULT_AVAILABLE: 1,
    QUERY_RESULT: 2,
    getExtension: () => ({ TIME_ELAPSED_EXT: 10, GPU_DISJOINT_EXT: 11, life }),
    createQuery: () => ({ life }),
    beginQuery: () => undefined,
    endQuery: () => undefined,
    deleteQuery: () => undefined,
    getParameter: () => false,
    getQueryParameter: (query: { life: number }, what: number) => {
      if (query.life !== life) foreign.push(query.life);
      return query.life === life && (what === 1 || 4e6);
    },
  };
  const restore = (): void => {
    life++;
    gl.canvas.dispatchEvent(new Event('webglcontextrestored'));
  };
  return { gl: gl as unknown as WebGL2RenderingContext, restore, foreign };
}

test('measures on after the graphics card was lost and came back, and asks no query of the lost one', () => {
  const { gl, restore, foreign } = card();
  const timer = new GpuTimer(gl);
  timer.begin();
  timer.end();
  restore();
  for (let frame = 0; frame < 2; frame++) {
    timer.begin();
    timer.end();
  }
  expect(foreign).toEqual([]);
  expect(timer.milliseconds).toBe(4);
});
