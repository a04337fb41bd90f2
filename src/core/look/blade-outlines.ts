import { type HalfOutline, outline } from './leaf-outline.ts';

/** Narrow, widest below the middle, with a long point: willow, olive, bamboo, peach. */
export const LANCE = outline(
  'lance',
  [
    [0, 0],
    [0.17, 0.06],
    [0.37, 0.19],
    [0.5, 0.38],
    [0.45, 0.56],
    [0.3, 0.75],
    [0.12, 0.91],
    [0, 1],
  ],
  [
    [0, 0],
    [0.46, 0.3],
    [0.36, 0.68],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.42],
    [0, 1],
  ],
);

/** A heart with a drawn-out tip: lime, redbud, catalpa. */
export const HEART = outline(
  'heart',
  [
    [0, 0],
    [0.1, -0.07],
    [0.26, -0.09],
    [0.42, 0],
    [0.5, 0.16],
    [0.47, 0.34],
    [0.35, 0.56],
    [0.19, 0.76],
    [0.06, 0.89],
    [0, 1],
  ],
  [
    [0, 0],
    [0.28, -0.09],
    [0.5, 0.16],
    [0.33, 0.58],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.14],
    [0, 1],
  ],
);

/** Deeply cut into seven pointed lobes: Japanese maple. */
export const SEVEN_LOBES = outline(
  'maple, seven lobes',
  [
    [0, 0],
    [0.1, 0],
    [0.28, -0.07],
    [0.21, 0.06],
    [0.14, 0.12],
    [0.32, 0.12],
    [0.5, 0.22],
    [0.34, 0.28],
    [0.16, 0.27],
    [0.3, 0.42],
    [0.43, 0.64],
    [0.25, 0.56],
    [0.09, 0.41],
    [0.13, 0.62],
    [0.07, 0.84],
    [0, 1],
  ],
  [
    [0, 0],
    [0.28, -0.06],
    [0.17, 0.12],
    [0.5, 0.23],
    [0.19, 0.3],
    [0.43, 0.64],
    [0.12, 0.5],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.34],
    [0, 1],
  ],
);

/** Three blunt lobes above a wedge: the cut leaf of sassafras. */
export const MITTEN = outline(
  'sassafras, three lobes',
  [
    [0, 0],
    [0.09, 0.1],
    [0.19, 0.26],
    [0.34, 0.42],
    [0.46, 0.56],
    [0.5, 0.68],
    [0.44, 0.74],
    [0.32, 0.7],
    [0.19, 0.58],
    [0.21, 0.72],
    [0.18, 0.87],
    [0.09, 0.97],
    [0, 1],
  ],
  [
    [0, 0],
    [0.19, 0.26],
    [0.5, 0.66],
    [0.2, 0.6],
    [0.2, 0.84],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.62],
    [0, 1],
  ],
);

/** Half width of a birch leaf at (z, x): wide near the base, with a point. */
const BIRCH: HalfOutline = [
  [0, 0],
  [0.28, 0.05],
  [0.44, 0.16],
  [0.49, 0.31],
  [0.45, 0.47],
  [0.34, 0.64],
  [0.19, 0.8],
  [0.07, 0.92],
  [0, 1],
];

/** Teeth along a margin: at each point of it a tip, and a notch before the next. */
function toothed(smooth: HalfOutline): HalfOutline {
  const out: (readonly [number, number])[] = [smooth[0]!];
  for (let i = 1; i + 1 < smooth.length; i++) {
    const [x, z] = smooth[i]!;
    const [x1, z1] = smooth[i + 1]!;
    out.push([x, z + 0.015]);
    // The notch lies further in and nearer to its own tooth: teeth point to the tip of the leaf.
    if (i + 2 < smooth.length) out.push([(0.62 * x + 0.38 * x1) * 0.9, 0.7 * z + 0.3 * z1]);
  }
  return [...out, smooth[smooth.length - 1]!];
}

/** An oval with saw teeth: birch, elm, cherry. */
export const TOOTHED = outline(
  'toothed oval',
  toothed(BIRCH),
  [
    [0, 0],
    [0.48, 0.2],
    [0.36, 0.62],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.34],
    [0, 1],
  ],
);

/** Long with nearly even sides: a leaflet of a palm. */
export const STRAP = outline(
  'palm leaflet',
  [
    [0, 0],
    [0.3, 0.03],
    [0.48, 0.16],
    [0.5, 0.36],
    [0.42, 0.58],
    [0.26, 0.8],
    [0.1, 0.94],
    [0, 1],
  ],
  [
    [0, 0],
    [0.46, 0.14],
    [0.42, 0.6],
    [0, 1],
  ],
  [
    [0, 0],
    [0.44, 0.16],
    [0.42, 0.6],
    [0, 1],
  ],
);

/** As wide at the foot as in the middle, running out in a long point: grass, reed. */
export const GRASS = outline(
  'grass blade',
  [
    [0, 0],
    [0.38, 0.01],
    [0.48, 0.2],
    [0.5, 0.4],
    [0.42, 0.6],
    [0.27, 0.78],
    [0.1, 0.93],
    [0, 1],
  ],
  [
    [0, 0],
    [0.42, 0.02],
    [0.5, 0.36],
    [0.3, 0.7],
    [0, 1],
  ],
  [
    [0, 0],
    [0.46, 0.1],
    [0.42, 0.58],
    [0, 1],
  ],
);

/** Widest towards the tip: a leaflet of a horse chestnut. */
export const OBOVATE = outline(
  'obovate leaflet',
  [
    [0, 0],
    [0.22, 0.3],
    [0.47, 0.6],
    [0.42, 0.78],
    [0.12, 0.92],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.62],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.62],
    [0, 1],
  ],
);

/** Each of the three leaflets of the paper's leaf shape 5 (Weber & Penn 1995, 4.9), drawn by Windgrove. */
export const LEAFLET_OF_THREE = outline(
  'three leaflets',
  [
    [0, 0],
    [0.22, 0.08],
    [0.44, 0.3],
    [0.48, 0.52],
    [0.3, 0.78],
    [0.1, 0.94],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.32],
    [0.44, 0.68],
    [0, 1],
  ],
  [
    [0, 0],
    [0.62, 0.5],
    [0, 1],
  ],
);

/** A leaflet of an ash or walnut. */
export const LEAFLET = outline(
  'leaflet',
  [
    [0, 0],
    [0.36, 0.12],
    [0.5, 0.36],
    [0.32, 0.7],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.36],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.36],
    [0, 1],
  ],
);

/** A needle from some way off: one triangle, widest at its base. */
export const SPIKE: HalfOutline = [
  [0.5, 0],
  [0, 1],
];

/** A needle, or a branchlet covered with scales. */
export const NEEDLE = outline(
  'needle',
  [
    [0, 0],
    [0.5, 0.12],
    [0.44, 0.74],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.4],
    [0, 1],
  ],
  [
    [0, 0],
    [0.5, 0.4],
    [0, 1],
  ],
);
