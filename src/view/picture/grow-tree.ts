/** How a picture gets its trees: grown in the page's worker, the latest request wins. */
export { growInWorker as growTree } from '../../worker/client.ts';
export type { GrownTree, GrowProgress, GrowSettings } from '../../worker/protocol.ts';
