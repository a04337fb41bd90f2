import { mountFigures } from '../figure.ts';
import { shippedSpecies } from '../tree-stage.ts';
import { attraction } from './attraction.ts';
import { children } from './children.ts';
import { curve } from './curve.ts';
import { leaves } from './leaves.ts';
import { parts } from './parts.ts';
import { plates } from './plates.ts';
import { pruning } from './pruning.ts';
import { radius } from './radius.ts';
import { shapes } from './shapes.ts';
import { splits } from './splits.ts';

const aspen = await shippedSpecies('quaking-aspen');
mountFigures([
  plates,
  parts(aspen),
  curve,
  splits(aspen),
  shapes(aspen),
  children(aspen),
  radius,
  leaves(aspen),
  pruning(aspen),
  attraction,
]);
