import type { CameraPose, StageId, ViewMode } from '../../core/link/link.ts';
import type { Season } from '../../core/species/season.ts';
import type { PruningParameters, Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import type { Shot } from '../stage.ts';
import type { GrownTree } from './grow-tree.ts';
import type { Quality, QualityLevel } from './quality.ts';

/** Pixels of the window that panels cover: the tree is framed in what is left. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** How the tree is drawn. */
export interface Show {
  readonly levelsShown: number;
  readonly showLeaves: boolean;
  readonly view: ViewMode;
}

/** Where things are in the window, CSS pixels. */
export interface OnScreen {
  /** Points along all pieces, x and y, as many a piece. */
  readonly branches: readonly number[];
  /** The stem of each piece. */
  readonly stems: readonly number[];
  /** The handles of the selected stem that can be held, x and y. */
  readonly handles: Readonly<Partial<Record<StemHandle, readonly [x: number, y: number]>>>;
  readonly horizon: number;
}

/** What a frame took. */
export interface FrameFigures {
  readonly triangles: number;
  readonly drawCalls: number;
  /** Milliseconds of the wind pass, and of the whole drawing as far as the page waits for it. */
  readonly wind: number;
  readonly draw: number;
  /** Part (0..1) of the way to the wished time that a far jump has made; null: what is drawn is of the wished time. */
  readonly catchingUp: number | null;
  /** How finely it was drawn; absent where there is one way only. */
  readonly quality?: QualityLevel;
}

/** A second wind on the same tree, clock and camera. */
export interface Compare {
  readonly wind: Wind;
  /** `split`: one picture, A left of a line and B right of it; `side`: two pictures side by side. */
  readonly layout: 'split' | 'side';
  /** Place of the line, 0..1 of the picture's width; `side` has it in the middle of what the insets leave. */
  readonly at: number;
}

/** What is drawn in the scene beside the tree. */
export interface Overlays {
  /** Arrows of the force over the ground. */
  readonly arrows: boolean;
  /** Fronts of gusts, as bands that sweep over the meadow. */
  readonly fronts: boolean;
  /** The ring with which the wind is turned. */
  readonly handle: boolean;
  /** Piece that the probe sticks to, at its end. */
  readonly probe: number | null;
  /** Piece that stands out. */
  readonly highlight: number | null;
  /** The next click throws a gust: the cursor says so, and branches are not picked. */
  readonly throwing?: boolean;
  /** A control that does what the handle does has the focus: the handle looks as if it were held. */
  readonly handling?: boolean;
  /** Stem that is selected: outlined along all its pieces. */
  readonly stem?: number | null;
  /** The selected stem bears handles for its length, down angle and curve. */
  readonly handles?: boolean;
  /** Stem that the reader points at: outlined more faintly. */
  readonly hoveredStem?: number | null;
  /** The pruning envelope, drawn around the tree; its numbers are those of the species. */
  readonly envelope?: PruningParameters | null;
  /** Colours the tree by what engines get of its wind, in place of bark and leaves. */
  readonly channel?: ChannelView | null;
}

/** A number of each vertex that moves a tree in an engine, as a colour (src/core/io/channels.ts). */
export type ChannelView = 'sway' | 'coordinate' | 'branch' | 'phase' | 'pivot';

/** What a handle of a stem drags. */
export type StemHandle = 'length' | 'down' | 'curve';

/** How far a handle was dragged since it was taken. */
export interface StemHandleChange {
  /** Of `length`: the stem's new length as a multiple of what it was, > 0. */
  readonly ratio?: number;
  /** Of `down` and `curve`: what is added to the angle. */
  readonly degrees?: number;
}

/** How large a picture that is taken is, in pixels. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** How a portrait is taken. */
export interface PortraitOptions extends PictureSize {
  /**
   * What the picture has room for, in metres about the trunk: trees with the same frame are drawn at the same scale, without ground and sky,
   * with straight alpha. By default the tree stands on the ground and fills the picture.
   */
  readonly frame?: PictureSize;
}

/** What is to be taken. */
export interface CaptureOptions extends PictureSize {
  /** No sky and no ground: the tree alone, with straight alpha. */
  readonly transparent: boolean;
  /** Where it is seen from; by default as on the screen now, with as much at the sides as the size asks for. */
  readonly camera?: CameraPose;
  /** The wind that blows in it; by default that of the picture. */
  readonly wind?: Wind;
  /** How it is exposed, and through what lens. */
  readonly shot?: Shot | null;
}

/** The shown tree, wind and theme, drawn at a size of its own beside the visible picture. */
export interface Capture {
  readonly canvas: HTMLCanvasElement | OffscreenCanvas;
  /** Draws the tree as it is at `time` seconds, springs too; when it resolves the pixels are in `canvas`. Rejects after `close`. */
  draw(time: number): Promise<void>;
  /** Frees what it took; the canvas keeps its pixels. */
  close(): void;
}

/** One state texture, read back. */
export interface TextureLayer {
  readonly id: 'P0' | 'P1' | 'P2' | 'P3' | 'Q' | 'BASE' | 'END';
  /** What its four numbers are, and in what unit. */
  readonly label: string;
  readonly unit: string;
  /** 4 a texel, row by row; piece i is texel i. */
  readonly data: Float32Array;
}

/** The state of all pieces as images. */
export interface TextureImages {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  /** Texels in use. */
  readonly pieceCount: number;
  readonly layers: readonly TextureLayer[];
}

/** What a page shows a tree on: the stage, or a still drawing where there is no WebGL2. */
export interface Picture {
  /**
   * Shows another tree. `draft`: its springs begin with the wind of now instead of running from time 0; a tree that is set without it
   * afterwards is again what its past makes of it, where time stands.
   */
  setTree(grown: GrownTree, species: Species, how?: { readonly draft?: boolean }): void;
  /** Lets `wind` blow after `fade` seconds of change; 0: at once. */
  setWind(wind: Wind, fade: number): void;
  /** Draws B beside A: `compare.wind` fades in as `setWind` does; null: A alone, and B costs nothing. */
  setCompare(compare: Compare | null, fade: number): void;
  setOverlays(overlays: Overlays): void;
  show(how: Show): void;
  setDark(dark: boolean): void;
  /** Dresses this tree, and those that follow, as the species looks in a season. */
  setSeason(season: Season): void;
  /** Where the tree stands; `hour` of the day by the sun, 0..24, null: the stage's own. */
  setStage(stage: StageId, hour: number | null): void;
  /** Exposure and lens of a photograph; null: those of the stage. Absent where nothing is photographed. */
  setShot?(shot: Shot | null): void;
  /** How finely it is drawn while time runs; where time stands, `auto` is always the same. */
  setQuality(quality: Quality): void;
  setInsets(insets: Insets): void;
  /** null: frames the whole tree, and keeps doing so while trees and windows change. */
  setCamera(camera: CameraPose | null): void;
  /** Where the camera stands now. */
  readonly camera: CameraPose;
  /** What takes the keyboard's focus for the picture. */
  readonly canvas: HTMLElement;
  /** The camera is on its way, or a far jump in time is: each frame differs from the last. */
  readonly moving: boolean;
  /** Draws the tree at `time` seconds; `hurried`: another frame follows at once. */
  draw(time: number, hurried: boolean): FrameFigures;
  /** Tips (P3) of all pieces as they were drawn last, 3 a piece, tree space, metres. */
  tips(): Float32Array;
  /** Where the branches were drawn last, in pixels of the window, and the horizon's row: for tests. */
  onScreen(): OnScreen;
  /** The piece at a point of the window (CSS pixels), in the pose as drawn lately or else at rest; null: none. */
  pickPiece(x: number, y: number): number | null;
  /** The stem at a point of the window, likewise; clones are stems of their own. */
  pickStem(x: number, y: number): number | null;
  /** Where the ground is at a point of the window; metres, tree space; null: the sky. */
  pickGround(x: number, y: number): { x: number; y: number } | null;
  /** The state textures of A or B, read back without holding up a frame. Rejects where there is no tree. */
  readTextures(which?: 'A' | 'B'): Promise<TextureImages>;
  /** The 16 numbers of a piece's pose (P0 to P3, 4 each) as drawn last; null where there is no such piece. */
  readPiece(piece: number, which?: 'A' | 'B'): Promise<Float32Array | null>;
  /** Draws the tree at `time` seconds without the interface, as a data: address of a PNG. */
  capture(time: number): string;
  /** Another tree at rest, whole, on this stage and in its light, as a WebP or PNG; what is shown stays. Rejects where the browser cannot. */
  portrait(grown: GrownTree, species: Species, options: PortraitOptions): Promise<Blob>;
  /** Opens a drawing of the shown tree at any size that the GPU allows. Rejects with an Error that names the most where it does not. */
  openCapture(options: CaptureOptions): Promise<Capture>;
}

/** What a picture tells its page. */
export interface PictureEvents {
  /** Something changed by itself (a size, a finger on the camera): draw again. */
  readonly onChange: () => void;
  /** The reader moved the camera, and it has come to rest here. */
  readonly onCamera: (camera: CameraPose) => void;
  /** The GPU was taken away (true), or came back. */
  readonly onLost: (lost: boolean) => void;
  /** The reader turns the wind: radians from x to y in tree space, strength 0..1; `done`: let go. */
  readonly onHandle?: (direction: number, strength: number, done: boolean) => void;
  /** The reader points at another stem than before, or at none. */
  readonly onHoverStem?: (stem: number | null) => void;
  /** The reader clicked on a stem, on a piece of it, or beside the tree: on none. */
  readonly onPickStem?: (stem: number | null, piece: number | null) => void;
  /** The reader drags a handle of the selected stem: the change since it was taken; `done`: let go. */
  readonly onStemHandle?: (kind: StemHandle, change: StemHandleChange, done: boolean) => void;
  /** The reader clicked on the ground, metres, tree space: there a gust may start. */
  readonly onThrow?: (x: number, y: number) => void;
  /** The reader drags the line between A and B: its place, 0..1; `done`: let go. */
  readonly onWipe?: (at: number, done: boolean) => void;
}
