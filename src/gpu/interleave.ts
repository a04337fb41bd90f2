/** Something to time: `run` does it once, `wait` returns when it is done. */
export interface Subject {
  readonly name: string;
  run(): void;
  wait(): void;
}

/** Milliseconds of one run of each subject: median and least over the rounds. */
export interface Timing {
  readonly name: string;
  readonly median: number;
  readonly least: number;
  /** Median over the rounds of this subject's time by the first one's of the same round: other load on the machine cancels out. */
  readonly ratio: number;
}

const median = (values: number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];

/** Times subjects in turn, A B C A B C, each as often a round as fills `milliseconds`; a warm-up goes before. */
export function interleave(subjects: readonly Subject[], rounds = 9, milliseconds = 60): Timing[] {
  const time = (subject: Subject, times: number): number => {
    const start = performance.now();
    for (let i = 0; i < times; i++) subject.run();
    subject.wait();
    return (performance.now() - start) / times;
  };
  const times = subjects.map((subject) => {
    time(subject, 2);
    return Math.max(1, Math.round(milliseconds / time(subject, 2)));
  });
  const taken = subjects.map((): number[] => []);
  for (let round = 0; round < rounds; round++) {
    subjects.forEach((subject, i) => {
      taken[i].push(time(subject, times[i]));
    });
  }
  return subjects.map((subject, i) => ({
    name: subject.name,
    median: median(taken[i]),
    least: Math.min(...taken[i]),
    ratio: median(taken[i].map((value, round) => value / taken[0][round])),
  }));
}
