import fc from 'fast-check';
import { beforeEach, describe, expect, test } from 'vitest';
import { type StateBackend, StateRun } from '../../src/gpu/state-run.ts';

/** The wind as far as the past matters: what blows is a number a step. */
class Source {
  revision = 1;
  epoch = 1;
  past = 1;
  wind = 0;
  /** A gust that blows from this step on. */
  gust = Number.POSITIVE_INFINITY;

  /** An edit while playing. */
  edit(wind: number): void {
    this.wind = wind;
    this.revision++;
    this.past++;
  }

  /** The past is to be as if the wind had always been this. */
  settle(wind = this.wind): void {
    this.edit(wind);
    this.epoch++;
  }

  /** Nothing changes before `step`. */
  throwGust(step: number): void {
    this.gust = step;
    this.revision++;
  }
}

/** A state that tells every step that led to it: "0 +1 +2", and `e` where the wind was edited. */
class Told implements StateBackend {
  readonly source: Source;
  latest = '';
  previous: string | null = null;
  readonly kept = new Map<number, string>();
  steps = 0;

  constructor(source: Source) {
    this.source = source;
  }

  #wind(step: number): string {
    return `${step}:${this.source.wind}${step >= this.source.gust ? 'g' : ''}`;
  }

  begin(step: number): void {
    this.latest = this.#wind(step);
    this.previous = null;
  }

  advance(step: number): void {
    this.previous = this.latest;
    this.latest = `${this.latest} ${this.#wind(step)}`;
    this.steps++;
  }

  back(): void {
    this.latest = this.previous!;
    this.previous = null;
  }

  save(slot: number): void {
    this.kept.set(slot, this.latest);
  }

  restore(slot: number): void {
    this.latest = this.kept.get(slot)!;
    this.previous = null;
  }
}

/** The state of `step` when the wind has always been `wind`. */
const always = (wind: number, step: number, gust = Number.POSITIVE_INFINITY): string =>
  Array.from({ length: step + 1 }, (_, n) => `${n}:${wind}${n >= gust ? 'g' : ''}`).join(' ');

let source: Source;
let told: Told;
let run: StateRun;

beforeEach(() => {
  source = new Source();
  told = new Told(source);
  run = new StateRun(told, 6, 40);
});

/** Runs until the state of `step` is there. */
function seek(step: number): void {
  for (let calls = 0; !run.reach(step, step, source); calls++) expect(calls).toBeLessThan(200);
}

function play(from: number, to: number): void {
  for (let step = from; step <= to; step++) expect(run.reach(step, step + 1, source)).toBe(true);
}

/** What a draw at `step` reads. */
const stateOf = (step: number) => (run.latest === step ? told.latest : told.previous);

describe('seeking is playing', () => {
  test('to a later step, an earlier one, one between two, whatever was shown before', () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 0, max: 500 }), { maxLength: 12 }), (steps) => {
        source = new Source();
        told = new Told(source);
        run = new StateRun(told, 6, 40);
        for (const step of steps) {
          seek(step);
          expect(run.has(step)).toBe(true);
          expect(stateOf(step)).toBe(always(0, step));
        }
      }),
    );
  });

  test('a way back runs from the checkpoint before it, not from the start', () => {
    play(0, 300);
    told.steps = 0;
    seek(290);
    expect(told.steps).toBeLessThan(16);
    expect(stateOf(290)).toBe(always(0, 290));
  });

  test('a far jump is run in slices, tells how far it is, and can change its aim', () => {
    expect(run.reach(100, 101, source)).toBe(false);
    expect(run.latest).toBe(40);
    expect(run.catchingUp).toBe(0.4);
    expect(run.reach(100, 101, source)).toBe(false);
    expect(run.catchingUp).toBe(0.8);
    expect(run.reach(30, 30, source)).toBe(true);
    expect(run.catchingUp).toBeNull();
    expect(stateOf(30)).toBe(always(0, 30));
  });

  test('what a draw between two steps needs is there: both of them, and no step is run twice', () => {
    play(0, 50);
    expect(told.steps).toBe(51);
    expect(run.has(50) && run.has(51)).toBe(true);
    expect(run.reach(51, 51, source)).toBe(true);
    expect(run.reach(50, 50, source)).toBe(true);
    expect(told.steps).toBe(51);
  });
});

describe('a run that begins near', () => {
  beforeEach(() => {
    run = new StateRun(told, 6, 40, true);
  });

  test('begins where it is asked for, in no steps, and plays on from there', () => {
    expect(run.reach(3000, 3001, source)).toBe(true);
    expect(told.steps).toBe(1);
    expect([run.pure, run.catchingUp]).toEqual([false, null]);
    play(3001, 3040);
    expect(told.latest.split(' ')).toHaveLength(42);
  });

  test('is what its past makes of it once it is settled, and after a seek', () => {
    expect(run.reach(100, 101, source)).toBe(true);
    run.settle();
    seek(100);
    expect(run.pure).toBe(true);
    expect(stateOf(100)).toBe(always(0, 100));
    run = new StateRun(told, 6, 40, true);
    expect(run.reach(100, 101, source)).toBe(true);
    seek(400);
    expect(stateOf(400)).toBe(always(0, 400));
  });

  test('always: no way is long, no end of a fade makes it jump, and nothing of the past is kept', () => {
    run = new StateRun(told, 6, 40, 'always');
    for (const step of [3000, 9000, 100]) {
      expect(run.reach(step, step + 1, source)).toBe(true);
      expect(told.latest.split(' ')).toHaveLength(2);
    }
    source.edit(7);
    play(101, 120);
    source.settle();
    run.settle();
    play(121, 150);
    expect(told.latest.split(' ')).toHaveLength(52);
    expect(told.kept.size).toBe(0);
  });

  test('a run that did not begin near is left alone by settling', () => {
    run = new StateRun(told, 6, 40);
    seek(120);
    source.edit(1);
    play(121, 130);
    const before = stateOf(130);
    run.settle();
    expect(run.reach(130, 131, source)).toBe(true);
    expect(stateOf(130)).toBe(before);
  });
});

describe('an edit while playing', () => {
  beforeEach(() => {
    play(0, 100);
    source.edit(7);
    play(101, 130);
  });

  test('goes on from the state that there is', () => {
    expect(run.pure).toBe(false);
    expect(stateOf(130)).toBe(`${always(0, 101)} ${always(7, 130).split(' ').slice(102).join(' ')}`);
  });

  test('a way back, a far way ahead, and a new epoch make the past that of the wind alone', () => {
    seek(100);
    expect(stateOf(100)).toBe(always(7, 100));
    expect(run.pure).toBe(true);
    source.edit(8);
    seek(400);
    expect(stateOf(400)).toBe(always(8, 400));
    source.edit(9);
    play(401, 405);
    source.settle();
    seek(405);
    expect(stateOf(405)).toBe(always(9, 405));
    expect(run.pure).toBe(true);
  });

  test('what it swung through is never sought back to', () => {
    play(131, 200);
    seek(120); // the past is the new wind's alone from here on
    for (const step of [300, 190, 150, 131]) {
      seek(step);
      expect(stateOf(step)).toBe(always(7, step));
    }
  });

  test('one frame back within the pair needs no run at all', () => {
    const { steps } = told;
    expect(run.reach(130, 130, source)).toBe(true);
    expect(told.steps).toBe(steps);
    expect(run.pure).toBe(false);
  });

  test('a model that comes into use while playing starts at rest in the wind of the moment', () => {
    run.rest(); // another model is in use for a while
    source.edit(8);
    expect(run.reach(1130, 1131, source)).toBe(true);
    expect(stateOf(1130)).toBe('1130:8');
    expect(run.pure).toBe(false);
  });
});

describe('a change from now on', () => {
  test('keeps the past, and takes back the step that was computed ahead', () => {
    play(0, 100); // 101 is computed, 100 and a bit is shown
    source.throwGust(101);
    play(100, 110);
    expect(run.pure).toBe(true);
    expect(stateOf(110)).toBe(always(0, 110, 101));
    seek(90);
    expect(stateOf(90)).toBe(always(0, 90));
    seek(110);
    expect(stateOf(110)).toBe(always(0, 110, 101));
  });

  test('after an edit goes on from the state that is shown, not from one ahead of it and not from the start', () => {
    play(0, 100);
    source.edit(7);
    play(101, 110); // 111 is computed
    const shown = stateOf(110);
    source.throwGust(111);
    expect(run.reach(110, 111, source)).toBe(true);
    expect(stateOf(110)).toBe(shown);
    expect(told.latest).toBe(`${shown} 111:7g`);
    expect(run.pure).toBe(false);
  });

  test('voids the checkpoints beyond it', () => {
    play(0, 200);
    seek(50);
    source.throwGust(60);
    seek(200);
    expect(stateOf(200)).toBe(always(0, 200, 60));
  });
});

describe('visits, for a pose that looks back on some steps', () => {
  const visited: (string | null)[] = [];
  const visit = (step: number) => visited.push(run.latest === step ? told.latest : `stands in: ${run.latest}`);
  beforeEach(() => {
    visited.length = 0;
  });

  test('each state is the latest while it is visited, after a jump as in play', () => {
    while (!run.reach(90, 93, source, visit)) expect(visited).toEqual([]);
    expect(visited).toEqual([90, 91, 92, 93].map((step) => always(0, step)));
    visited.length = 0;
    run.reach(94, 94, source, visit);
    expect(visited).toEqual([always(0, 94)]);
    visited.length = 0;
    run.reach(91, 94, source, visit);
    expect(visited).toEqual([91, 92, 93, 94].map((step) => always(0, step)));
  });

  test('one that was shown together with the next is visited itself, also after an edit', () => {
    play(0, 100);
    source.edit(3);
    play(101, 110); // 111 is computed
    const shown = stateOf(110);
    expect(run.reach(110, 110, source, visit)).toBe(true);
    expect(visited).toEqual([shown]);
  });

  test('after an edit the latest state stands in for those that are gone', () => {
    play(0, 100);
    source.edit(3);
    play(101, 110);
    expect(run.reach(107, 112, source, visit)).toBe(true);
    expect(visited).toHaveLength(6);
    expect(visited[0]).toBe('stands in: 111');
    expect(visited[5]).toBe(told.latest);
    expect(run.latest).toBe(112);
    expect(run.pure).toBe(false);
  });
});

test('after everything was lost the states are run again', () => {
  play(0, 60);
  told.kept.clear();
  run.forget();
  seek(55);
  expect(stateOf(55)).toBe(always(0, 55));
});

test('a wind that settles its fade when it is asked for its start is run once', () => {
  play(0, 100);
  source.edit(5);
  play(101, 140);
  const begin = told.begin.bind(told);
  let begun = 0;
  told.begin = (step) => {
    begun++;
    begin(step);
    if (begun === 1) source.settle();
  };
  seek(20);
  seek(21);
  seek(20);
  expect(begun).toBe(1);
  expect(stateOf(20)).toBe(always(5, 20));
});

test('a clock that counts from 1970 does not run for ever', () => {
  const step = 1.7e9 * 60;
  seek(step);
  expect(told.steps).toBe(4800);
});

test('hours into a wind a step and the next are of one run, whichever is looked at first', () => {
  const step = 1_000_000 * 60 + 1234;
  seek(step);
  const there = stateOf(step);
  const other = new Told(source);
  const fresh = new StateRun(other, 6, 40);
  while (!fresh.reach(step + 1, step + 1, source)) expect(other.steps).toBeLessThan(7200);
  expect(other.latest).toBe(`${there} ${step + 1}:0`);
});
