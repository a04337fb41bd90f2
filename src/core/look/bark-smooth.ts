import { cloud, drawer, mix, noise, paint, type Relief, smoothstep, stamp } from './bark-relief.ts';

/** Smooth and powdery: soft clouds of tone, faint creases around the stem, dashes of lenticels, and black eyes where twigs were shed. */
export function smooth(size: number): Relief {
  const clouds = cloud(2, 3, 11, 3);
  const stains = cloud(5, 3, 12, 2);
  const crease = noise(5, 56, 13);
  const lull = noise(4, 6, 14);
  const runs = noise(16, 3, 17);
  const powder = cloud(60, 72, 15, 2);
  const relief = paint(size, (u, v, out) => {
    const a = clouds(u, v);
    const s = stains(u, v);
    const c = crease(u, v + 0.012 * a);
    const p = powder(u, v);
    const creased = smoothstep(0.12, 0.5, c) * smoothstep(-0.15, 0.35, lull(u, v));
    // Powder is rubbed off in patches, and rain has drawn it down.
    const rubbed = smoothstep(0.05, 0.4, s + 0.5 * p) * 0.6 + smoothstep(0.15, 0.55, runs(u + 0.01 * a, v)) * 0.4;
    out.height = 0.6 + 0.14 * a - 0.1 * creased + 0.04 * p;
    out.dark = 0.14 + 0.2 * a + 0.26 * rubbed + 0.13 * creased + 0.13 * p;
  });
  const { height, dark } = relief;
  const draw = drawer(91);
  const ragged = cloud(18, 18, 16, 2);
  // Lenticels come in loose rows around the stem.
  for (let row = 0; row < 46; row++) {
    const v = draw();
    const count = 1 + Math.floor(7 * draw() * draw());
    const from = draw();
    for (let i = 0; i < count; i++) {
      const l = draw();
      const strength = 0.3 + 0.5 * draw();
      const at = [from + 0.05 * i + 0.03 * draw(), v + 0.012 * (draw() - 0.5)] as const;
      stamp(size, at, [0.004 + 0.02 * l * l * l, 0.0024 + 0.0022 * draw()], (t, d) => {
        const f = strength * smoothstep(1, 0.45, d);
        dark[t] = Math.max(dark[t]!, f);
        height[t] = height[t]! + 0.16 * f;
      });
    }
  }
  for (let i = 0; i < 5; i++) {
    const r = 0.022 + 0.026 * draw();
    const flat = 0.55 + 0.35 * draw();
    const at = [draw(), (i + 0.2 + 0.6 * draw()) / 5] as const;
    const lean = 0.5 * (draw() - 0.5);
    // Swollen bark around the eye, drawn into folds; the eye itself; and the brow that the branch's collar left above it.
    stamp(size, at, [r * 3.4, r * 3], (t, d, dx, dy) => {
      const folds = Math.abs(((dy * 7 + dx * dx * 5 * (dy > 0 ? 1 : -1) + 40) % 1) - 0.5);
      height[t] = height[t]! + 0.08 * smoothstep(1, 0.3, d) + 0.04 * folds * smoothstep(1, 0.6, d);
      dark[t] = dark[t]! + 0.2 * smoothstep(1, 0.35, d) * (0.35 + folds);
    });
    stamp(size, at, [r * 1.5, r * 1.5 * flat], (t, d, dx, dy) => {
      const u = (t % size) / size;
      const v = Math.floor(t / size) / size;
      const rough = ragged(u, v);
      const edge = d + 0.24 * rough + lean * dx * dy;
      const eye = smoothstep(0.86, 0.6, edge);
      height[t] = height[t]! + 0.08 * smoothstep(1.05, 0.75, edge) - 0.2 * eye * (1 + 1.5 * rough);
      dark[t] = Math.max(dark[t]!, mix(0, 0.97 + 0.2 * rough, eye), 0.45 * smoothstep(1, 0.7, edge));
    });
    // Short black cracks around it.
    for (let k = 0; k < 7; k++) {
      const place = [at[0] + r * 7 * (draw() - 0.5), at[1] + r * 5 * (draw() - 0.5)] as const;
      const strength = 0.5 + 0.4 * draw();
      stamp(size, place, [r * (0.2 + 0.5 * draw()), 0.0028 + 0.002 * draw()], (t, d) => {
        dark[t] = Math.max(dark[t]!, strength * smoothstep(1, 0.3, d));
        height[t] = height[t]! - 0.1 * smoothstep(1, 0.3, d);
      });
    }
    stamp(size, [at[0], at[1] + r * 0.3], [r * 3, r * 2.1], (t, d, dx, dy) => {
      const u = (t % size) / size;
      const v = Math.floor(t / size) / size;
      const line = Math.abs(d - 0.74 + 0.32 * dx * dx + 0.05 * ragged(u, v));
      const brow = smoothstep(0.13, 0.02, line) * smoothstep(0.05, 0.4, dy + 0.1) * smoothstep(1, 0.7, Math.abs(dx));
      dark[t] = Math.max(dark[t]!, 0.75 * brow * (0.7 + 0.6 * Math.abs(ragged(v, u))));
    });
  }
  return relief;
}
