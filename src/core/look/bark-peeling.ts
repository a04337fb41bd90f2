import { cloud, drawer, noise, paint, type Relief, smoothstep, stamp } from './bark-relief.ts';

/** Papery: chalk white with long lenticels around the stem, sheets that tear and curl along it, and black rough diamonds. */
export function peeling(size: number): Relief {
  const clouds = cloud(2, 4, 41, 3);
  const bands = noise(2, 34, 42);
  const tear = cloud(2, 11, 43, 2);
  const ragged = cloud(20, 14, 44, 3);
  const chalk = cloud(40, 90, 45, 2);
  const under = noise(4, 7, 46);
  const relief = paint(size, (u, v, out) => {
    const a = clouds(u, v);
    const b = bands(u, v + 0.01 * a);
    const c = chalk(u, v);
    const r = ragged(u, v);
    // Sheets end along level lines of a slow noise: the line is the torn rim, what lies below it is the tan layer beneath.
    const t = tear(u, v) + 0.05 * r;
    const open = smoothstep(0.06, 0.2, under(u, v));
    const bare = smoothstep(0.2, 0.215, t) * smoothstep(0.34, 0.225, t) * open;
    const rim = smoothstep(0.165, 0.2, t) * smoothstep(0.212, 0.2, t) * open;
    out.height = 0.55 + 0.1 * a + 0.05 * b + 0.02 * c + 0.3 * rim - 0.16 * bare;
    out.dark = 0.1 + 0.15 * a + 0.14 * Math.max(0, b) + 0.09 * c + 0.3 * bare + 0.1 * rim;
  });
  const { height, dark } = relief;
  const draw = drawer(47);
  for (let i = 0; i < 230; i++) {
    const l = draw();
    const strength = 0.35 + 0.5 * draw();
    const long = 0.006 + 0.085 * l * l * l;
    stamp(size, [draw(), draw()], [long, 0.0022 + 0.0016 * draw()], (t, d, dx) => {
      const f = strength * smoothstep(1, 0.4, d) * (0.75 + 0.25 * Math.abs(dx));
      dark[t] = Math.max(dark[t]!, f);
      height[t] = height[t]! + 0.14 * f;
    });
  }
  // Corky diamonds, longer than wide, cracked along their middle.
  const cork = cloud(26, 14, 48, 3);
  const fissure = noise(60, 12, 49);
  for (let i = 0; i < 6; i++) {
    const r = 0.02 + 0.05 * draw() * draw();
    const at = [draw(), (i + draw()) / 6] as const;
    const tall = 1.1 + 0.9 * draw();
    stamp(size, at, [r * 2.6, r * 2.6 * tall], (t, _, dx, dy) => {
      const u = (t % size) / size;
      const v = Math.floor(t / size) / size;
      const k = cork(u, v);
      const edge = Math.abs(dx) + Math.abs(dy) * 0.75 + 0.42 * k;
      const f = smoothstep(0.6, 0.48, edge);
      const split = smoothstep(0.22, 0.05, Math.abs(fissure(u, v))) * f;
      dark[t] = Math.max(dark[t]!, f * (0.72 + 0.5 * k) + 0.28 * split, 0.26 * smoothstep(0.85, 0.58, edge));
      height[t] = height[t]! + f * (0.16 + 0.4 * k) - 0.26 * split;
    });
  }
  // The dark brows that shed branches leave, thick in their middle.
  for (let i = 0; i < 3; i++) {
    const w = 0.04 + 0.035 * draw();
    const at = [draw(), (i + draw()) / 3] as const;
    stamp(size, at, [w, w * 0.8], (t, _, dx, dy) => {
      const u = (t % size) / size;
      const v = Math.floor(t / size) / size;
      const x = Math.abs(dx);
      const arm = Math.abs(dy - 0.35 + 0.8 * x * (0.6 + 0.4 * x) + 0.22 * cork(u, v));
      const f = smoothstep(1, 0.35, arm / Math.max(0.34 * (1 - x), 0.01));
      dark[t] = Math.max(dark[t]!, f * (0.75 + 0.4 * cork(u, v)));
      height[t] = height[t]! - 0.1 * f;
    });
  }
  return relief;
}
