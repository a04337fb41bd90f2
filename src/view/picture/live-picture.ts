import { Vector3 } from 'three';
import { treeSize } from '../../core/grow/tree-size.ts';
import type { CameraPose, StageId } from '../../core/link/link.ts';
import { inSeason, type Season } from '../../core/species/season.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { SceneOverlays } from '../overlay/scene-overlays.ts';
import { type Shot, Stage } from '../stage.ts';
import { uprightBox } from '../tree-extent.ts';
import { type Which, WindTree } from '../wind-tree.ts';
import { type Area, groundAt, metresAPixel, rayAt } from './aim.ts';
import { placeOf, poseOf } from './camera-pose.ts';
import { openCapture, takePortrait } from './capture-on-demand.ts';
import { Fineness } from './fineness.ts';
import { GpuTimer } from './gpu-timer.ts';
import type { GrownTree } from './grow-tree.ts';
import { HandleGrip } from './handle-grip.ts';
import { type Grip, Hands } from './hands.ts';
import { Hover } from './hover.ts';
import { onScreen, tipsOf } from './on-screen.ts';
import { type Pane, panesOf } from './panes.ts';
import type {
  Capture,
  CaptureOptions,
  Compare,
  FrameFigures,
  Insets,
  OnScreen,
  Overlays,
  Picture,
  PictureEvents,
  PortraitOptions,
  Show,
  TextureImages,
} from './picture.ts';
import { PoseGlimpse } from './pose-glimpse.ts';
import type { Quality } from './quality.ts';
import { StemGrips } from './stem-grips.ts';
import { textureImages } from './texture-images.ts';

/** Milliseconds of a frame on most screens, and the part of the camera's swing that is left after one. */
const FRAME = 1000 / 60;
const SWING = 0.9;

/** Pixels that a pointer may be beside a twig. */
const NEAR = 8;

/** The picture that moves: three's stage with one tree in the wind. */
export class LivePicture implements Picture {
  readonly canvas = document.createElement('canvas');
  private readonly stage: Stage;
  private readonly tree = new WindTree();
  private readonly overlays: SceneOverlays;
  private readonly hands: Hands;
  private readonly hover: Hover;
  private readonly stemGrips: StemGrips;
  private readonly events: PictureEvents;
  private compare: Compare | null = null;
  private insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  /** What picks go by. */
  private readonly glimpses = { A: this.glimpse('A'), B: this.glimpse('B') };
  private readonly timer: GpuTimer;
  private grown: GrownTree | null = null;
  /** It is of a drag that goes on: the next follows at once. */
  private draft = false;
  /** Where the document wants the camera; null: the whole tree. */
  private wished: CameraPose | null = null;
  /** Where the camera rests: set anew before each frame, so that rounding in the controls never adds up. */
  private readonly rest = { position: new Vector3(), target: new Vector3() };
  /** The reader holds the camera, or let it go and it glides. */
  private held = false;
  private gliding = false;
  /** What casts shadows has changed since they were drawn. */
  private stale = true;
  /** Height of the tree, metres. */
  private reach = 6;
  private time = Number.NaN;
  private caught: number | null = null;
  private windMs = 0;
  private readonly fineness = new Fineness();
  /** As its file has it, and as it looks in the season. */
  private plain: Species | null = null;
  private species: Species | null = null;
  private season: Season = 'summer';
  private shown: Show = { levelsShown: Number.POSITIVE_INFINITY, showLeaves: true, view: 'shaded' };
  private dark = false;
  private size: [width: number, height: number] = [1, 1];
  private drawn = 0;
  private frame = 0;

  /** Draws in `host`, as large as that is. Throws where the browser gives no WebGL2 context. */
  constructor(host: HTMLElement, events: PictureEvents) {
    this.events = events;
    this.canvas.tabIndex = 0;
    host.append(this.canvas);
    this.stage = new Stage(this.canvas);
    this.overlays = new SceneOverlays(this.tree.poseUniforms, this.stage.field, events.onChange);
    this.stage.scene.add(this.tree, this.overlays);
    this.timer = new GpuTimer(this.stage.renderer.getContext() as WebGL2RenderingContext);
    const { controls } = this.stage;
    this.stemGrips = this.gripsOfStem();
    this.hands = new Hands({
      canvas: this.canvas,
      grips: [this.wipe(), ...this.stemGrips.grips, this.handle()],
      hold: (on) => {
        controls.enabled = !on;
      },
      press: (x) => this.glimpses[this.paneAt(x).which].ask(this.time),
      click: (x, y) => this.click(x, y),
    });
    this.hover = new Hover({
      canvas: this.canvas,
      pick: (x, y) => this.pickStem(x, y),
      blocked: () => this.turning || this.hands.busy || this.hands.pointing || this.overlays.wanted.throwing === true,
      tell: (stem) => events.onHoverStem?.(stem),
    });
    this.canvas.addEventListener('wheel', (event) => this.turnWheel(event), { capture: true, passive: false });
    controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.addEventListener('start', () => {
      this.held = true;
      this.gliding = true;
      events.onChange();
    });
    controls.addEventListener('end', () => {
      this.held = false;
      events.onChange();
    });
    controls.addEventListener('change', events.onChange);
    for (const [name, lost] of [
      ['webglcontextlost', true],
      ['webglcontextrestored', false],
    ] as const) {
      this.canvas.addEventListener(name, () => {
        this.stale = true;
        events.onLost(lost);
      });
    }
    const size = (): void => {
      this.size = [host.clientWidth, host.clientHeight];
      this.overlays.setSize(...this.size);
      this.resize();
      this.place();
      events.onChange();
    };
    new ResizeObserver(size).observe(host);
    size();
  }

  get renderer(): Stage['renderer'] {
    return this.stage.renderer;
  }

  get moving(): boolean {
    return this.turning || this.tree.catchingUp !== null;
  }

  /** The camera moves, or may. */
  private get turning(): boolean {
    return this.held || this.gliding;
  }

  get camera(): CameraPose {
    return poseOf(this.stage.camera.position, this.stage.controls.target);
  }

  setTree(grown: GrownTree, species: Species, { draft = false }: { readonly draft?: boolean } = {}): void {
    this.draft = draft;
    this.grown = grown;
    this.plain = species;
    this.species = inSeason(species, this.season);
    this.tree.setTree(grown.packed, this.species);
    const size = uprightBox(grown.packed.bounds).getSize(new Vector3());
    this.reach = Math.max(size.y, 2);
    this.overlays.setTree(
      grown.packed,
      grown.stems,
      this.reach,
      Math.max(size.x, size.z) / 2,
      treeSize(species, grown.stats.seed),
    );
    this.stemGrips.setTree(grown.packed);
    this.hover.forget();
    this.showChannel();
    this.forgetPoses();
    this.place();
  }

  setSeason(season: Season): void {
    if (season === this.season) return;
    this.season = season;
    if (!this.grown || !this.plain) return;
    this.species = inSeason(this.plain, season);
    this.tree.setTree(this.grown.packed, this.species);
  }

  setStage(stage: StageId, hour: number | null): void {
    this.stage.setScene(stage, hour);
    this.stale = true;
  }

  setShot(shot: Shot | null): void {
    this.stage.shot = shot;
    this.events.onChange();
  }

  setQuality(quality: Quality): void {
    this.fineness.quality = quality;
  }

  setWind(wind: Wind, fade: number): void {
    this.tree.setWind(wind, { fade });
    if (!this.hands.busy) this.overlays.setWind(wind);
    this.forgetPoses();
  }

  setCompare(compare: Compare | null, fade: number): void {
    const { compare: former } = this;
    this.compare = compare;
    this.forgetPoses();
    // A line that moves is no other wind.
    if (compare?.wind !== former?.wind) this.tree.compareWith(compare?.wind ?? null, { fade: former ? fade : 0 });
    if (compare?.layout !== former?.layout) this.place();
  }

  setOverlays(overlays: Overlays): void {
    const former = this.overlays.wanted.channel ?? null;
    this.overlays.set(overlays);
    this.hands.cursor = overlays.throwing ? 'crosshair' : '';
    if ((overlays.channel ?? null) !== former) this.showChannel();
  }

  show(how: Show): void {
    const { levelsShown, showLeaves, view } = how;
    this.shown = how;
    this.tree.levelsShown = levelsShown;
    this.tree.showLeaves = showLeaves ? 'auto' : false;
    this.tree.mode = view;
    this.stale = true;
  }

  setDark(dark: boolean): void {
    this.dark = dark;
    this.stage.setDark(dark);
    this.overlays.setDark(dark);
    this.stale = true;
  }

  setInsets(insets: Insets): void {
    this.insets = insets;
    this.stage.setInsets(insets);
    this.place();
  }

  setCamera(camera: CameraPose | null): void {
    this.wished = camera;
    this.place();
  }

  draw(time: number, hurried: boolean): FrameFigures {
    this.keepPace(hurried);
    const { stage, tree } = this;
    const { renderer, controls, camera } = stage;
    if (!this.turning) {
      camera.position.copy(this.rest.position);
      controls.target.copy(this.rest.target);
    }
    const start = performance.now();
    // The swing fades by time, not by frames: where frames are slow it would go on for a minute.
    controls.dampingFactor = 1 - SWING ** Math.max(1, (start - this.drawn) / FRAME);
    this.drawn = start;
    // A tree that takes another's place while time runs swings on; where time stands its past counts.
    const runs = hurried && time !== this.time && !Number.isNaN(this.time);
    tree.startsNear = this.draft || runs;
    if (!hurried && !this.draft) tree.settle();
    this.timer.begin();
    tree.update(renderer, time);
    this.timer.end();
    const submitted = performance.now();
    const { catchingUp } = tree;
    // What a far jump leaves on the screen until it is there does not move.
    const moved = this.stale || time !== this.time || this.caught !== catchingUp;
    this.caught = catchingUp;
    // On a slow machine shadows follow every third frame while things move: they cost as much as the tree.
    const shadows = moved && (this.fineness.scale === 1 || this.frame % 3 === 0);
    stage.render(
      shadows,
      this.panes.map((pane) => ({
        ...pane,
        before: () => {
          tree.show(pane.which);
          stage.blow(tree.windSource(pane.which), time);
          this.overlays.update(time);
        },
      })),
    );
    tree.show('A');
    this.frame++;
    const drawn = performance.now();
    // Where nothing changed the pass did nothing: its last figure stands.
    if (moved) this.windMs = this.timer.milliseconds ?? submitted - start;
    this.stale = moved && !shadows;
    this.time = time;
    this.stemGrips.look();
    if (this.gliding && !this.held && !stage.moving) this.settle();
    const { triangles, calls } = renderer.info.render;
    return {
      triangles,
      drawCalls: calls,
      wind: this.windMs,
      draw: drawn - start,
      catchingUp,
      quality: this.fineness.level,
    };
  }

  tips(): Float32Array {
    const pose = this.tree.readPose(this.stage.renderer);
    if (!pose || !this.grown) return new Float32Array(0);
    return tipsOf(this.grown.packed, pose);
  }

  onScreen(): OnScreen {
    const pose = this.tree.readPose(this.stage.renderer);
    if (!pose || !this.grown) return { branches: [], stems: [], handles: {}, horizon: 0 };
    const { packed, stems } = this.grown;
    return {
      ...onScreen(packed, pose, this.tree, this.stage.camera, this.canvas),
      stems: [...stems.stemOfPiece],
      handles: this.stemGrips.onScreen(),
    };
  }

  pickPiece(x: number, y: number): number | null {
    const { ray } = rayAt(x, y, this.areaAt(x), this.stage.camera);
    const pose = this.glimpses[this.paneAt(x).which].at(this.time);
    return this.tree.pick(ray, { pose, near: NEAR * metresAPixel(this.stage.camera, this.size[1]) });
  }

  pickStem(x: number, y: number): number | null {
    const piece = this.pickPiece(x, y);
    return piece === null ? null : (this.grown?.stems.stemOfPiece[piece] ?? null);
  }

  pickGround(x: number, y: number): { x: number; y: number } | null {
    const { camera } = this.stage;
    // Beyond that the meadow has faded into the sky.
    return groundAt(x, y, this.areaAt(x), camera, camera.position.length() + 3 * this.reach);
  }

  async readTextures(which: Which = 'A'): Promise<TextureImages> {
    const { grown } = this;
    const back = await this.tree.readBack(this.stage.renderer, which);
    if (!back || !grown) throw new Error('There is no tree to read.');
    return textureImages(grown.packed, back.pose, back.state);
  }

  readPiece(piece: number, which: Which = 'A'): Promise<Float32Array | null> {
    return this.tree.readPiece(this.stage.renderer, piece, which);
  }

  capture(time: number): string {
    const { wanted } = this.overlays;
    // They are of the interface: how the handle glows goes by what the reader did, not by the document.
    this.overlays.set({ ...wanted, handle: false, highlight: null, stem: null, hoveredStem: null, envelope: null });
    let { catchingUp } = this.draw(time, false);
    // Springs may be on their way to this time; a lost context gets no farther.
    for (let before = -1; catchingUp !== null && catchingUp !== before; ) {
      before = catchingUp;
      catchingUp = this.draw(time, false).catchingUp;
    }
    const picture = this.canvas.toDataURL(); // in the same task: the drawing is gone once it was shown
    this.overlays.set(wanted);
    this.draw(time, false);
    return picture;
  }

  portrait(grown: GrownTree, species: Species, options: PortraitOptions): Promise<Blob> {
    return takePortrait(grown, inSeason(species, this.season), this.dark, options, this.stage.place);
  }

  async openCapture(options: CaptureOptions): Promise<Capture> {
    const { grown, species, shown: show, dark } = this;
    const { place: scene } = this.stage;
    if (!grown || !species) throw new Error('There is no tree to draw.');
    const { wind = this.tree.wind } = options;
    const { channel = null } = this.overlays.wanted;
    const sitter = { packed: grown.packed, stems: grown.stems, species, wind, show, dark, channel, scene };
    const [width, height] = this.size;
    const { top, right, bottom, left } = this.insets;
    const pose = options.camera ?? (this.wished && this.turning ? this.camera : this.wished);
    const high = Math.max(1, height - top - bottom) / height;
    const wide = Math.max(1, width - left - right) / height;
    return openCapture(sitter, pose ? { pose, high, wide } : 'whole', options);
  }

  /** The canvas in the window. */
  private get area(): Area {
    return this.canvas.getBoundingClientRect();
  }

  private get panes(): readonly Pane[] {
    return panesOf(this.size[0], this.insets, this.compare);
  }

  private paneAt(x: number): Pane {
    const { panes } = this;
    const within = x - this.area.left;
    return panes.find(({ left, width }) => within >= left && within < left + width) ?? (panes[0] as Pane);
  }

  /** The canvas in the window as the camera fills it in the pane at x. */
  private areaAt(x: number): Area {
    const { left, top, width, height } = this.area;
    return { left: left + this.paneAt(x).shift, top, width, height };
  }

  /** The camera zooms to the cursor and knows of one picture: in one of two side by side the cursor is where it would be in that. */
  private turnWheel(event: WheelEvent): void {
    const { shift } = this.paneAt(event.clientX);
    if (shift === 0 || !event.isTrusted) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    const { deltaX, deltaY, deltaMode, clientY, ctrlKey, shiftKey } = event;
    const clientX = event.clientX - shift;
    const init = { deltaX, deltaY, deltaMode, clientX, clientY, ctrlKey, shiftKey, bubbles: true, cancelable: true };
    this.canvas.dispatchEvent(new WheelEvent('wheel', init));
  }

  private glimpse(which: Which): PoseGlimpse {
    return new PoseGlimpse(async () => (await this.tree.readBack(this.stage.renderer, which))?.pose ?? null);
  }

  private forgetPoses(): void {
    this.glimpses.A.forget();
    this.glimpses.B.forget();
    this.stale = true;
  }

  /** The line between A and B, to drag. */
  private wipe(): Grip {
    const split = (): boolean => this.compare?.layout === 'split';
    const at = (): number => this.area.left + (this.panes[1]?.left ?? 0);
    return {
      cursor: 'ew-resize',
      distance: (x) => (split() && this.events.onWipe ? Math.abs(x - at()) : null),
      anchor: () => ({ x: at(), y: 0 }),
      drag: (x, _y, done) => {
        const { left, width } = this.area;
        this.events.onWipe?.(Math.min(1, Math.max(0, (x - left) / width)), done);
      },
      hover: () => {},
    };
  }

  private handle(): Grip {
    return new HandleGrip(this.overlays.handle, {
      areaAt: (x) => this.areaAt(x),
      camera: this.stage.camera,
      tell: (direction, strength, done) => {
        this.overlays.touch();
        this.events.onHandle?.(direction, strength, done);
      },
      redraw: this.events.onChange,
    });
  }

  private showChannel(): void {
    const { channel = null } = this.overlays.wanted;
    if (this.grown) this.tree.showChannel(channel, this.grown.stems);
    this.stale = true;
  }

  private gripsOfStem(): StemGrips {
    return new StemGrips({
      ends: () => (this.events.onStemHandle ? this.overlays.ends : null),
      view: (x) => ({ area: this.areaAt(x), camera: this.stage.camera }),
      readPiece: (piece) => this.readPiece(piece),
      mark: (kind, how) => this.overlays.stemHandles.grip(kind, how),
      tell: (kind, change, done) => this.events.onStemHandle?.(kind, change, done),
      redraw: this.events.onChange,
    });
  }

  private click(x: number, y: number): void {
    const { onPickStem, onThrow } = this.events;
    if (onPickStem && !this.overlays.wanted.throwing) {
      const piece = this.pickPiece(x, y);
      onPickStem(piece === null ? null : (this.grown?.stems.stemOfPiece[piece] ?? null), piece);
      if (piece !== null) return;
    }
    const ground = onThrow ? this.pickGround(x, y) : null;
    if (ground) onThrow?.(ground.x, ground.y);
  }

  private resize(): void {
    this.stage.resize(...this.size, this.fineness.pixelRatio);
  }

  /** Draws as finely as the reader wants or this machine can. */
  private keepPace(hurried: boolean): void {
    const { fineness, stage, tree } = this;
    const { scale, level } = fineness.frame(hurried, performance.now() - this.drawn);
    if (!scale && !level) return;
    if (level) {
      stage.setFineness(fineness.settings);
      tree.detail = fineness.settings.detail;
      tree.leafBudget = fineness.settings.leafBudget;
    }
    this.stale = true;
    this.resize();
  }

  /** The camera came to rest: what is left of its swing goes, and the document learns where it stands. */
  private settle(): void {
    const { controls } = this.stage;
    const { enableDamping } = controls;
    controls.enableDamping = false;
    controls.update();
    controls.enableDamping = enableDamping;
    this.gliding = false;
    this.events.onCamera(this.camera);
  }

  /** Puts the camera where the document wants it. */
  private place(): void {
    const { stage, rest, wished } = this;
    if (this.grown) {
      const box = uprightBox(this.grown.packed.bounds);
      // A tree that grows in a reader's hand must not run away from it.
      if (wished || this.stemGrips.busy) stage.setSubject(box);
      else stage.frame(box, { columns: this.compare?.layout === 'side' ? 2 : 1 });
    }
    if (wished) placeOf(wished, rest.position, rest.target);
    else {
      rest.position.copy(stage.camera.position);
      rest.target.copy(stage.controls.target);
    }
    this.gliding = false;
    this.stale = true; // how finely the tree is drawn goes by the camera, and so do its shadows
  }
}
