import { mountFigures } from '../figure.ts';
import { inText } from '../live-text.ts';
import { natural } from './natural.ts';
import { resonance } from './resonance.ts';
import { step } from './step.ts';
import { sway } from './sway.ts';
import { three } from './three.ts';
import { tree } from './tree.ts';

mountFigures([three, sway, step, natural, resonance, tree].map(inText));
