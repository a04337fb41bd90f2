import { offer } from './remote.ts';
import { growService } from './service.ts';

offer(growService);
