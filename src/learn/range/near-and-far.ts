import { type FigureHost, type FigureSpec, type FigureStage, numberOf, switchOf } from '../figure.ts';
import { treeStage } from '../tree-stage.ts';

const count = (n: number): string => Math.round(n).toLocaleString('en');

/** The aspen seen from close by, drawn as the paper would draw it from afar. */
function stage(host: FigureHost): FigureStage {
  let asked = false;
  return treeStage({
    pixels: 1,
    place: 'meadow',
    show: () => ({ species: 'quaking-aspen', seed: 1, wind: 'breeze' }),
    dress: ({ tree }, values) => {
      tree.degradation = switchOf(values, 'rules') ? 'paper' : 'screen';
      Object.assign(tree.paperRange, {
        quality: numberOf(values, 'quality'),
        season: 'summer',
        r2: numberOf(values, 'range'),
      });
      if (asked) return;
      asked = true;
      // The code that draws by the rules comes when it is first asked for.
      void tree.degradationLoaded().then(() => host.redraw());
    },
    readouts: ({ tree }) => {
      const drawn = tree.elementsDrawn;
      if (!drawn) return { triangles: count(tree.stats().triangles), lines: 'none', points: 'none' };
      return {
        triangles: count(drawn.trunkTriangles + drawn.mainTriangles + drawn.otherTriangles + drawn.leafTriangles),
        lines: count(drawn.trunkLines + drawn.mainLines + drawn.otherLines),
        points: count(drawn.leafPoints),
      };
    },
    text: (values) =>
      `An aspen from close by, drawn as the paper draws it from ${numberOf(values, 'range')} metres${switchOf(values, 'rules') ? '' : ', with the rules off'}.`,
  })(host);
}

/** What the rules leave of a tree. */
export const nearAndFar: FigureSpec = {
  id: 'near-and-far',
  title: 'What is left of an aspen',
  aspect: 1.05,
  moves: true,
  controls: [
    { id: 'range', label: 'As from', unit: 'm', min: 5, max: 1200, step: 5, value: 240 },
    { id: 'quality', label: 'Quality', min: 0.1, max: 2, step: 0.05, value: 1 },
    { id: 'rules', label: 'By the rules of the paper', value: true },
  ],
  readouts: [
    { id: 'triangles', label: 'Triangles' },
    { id: 'lines', label: 'Lines' },
    { id: 'points', label: 'Points' },
  ],
  // The editor has other ways to draw a far tree: there it is as far as the slider says.
  open: (values) => `s=quaking-aspen&seed=1&wind=breeze&cam=0,3,${numberOf(values, 'range')},0,6,0`,
  page: {
    name: 'Open from afar',
    address: (values) =>
      `range.html?range=${numberOf(values, 'range')}&quality=${Math.min(1, numberOf(values, 'quality'))}&near=0${switchOf(values, 'rules') ? '' : '&draw=screen'}`,
  },
  stage,
};
