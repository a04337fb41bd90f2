import { mountFigures } from '../figure.ts';
import { inText } from '../live-text.ts';
import { attachment } from './attachment.ts';
import { bending } from './bending.ts';
import { impulse } from './impulse.ts';
import { lagged } from './lagged.ts';
import { passes } from './passes.ts';
import { textures } from './textures.ts';

mountFigures([textures, attachment, bending, impulse, lagged, passes].map(inText));
