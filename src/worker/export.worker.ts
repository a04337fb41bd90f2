import { exportService } from './export-service.ts';
import { offer } from './remote.ts';

offer(exportService);
