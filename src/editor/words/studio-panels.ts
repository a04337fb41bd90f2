// The panels of the wind studio; what its drawer says is in words/studio.ts, what is said of a probe in words/probe.ts.
export const plotWords = {
  group: 'Over time',
  force: ['Force', 'Force of the wind at the probe over time; the summary says it in words'],
  displacement: ['Displacement', 'Displacement of the branch over time'],
  velocity: ['Velocity', 'Velocity of the branch over time'],
  spectrum: ['Spectrum', 'Spectra of force and displacement'],
  spectrumUnit: 'dB over Hz',
  phase: ['Phase portrait', 'Phase portrait: velocity against displacement along the wind, the newest place as a dot'],
  phaseUnit: (velocity: string, length: string): string => `${velocity}/s over ${length}`,
  lines: {
    strength: 'strength',
    acrossWind: 'across the wind',
    alongWind: 'along the wind',
    across: 'across',
    force: 'force',
    displacement: 'displacement',
  },
  own: (hertz: string): string => `own ${hertz} Hz`,
  marked: 'Time marked in the plots',
  markedAt: (time: number, force: string | null): string =>
    `${time.toFixed(2)} seconds${force === null ? '' : `, force ${force} metres a second`}`,
  summary: 'Summary of the plots',
  listening: 'The probe is listening.',
  spectrumCsv: 'Spectrum as CSV',
  table: 'Data table',
  closeTable: 'Close the table',
  data: 'Data of the plots',
  caption: 'Once a second, as it was when this table was opened.',
  anew: 'Take it anew',
} as const;

export const fieldWords = {
  title: 'Field',
  small: (metres: number): string =>
    `Map of the wind around the tree at the time that the plots mark, ${metres} metres wide. The tab Field has it larger.`,
  map: (metres: number): string =>
    `Map of the wind around the tree, ${metres} metres wide. Arrow keys move a cursor, Enter throws a gust there.`,
  width: 'Metres across',
  how: 'Click the map to throw a gust from there at the tree. The ring is the crown, the small ring the probe, the wedge where you stand.',
  scale: (most: string): string => `Colours from 0 to ${most} metres a second`,
  scaleSays: 'Beaufort above, metres a second below',
  beaufort: (number: number, name: string): string => `Beaufort ${number}, ${name}`,
  atTree: (time: number, speed: string): string => `${time.toFixed(2)}\u2009s: ${speed}\u2009m/s at the tree`,
  place: (x: number, y: number): string => `${x.toFixed(0)}\u2009m right, ${y.toFixed(0)}\u2009m away`,
  tree: 'At the tree',
  reading: (time: number, where: string, speed: string, name: string, number: number): string =>
    `${time.toFixed(1)}\u2009s. ${where}: ${speed}\u2009m/s, ${name.toLowerCase()} (${number}).`,
} as const;

export const textureWords = {
  none: 'There are no state textures to show: this picture is drawn without the GPU.',
  reading: 'Reading the textures back from the GPU…',
  texture: 'Texture',
  show: 'Show',
  colours: 'x y z as colours',
  coloursSay: 'Red, green and blue are x, y and z between the least and the greatest of the tree.',
  size: (width: number, height: number, pieces: number): string =>
    `${width} × ${height} texels, ${pieces} pieces, sorted by depth and then by parent.`,
  image: (id: string): string =>
    `Texture ${id}, a texel a piece. Arrow keys go from texel to texel, Enter puts the probe there.`,
  point:
    'Point at a texel: its branch lights up in the picture, and the other way round. A click puts the probe there.',
  piece: (piece: number): string => `Piece ${piece}`,
  level: (level: number): string => `level ${level}`,
  said: (piece: number, place: string): string => `Piece ${piece}, ${place}`,
} as const;

export const comparedWords = {
  models: { direct: 'direct', spring: 'springs', sway: 'sway' },
  wind: (name: string, model: string, lagged: boolean): string => `${name}, ${model}${lagged ? ', lagged' : ''}`,
  about:
    'Two winds, or two models, on the same tree at the same time: side by side in the picture, and their difference as a plot.',
  springsDirect: 'Springs against direct',
  directSprings: 'Direct against springs',
  swaySprings: 'Sway against springs',
  laggedExact: 'Lagged against exact',
  exactLagged: 'Exact against lagged',
  itself: 'This wind against itself, to be changed',
  layout: 'Show',
  split: 'Split',
  splitTitle: 'One picture, A left and B right of a line that can be dragged',
  beside: 'Side by side',
  edit: 'The mixer changes',
  isB: 'B is',
  windB: 'Wind B',
  own: (name: string): string => `${name}, own`,
  swap: 'Swap',
  swapTitle: 'A becomes B, and B becomes A',
  copy: 'Copy A to B',
  copyTitle: 'B becomes what A is',
  alone: 'A alone',
  both: ['Displacement along the wind', 'Displacement of the probed branch in both winds over time'],
  difference: ['Difference', 'Difference of the two displacements over time'],
  less: 'B less A',
  apart: (rms: string, greatest: string, of: string): string =>
    `B differs from A by ${rms} (root mean square) and at most ${greatest}; A itself is ${of} from its rest.`,
  nothing: 'Nothing to compare yet.',
} as const;

export const anemometerWords = {
  measured: 'measured',
  from: 'comes from',
  about:
    'Let a measured wind blow: a CSV file with a time, a speed and, where there is one, the direction that it comes from. Its header names the columns and their units.',
  open: 'Open a CSV file…',
  sample: 'The sample that comes with Windgrove',
  speed: ['Speed', 'Measured speed over the length of the record'],
  direction: ['Direction', 'Direction that the measured wind comes from'],
  directionUnit: '° clockwise from north',
  example: 'Such a file begins like this',
  exampleSays:
    'Directions are where the wind comes from, clockwise from north: 270° is a west wind. It can also be dropped on the page.',
  figures: (samples: number, rate: string, seconds: string, mean: string, most: string): string =>
    `: ${samples} samples, ${rate} a second, ${seconds}\u2009s. Mean ${mean}\u2009m/s, at most ${most}\u2009m/s. It plays around and around.`,
  stop: 'Stop it',
  play: 'Play it',
  playBeside: 'Play it beside the waves',
  playAlone: 'Play it alone',
  asMeasured: 'As it was measured, around and around.',
  error: 'Error:',
  notOpened: (name: string): string => `${name} was not opened`,
  more: (count: number): string => `${count} more like these.`,
  close: 'Close this message',
  isOpen: (name: string, samples: number): string => `${name} is open; ${samples} samples`,
  bytes: (found: number): string => `${found} bytes`,
  most: (most: number): string => `at most ${most}`,
} as const;
