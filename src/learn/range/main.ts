import { mountFigures } from '../figure.ts';
import { inText } from '../live-text.ts';
import { shippedSpecies } from '../tree-stage.ts';
import { hillside } from './hillside.ts';
import { nearAndFar } from './near-and-far.ts';
import { prefix } from './prefix.ts';
import { rules } from './rules.ts';

mountFigures([nearAndFar, rules, prefix(await shippedSpecies('quaking-aspen')), hillside].map(inText));
