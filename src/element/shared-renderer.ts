import type { CameraPose } from '../core/link/document.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import { BareStage } from '../view/bare-stage.ts';
import { type Capabilities, capabilitiesOf } from '../view/cpu-kit.ts';
import type { KitTree } from '../view/kit-tree.ts';
import { placeOf, poseOf } from '../view/picture/camera-pose.ts';
import { uprightBox } from '../view/tree-extent.ts';
import { type ElementDebug, type ElementEnvironment, type ElementGround, STAGE_OF } from './attributes.ts';
import type { DebugField } from './debug-field.ts';
import type { DebugState } from './debug-state.ts';

/** Who draws here: told when the GPU is taken away, and when it is back. */
export interface RendererUser {
  lost(lost: boolean): void;
}

/** What is drawn, and how. */
export interface Shot {
  readonly tree: KitTree;
  /** What it was made from. */
  readonly packed: PackedTree;
  /** Called when what the picture waited for has come. */
  readonly come: () => void;
  /** Seconds. */
  readonly time: number;
  /** Springs are there at once that would take long to come to this time. */
  readonly near: boolean;
  readonly camera: CameraPose;
  /** CSS pixels, and device pixels to each. */
  readonly width: number;
  readonly height: number;
  readonly pixelRatio: number;
  readonly environment: ElementEnvironment;
  readonly hour: number | null;
  readonly ground: ElementGround;
  readonly shadow: boolean;
  readonly dark: boolean;
  /** Part of the grass that grows, 0..1. */
  readonly grass: number;
  readonly debug: ElementDebug;
  /** What throws shadows has moved since the last shot of this tree. */
  readonly moved: boolean;
}

/** What came of it. */
export interface Drawn {
  readonly triangles: number;
  readonly drawCalls: number;
  /** Elevation of the camera in degrees as it was drawn: the ground stops it. */
  readonly elevation: number;
  /** Springs are still on their way to this time: part 0..1; null: they are there. */
  readonly catchingUp: number | null;
}

/** Texels a side of the shadow map that all share. */
const SHADOWS = 1024;

/** Milliseconds after which the context is given back that nobody draws with. */
const IDLE = 4000;

/**
 * The page's one renderer, with one stage that is set anew for each tree: a browser has few contexts, and twenty meadows take the
 * memory of one. A picture is drawn and handed over in one go, so that the next may have the stage.
 */
export class SharedRenderer {
  #stage: BareStage | null = null;
  /** What makes arrows of the wind, once somebody wanted to see them. */
  #newField: ((stage: BareStage) => DebugField) | null = null;
  #field: DebugField | null = null;
  #state: DebugState | null = null;
  readonly #users = new Set<RendererUser>();
  /** Whose shadows are in the map. */
  #shadowsOf: KitTree | null = null;
  #size = '';
  #set = '';
  /** Passed by the GPU when it is through with the last frame. */
  #fence: WebGLSync | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Called when nobody has drawn for a while and the context was given back. */
  whenIdle = (): void => {};

  /** Joins; throws where the browser gives no WebGL2 context. */
  join(user: RendererUser): void {
    clearTimeout(this.#timer);
    this.#stage ??= this.#open();
    this.#users.add(user);
  }

  leave(user: RendererUser): void {
    this.#users.delete(user);
    if (this.#users.size > 0) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#close(), IDLE);
  }

  /** Figures of the GPU, for tests and for `stats`; null while there is no renderer. */
  get info(): { readonly geometries: number; readonly textures: number; readonly programs: number } | null {
    const info = this.#stage?.renderer.info;
    return info ? { ...info.memory, programs: info.programs?.length ?? 0 } : null;
  }

  /** The canvas of the context; null while there is none. */
  get canvas(): HTMLCanvasElement | null {
    return this.#stage?.renderer.domElement ?? null;
  }

  get users(): number {
    return this.#users.size;
  }

  get lost(): boolean {
    return this.#stage?.renderer.getContext().isContextLost() ?? false;
  }

  /** The GPU still draws the last frame. A canvas that is never shown has nobody else to hold its frames back. */
  get busy(): boolean {
    const gl = this.#stage?.renderer.getContext() as WebGL2RenderingContext | undefined;
    if (!gl || !this.#fence) return false;
    if (!gl.isContextLost() && gl.getSyncParameter(this.#fence, gl.SYNC_STATUS) !== gl.SIGNALED) return true;
    gl.deleteSync(this.#fence);
    this.#fence = null;
    return false;
  }

  /** All of a frame has been handed to the GPU. */
  mark(): void {
    const gl = this.#stage?.renderer.getContext() as WebGL2RenderingContext | undefined;
    if (!gl || gl.isContextLost()) return;
    if (this.#fence) gl.deleteSync(this.#fence);
    this.#fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /** Loads what a view for those who look inside is drawn with; until then such a shot is drawn without. */
  async loadDebug(debug: ElementDebug): Promise<void> {
    if (debug === 'field') await this.#loadField();
    if (debug === 'state') this.#state ??= new (await import('./debug-state.ts')).DebugState();
  }

  async #loadField(): Promise<void> {
    if (this.#newField) return;
    const { DebugField } = await import('./debug-field.ts');
    this.#newField = (stage) => new DebugField(stage);
  }

  /** What its GPU can do; null while there is none. */
  get capabilities(): Capabilities | null {
    return this.#stage && capabilitiesOf(this.#stage.renderer);
  }

  /** The camera that shows the whole of a tree in a picture of this size. */
  wholeView(bounds: Float32Array, width: number, height: number): CameraPose {
    const stage = this.#stage as BareStage;
    this.#resize(width, height, 1);
    const { position, target } = stage.whole(uprightBox(bounds));
    return poseOf(position, target);
  }

  /** Draws a tree into `canvas`, which takes the size of the picture; null without a context. */
  draw(shot: Shot, canvas: HTMLCanvasElement): Drawn | null {
    const stage = this.#stage;
    if (!stage || this.lost) return null;
    const { renderer, camera, target, scene } = stage;
    const { tree, packed, time } = shot;
    const { bounds } = packed;
    this.#resize(shot.width, shot.height, shot.pixelRatio);
    this.#dress(shot);
    stage.setSubject(uprightBox(bounds));
    placeOf(shot.camera, camera.position, target);
    scene.add(tree);
    tree.startsNear = shot.near;
    if (!shot.near) tree.settle();
    tree.update(renderer, time);
    stage.blow(tree.windSource(), time);
    if (shot.debug === 'field') {
      const reach = Math.max(2, bounds[5]! - bounds[2]!);
      this.#fieldOf(stage)?.show(shot.dark, reach, shot.width, shot.height);
    }
    const shadows = shot.shadow && (shot.moved || this.#shadowsOf !== tree);
    stage.render(shadows);
    if (shadows) this.#shadowsOf = tree;
    const { triangles, calls } = renderer.info.render;
    const { elevation } = poseOf(camera.position, target);
    this.#handOver(renderer.domElement, canvas);
    if (shot.debug === 'state') this.#state?.draw(renderer, tree, packed, time, canvas, shot.come);
    scene.remove(tree);
    this.#field?.hide();
    return { triangles, drawCalls: calls, elevation, catchingUp: tree.catchingUp };
  }

  /** In the same task as the drawing: the browser empties the context's canvas after it. */
  #handOver(from: HTMLCanvasElement, canvas: HTMLCanvasElement): void {
    if (canvas.width !== from.width) canvas.width = from.width;
    if (canvas.height !== from.height) canvas.height = from.height;
    const context = canvas.getContext('2d');
    if (!context) return;
    context.globalCompositeOperation = 'copy';
    context.drawImage(from, 0, 0);
  }

  #resize(width: number, height: number, pixelRatio: number): void {
    const size = `${width} ${height} ${pixelRatio}`;
    if (size === this.#size) return;
    this.#size = size;
    this.#stage?.resize(width, height, pixelRatio);
  }

  #dress({ environment, hour, ground, shadow, dark, grass }: Shot): void {
    const stage = this.#stage as BareStage;
    const set = `${environment} ${hour} ${ground} ${shadow} ${dark} ${grass}`;
    if (set === this.#set) return;
    this.#set = set;
    const sky = environment !== 'none';
    stage.sky.visible = sky;
    stage.ground.visible = ground === 'auto' ? sky : ground !== 'none';
    stage.meadow.visible = stage.ground.visible && ground !== 'plain';
    stage.sun.castShadow = shadow;
    const { place } = stage;
    if (place.stage !== STAGE_OF[environment] || place.hour !== hour) stage.setScene(STAGE_OF[environment], hour);
    // Without a sky there is no dusk either: it would only be too dark.
    stage.setDark(dark && sky);
    stage.setFineness({ shadows: SHADOWS, grass });
    this.#shadowsOf = null;
  }

  #fieldOf(stage: BareStage): DebugField | null {
    this.#field ??= this.#newField?.(stage) ?? null;
    return this.#field;
  }

  #open(): BareStage {
    const canvas = document.createElement('canvas');
    const stage = new BareStage(canvas, { alpha: true, shadows: SHADOWS });
    for (const [name, lost] of [
      ['webglcontextlost', true],
      ['webglcontextrestored', false],
    ] as const) {
      canvas.addEventListener(name, () => {
        this.#shadowsOf = null;
        this.#fence = null;
        if (stage === this.#stage) for (const user of [...this.#users]) user.lost(lost);
      });
    }
    return stage;
  }

  #close(): void {
    const stage = this.#stage;
    if (!stage || this.#users.size > 0) return;
    this.#stage = null;
    this.#fence = null;
    this.#shadowsOf = null;
    this.#size = '';
    this.#set = '';
    this.#field?.dispose();
    this.#field = null;
    stage.dispose();
    stage.renderer.forceContextLoss();
    this.whenIdle();
  }
}

export const sharedRenderer = new SharedRenderer();
