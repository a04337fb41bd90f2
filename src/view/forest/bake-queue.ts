import type { WebGLRenderer } from 'three';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import { PassState } from '../../gpu/pass-state.ts';

/** A layer of an atlas that is to show a tree. */
export interface BakeJob {
  readonly layer: number;
  readonly tree: PackedTree;
  readonly species: Species;
}

/** Layers that wait for their pictures, taken one picture at a time so that no frame waits long. */
export class BakeQueue<Job extends BakeJob> {
  readonly #state = new PassState();
  readonly #ready = new Set<number>();
  readonly #step: (renderer: WebGLRenderer, job: Job) => boolean;
  #jobs: Job[] = [];

  /** `step` takes one picture of a job, or stores what was taken: then it is done, and says so. */
  constructor(step: (renderer: WebGLRenderer, job: Job) => boolean) {
    this.#step = step;
  }

  /** Is everything that was asked for baked? */
  get idle(): boolean {
    return this.#jobs.length === 0;
  }

  /** Can the layer be drawn? */
  ready(layer: number): boolean {
    return this.#ready.has(layer);
  }

  /** Asks for a layer; a former wish for it is forgotten. One that is ready stays so meanwhile. */
  add(job: Job): void {
    this.#jobs = this.#jobs.filter(({ layer }) => layer !== job.layer);
    this.#jobs.push(job);
  }

  /** Takes pictures for about `ms` milliseconds, one at least where one is left. */
  work(renderer: WebGLRenderer, ms: number): void {
    if (this.idle) return;
    const began = performance.now();
    this.#state.begin(renderer);
    try {
      do {
        const job = this.#jobs[0] as Job;
        if (!this.#step(renderer, job)) continue;
        this.#ready.add(job.layer);
        this.#jobs.shift();
      } while (this.#jobs.length > 0 && performance.now() - began < ms);
    } finally {
      this.#state.end(renderer);
    }
  }

  clear(): void {
    this.#jobs = [];
  }
}
