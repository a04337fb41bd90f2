/** The heavy part of the element, loaded when the first one comes near the window: three, the shaders, the worker. */
import type { Species } from '../core/species/species.ts';
import { type GrownTree, type GrowOptions, isAborted } from '../worker/client.ts';
import { newGrowQueue } from '../worker/grow-queue.ts';
import type { ElementDebug } from './attributes.ts';
import { elementKit } from './element-kit.ts';
import { frameLoop } from './frame-loop.ts';
import { sharedRenderer } from './shared-renderer.ts';
import { TreeView, type TreeViewEvents } from './tree-view.ts';

export type { Drawing };

/** What an element asks of it. */
const drawing = {
  /** Throws where the browser gives no WebGL2 context. */
  open: (canvas: HTMLCanvasElement, events: TreeViewEvents): TreeView => new TreeView(canvas, events),
  /** Grows a tree: the asker's latest request wins. */
  grow: (
    asker: object,
    species: Species,
    seed: number,
    {
      priority,
      ...options
    }: Required<Pick<GrowOptions, 'signal' | 'onProgress'>> & { readonly priority: () => number },
  ): Promise<GrownTree> => queue.grow(asker, { species, seed, priority, options }),
  isAborted,
  /** Loads what a tree of a species, as it is in its season, is drawn with on this machine. */
  prepare: async (species: Species): Promise<void> => {
    await Promise.all([
      elementKit.load(species),
      sharedRenderer.capabilities?.floatTargets === false && elementKit.loadPoser(),
    ]);
  },
  /** Loads what a view for those who look inside is drawn with, where it needs more than the tree. */
  prepareDebug: async (debug: ElementDebug): Promise<void> => {
    await Promise.all([sharedRenderer.loadDebug(debug), debug === 'skeleton' && elementKit.loadLines()]);
  },
  /** Lets trees answer rays. */
  loadPick: () => elementKit.loadPick(),
  loop: frameLoop,
  renderer: sharedRenderer,
};

type Drawing = typeof drawing;

const queue = newGrowQueue();
frameLoop.gate = sharedRenderer;
sharedRenderer.whenIdle = () => queue.dispose();

export default drawing;
