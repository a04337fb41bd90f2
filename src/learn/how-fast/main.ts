import { mountFigures } from '../figure.ts';
import { inText } from '../live-text.ts';
import { NOISE_FIGURE } from './figure-noise.ts';
import { QUEUE_FIGURE } from './figure-queue.ts';
import { rateFigure } from './figure-rates.ts';
import { Measured } from './measured.ts';
import { fillOwnCells } from './own-cells.ts';
import { Panel } from './panel.ts';
import { CPU_FRAMES, CPU_STEPS, PAPER_FRAMES, PAPER_STEPS } from './paper-figures.ts';

const measured = new Measured();

const frames = rateFigure(
  {
    kind: 'frames',
    title: 'Frames a second by vertices',
    things: 'vertices',
    view: 'wireframe',
    done: 'frames',
    machine: 'GeForce 6800 GT',
    paper: PAPER_FRAMES,
    other: CPU_FRAMES,
    otherName: 'no graphics card',
    sizes: [10_000, 1_500_000],
    rates: [0.5, 1000],
    size: { min: 10, max: 1340, step: 5, value: 165 },
  },
  measured,
);

const steps = rateFigure(
  {
    kind: 'steps',
    title: 'Steps of the wind a second by branches',
    things: 'branches',
    view: 'control',
    done: 'steps',
    machine: 'GeForce 7900 GTX',
    paper: PAPER_STEPS,
    other: CPU_STEPS,
    otherName: 'no graphics card',
    sizes: [4000, 300_000],
    rates: [5, 10_000],
    size: { min: 4, max: 300, step: 1, value: 66 },
  },
  measured,
);

mountFigures([frames, steps, QUEUE_FIGURE, NOISE_FIGURE].map(inText));
fillOwnCells(measured);
new Panel(document.querySelector<HTMLElement>('#measuring') as HTMLElement, measured);
