import type { FigureHost, FigureStage, Values } from './figure.ts';
import { Plane } from './plane.ts';

/** A figure that is drawn on one sheet of paper, and perhaps on more. */
export abstract class PlaneFigure implements FigureStage {
  protected readonly host: FigureHost;
  protected readonly plane: Plane;

  constructor(host: FigureHost) {
    this.host = host;
    this.plane = new Plane(host);
  }

  abstract draw(values: Values, time: number): Record<string, number | string>;
}
