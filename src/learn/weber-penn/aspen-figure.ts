import type { Species } from '../../core/species/species.ts';
import type { FigureHost } from '../figure.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { remembered } from './grown.ts';

/** A figure that draws in a plane what grows of an aspen with some of its parameters changed. */
export abstract class AspenFigure extends PlaneFigure {
  protected readonly aspen: Species;
  protected readonly grow = remembered();

  constructor(host: FigureHost, aspen: Species) {
    super(host);
    this.aspen = aspen;
  }
}
