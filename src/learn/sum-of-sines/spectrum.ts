import { kaimalDensity } from '../../core/wind/kaimal.ts';
import { dominantFrequency, type Spectrum, spectrumOf } from '../../core/wind/spectrum.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { AskedWind, someWaves, windOf } from './waves.ts';

const RATE = 12;
const SECONDS = 1400;
/** Mean wind and length of the eddies along it at 10 m: 8.1 times 0.7 of the height (IEC 61400-1). */
const MEAN_SPEED = 4.4;
const EDDY = 8.1 * 0.7 * 10;
/** Powers of ten that are shown. */
const X = [-2, 0.6] as const;
const Y = [-8, 0] as const;

interface Made {
  readonly values: Values;
  readonly spectrum: Spectrum;
  readonly variance: number;
  readonly lines: readonly number[];
}

function make(values: Values): Made {
  const waves = someWaves(numberOf(values, 'waves'), numberOf(values, 'sharpness'), 0, 1);
  const asked = new AskedWind(windOf(waves));
  const signal = Float64Array.from({ length: RATE * SECONDS }, (_, i) => asked.at(0, 0, i / RATE)[0]);
  const mean = signal.reduce((sum, v) => sum + v, 0) / signal.length;
  const variance = signal.reduce((sum, v) => sum + (v - mean) ** 2, 0) / signal.length;
  return {
    values,
    spectrum: spectrumOf(signal, RATE, 4096),
    variance,
    lines: waves.map(({ speed, wavelength }) => speed / wavelength),
  };
}

class Spectra extends PlaneFigure {
  #made: Made | null = null;

  draw(values: Values): Record<string, string> {
    if (this.#made?.values !== values) this.#made = make(values);
    const { spectrum, variance, lines } = this.#made;
    const plane = this.plane;
    const { force, rest, soft, velocity } = this.host.colours();
    plane.begin({ x: X, y: Y, margin: { left: 52, bottom: 40, top: 14, right: 16 } });
    this.#decades();
    const log = (v: number): number => Math.log10(Math.max(v, 1e-30));
    const points: Point[] = [];
    for (let i = 1; i < spectrum.frequency.length; i++) {
      const x = log(spectrum.frequency[i] ?? 0);
      if (x >= X[0] && x <= X[1]) points.push([x, Math.max(Y[0], log(spectrum.power[i] ?? 0))]);
    }
    plane.area([[X[0], Y[0]], ...points, [X[1], Y[0]]], { colour: force, alpha: 0.13 });
    plane.polyline(points, { colour: force, width: 2 });
    const real = (x: number): number => log(variance * kaimalDensity(10 ** x, EDDY, MEAN_SPEED));
    plane.graph(real, { colour: rest, width: 2, dash: [7, 4] });
    plane.text([0.1, real(0.1)], 'real wind', { colour: rest, shift: [8, -8] });
    for (const hertz of lines)
      plane.line([log(hertz), Y[0]], [log(hertz), Y[0] + 0.35], { colour: velocity, width: 3 });
    plane.text([X[0], Y[0]], 'c/λ', { colour: velocity, italic: true, size: 13, shift: [6, -8] });
    const at = numberOf(values, 'marker');
    const read = this.#read(at);
    plane.line([log(at), Y[0]], [log(at), Y[1]], { colour: soft, width: 1, dash: [2, 4] });
    const strongest = dominantFrequency(spectrum);
    return {
      strongest: strongest === null ? '–' : strongest.toFixed(3),
      line: (lines[0] ?? 0).toFixed(3),
      power: scientific(read),
      real: scientific(variance * kaimalDensity(at, EDDY, MEAN_SPEED)),
    };
  }

  handles(values: Values) {
    const at = numberOf(values, 'marker');
    return [
      this.plane.handle({
        id: 'marker',
        label: 'Frequency',
        at: [Math.log10(at), Math.max(Y[0], Math.log10(Math.max(this.#read(at), 1e-30)))],
        ways: 'across',
        said: `${at.toFixed(2)} hertz`,
        move: (x) => this.host.set('marker', 10 ** x),
      }),
    ];
  }

  text(): string {
    return 'The sines are narrow lines with overtones; real wind falls evenly.';
  }

  /** Power at a frequency. */
  #read(hertz: number): number {
    const spectrum = this.#made?.spectrum;
    if (!spectrum) return 0;
    const step = (spectrum.frequency[1] ?? 1) - (spectrum.frequency[0] ?? 0);
    return spectrum.power[Math.min(spectrum.power.length - 1, Math.round(hertz / step))] ?? 0;
  }

  #decades(): void {
    const plane = this.plane;
    const { hairline, soft, line } = this.host.colours();
    for (let decade = -2; decade <= 0; decade++) {
      plane.line([decade, Y[0]], [decade, Y[1]], { colour: hairline, width: 1 });
      plane.text([decade, Y[0]], String(10 ** decade), {
        colour: soft,
        size: 12,
        align: 'center',
        baseline: 'top',
        shift: [0, 6],
      });
    }
    for (let decade = Y[0]; decade <= Y[1]; decade += 2) {
      plane.line([X[0], decade], [X[1], decade], { colour: hairline, width: 1 });
      plane.text([X[0], decade], `10${superscript(decade)}`, {
        colour: soft,
        size: 12,
        align: 'right',
        baseline: 'middle',
        shift: [-6, 0],
      });
    }
    plane.polyline(
      [
        [X[0], Y[1]],
        [X[0], Y[0]],
        [X[1], Y[0]],
      ],
      { colour: line, width: 1 },
    );
    plane.text([X[1], Y[0]], 'hertz', { size: 12, align: 'right', baseline: 'top', shift: [0, 22] });
    plane.text([X[0], Y[1]], 'power, m²/Hz', { size: 12, baseline: 'top', shift: [8, 0] });
  }
}

const superscript = (n: number): string =>
  String(n)
    .replace('-', '⁻')
    .replace(/\d/g, (d) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(d)] ?? d);

/** A number as 1.2·10⁻³. */
function scientific(x: number): string {
  const [digits, exponent] = x.toExponential(1).split('e');
  return `${digits}·10${superscript(Number(exponent))}`;
}

/** The spectrum of the force beside that of real wind. */
export const spectrum: FigureSpec = {
  id: 'spectrum',
  title: 'How much of each frequency',
  aspect: 1.8,
  controls: [
    { id: 'waves', label: 'Waves', min: 1, max: 4, step: 1, value: 4 },
    { id: 'sharpness', label: 'Sharpness k', min: 0.5, max: 6, step: 0.1, value: 2.2 },
    { id: 'marker', label: 'Read at', unit: 'Hz', min: 0.02, max: 3, step: 0.01, value: 0.14 },
  ],
  readouts: [
    { id: 'strongest', label: 'Strongest, measured', unit: 'Hz' },
    { id: 'line', label: 'c/λ of the first wave', unit: 'Hz' },
    { id: 'power', label: 'Sines there', unit: 'm²/Hz' },
    { id: 'real', label: 'Real wind there', unit: 'm²/Hz' },
  ],
  stage: (host) => new Spectra(host),
};
