import type { Species } from '../../core/species/species.ts';
import type { FigureHost, FigureStage, Values } from '../figure.ts';
import { Plane } from '../plane.ts';
import { remembered } from './grown.ts';

/** A figure that draws in a plane what grows of an aspen with some of its parameters changed. */
export abstract class AspenFigure implements FigureStage {
  protected readonly host: FigureHost;
  protected readonly aspen: Species;
  protected readonly plane: Plane;
  protected readonly grow = remembered();

  constructor(host: FigureHost, aspen: Species) {
    this.host = host;
    this.aspen = aspen;
    this.plane = new Plane(host);
  }

  abstract draw(values: Values): Record<string, string>;
}
