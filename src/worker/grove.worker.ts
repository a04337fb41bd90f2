import { expose } from 'comlink';
import { middleTree } from '../core/forest/middle-tree.ts';
import { groveService } from './grove-service.ts';

expose(groveService({ middle: middleTree }));
