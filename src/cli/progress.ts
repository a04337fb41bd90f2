import type { Streams } from './streams.ts';

const WIDTH = 24;
/** Where there is no terminal a line is written this often at most, milliseconds. */
const EVERY = 5000;

/** Shows how far a bake is: a bar that moves, or now and then a line where there is no terminal. */
export class Progress {
  private readonly streams: Streams;
  private readonly all: number;
  private readonly before: number;
  private readonly began = performance.now();
  private shown = this.began;

  /** `before`: trees that were done when it began. */
  constructor(streams: Streams, all: number, before: number) {
    this.streams = streams;
    this.all = all;
    this.before = before;
  }

  show(done: number, failed: number): void {
    const { progress, err } = this.streams;
    const now = performance.now();
    if (!progress && now - this.shown < EVERY) return;
    this.shown = now;
    const text = this.text(done, failed, now);
    if (progress) {
      const filled = Math.round((WIDTH * done) / Math.max(1, this.all));
      progress(`${'█'.repeat(filled)}${'░'.repeat(WIDTH - filled)} ${text}`);
    } else err(text);
  }

  end(): void {
    this.streams.progress?.('');
  }

  private text(done: number, failed: number, now: number): string {
    const rate = (done - this.before) / Math.max(1e-3, (now - this.began) / 60_000);
    const left = rate > 0 ? Math.ceil((60 * (this.all - done)) / rate) : 0;
    const parts = [`${done} of ${this.all} trees`, `${Math.round(rate)} a minute`, `${timeText(left)} left`];
    return [...parts, ...(failed > 0 ? [`${failed} could not be grown`] : [])].join(', ');
  }
}

function timeText(seconds: number): string {
  if (seconds < 60) return `${seconds} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 120 ? `${minutes} min` : `${Math.round(minutes / 60)} h`;
}
