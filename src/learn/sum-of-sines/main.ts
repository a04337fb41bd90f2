import { mountFigures } from '../figure.ts';
import { inText } from '../live-text.ts';
import { field } from './field.ts';
import { gust } from './gust.ts';
import { lean } from './lean.ts';
import { sharpness } from './sharpness.ts';
import { spectrum } from './spectrum.ts';
import { upwind } from './upwind.ts';
import { wave } from './wave.ts';

mountFigures([field, wave, upwind, sharpness, lean, spectrum, gust].map(inText));
