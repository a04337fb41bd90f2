import { middleTree } from '../core/forest/middle-tree.ts';
import { groveService } from './grove-service.ts';
import { offer } from './remote.ts';

offer(groveService({ middle: middleTree }));
