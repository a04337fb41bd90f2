import { expose } from 'comlink';
import { growService } from './service.ts';

expose(growService);
