import type { GroveForm, GroveTicket, GrownGrove } from '../../worker/grove-client.ts';
import { type Cell, MIDDLE_CELL, NEAR_CELL } from './cells.ts';
import type { Grove } from './grove.ts';

/** The trees of one species in a unit: what the worker gives, or what is drawn. */
export interface Part {
  readonly species: number;
  /** Ranks of its trees in the forest, in the order of the grove. */
  readonly ranks: readonly number[];
  ticket: GroveTicket | null;
  grown: GrownGrove | null;
  grove: Grove | null;
}

/** All trees of a cell in one form: what is grown, shown and freed together. */
export class GroveUnit {
  readonly key: string;
  readonly form: GroveForm;
  readonly cell: Cell;
  readonly side: number;
  /** The middle unit around a near one. */
  readonly parent: GroveUnit | null;
  readonly children: GroveUnit[] = [];
  state: 'none' | 'growing' | 'there' = 'none';
  wanted = false;
  inView = false;
  /** Height of its tallest tree at its nearest place, pixels. */
  pixels = 0;
  /** Part of it that has faded in, 0..1. */
  come = 0;
  /** How often growing it came to nothing; after TRIES it is not asked for again, and its trees stay in the coarser class. */
  failures = 0;
  parts: Part[] = [];

  constructor(form: GroveForm, cell: Cell, parent: GroveUnit | null) {
    this.form = form;
    this.cell = cell;
    this.parent = parent;
    this.side = form === 'full' ? NEAR_CELL : MIDDLE_CELL;
    this.key = `${form} ${cell.index}`;
    parent?.children.push(this);
  }

  /** Its parts, without anything in them. */
  begin(): void {
    this.state = 'growing';
    this.come = 0;
    this.parts = [...this.cell.bySpecies].map(([species, ranks]) => ({
      species,
      ranks,
      ticket: null,
      grown: null,
      grove: null,
    }));
  }

  get bytes(): number {
    return this.parts.reduce((sum, { grove }) => sum + (grove?.stats().bytes ?? 0), 0);
  }

  /** Frees all of it; what is being grown is called off. */
  drop(): void {
    for (const { ticket, grove } of this.parts) {
      ticket?.cancel();
      grove?.removeFromParent();
      grove?.dispose();
    }
    this.parts = [];
    this.state = 'none';
    this.come = 0;
  }
}
