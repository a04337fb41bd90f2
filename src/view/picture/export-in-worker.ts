export {
  type CountRequest,
  countWithWorker as countInWorker,
  type ExportInWorkerOptions,
  type ExportProgress,
  exportWithWorker as exportInWorker,
  type MeshCount,
} from '../../worker/export-client.ts';
