import type { CameraPose, ViewMode } from '../../core/link/link.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import type { GrownTree } from './grow-tree.ts';

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
  /** Points along all pieces, x and y. */
  readonly branches: readonly number[];
  readonly horizon: number;
}

/** What a frame took. */
export interface FrameFigures {
  readonly triangles: number;
  readonly drawCalls: number;
  /** Milliseconds of the wind pass, and of the whole drawing as far as the page waits for it. */
  readonly wind: number;
  readonly draw: number;
}

/** What a page shows a tree on: the stage, or a still drawing where there is no WebGL2. */
export interface Picture {
  setTree(grown: GrownTree, species: Species): void;
  /** Lets `wind` blow after `fade` seconds of change; 0: at once. */
  setWind(wind: Wind, fade: number): void;
  show(how: Show): void;
  setDark(dark: boolean): void;
  setInsets(insets: Insets): void;
  /** null: frames the whole tree, and keeps doing so while trees and windows change. */
  setCamera(camera: CameraPose | null): void;
  /** Where the camera stands now. */
  readonly camera: CameraPose;
  /** What takes the keyboard's focus for the picture. */
  readonly canvas: HTMLElement;
  /** The camera is on its way: each frame differs from the last. */
  readonly moving: boolean;
  /** Draws the tree at `time` seconds; `hurried`: another frame follows at once. */
  draw(time: number, hurried: boolean): FrameFigures;
  /** Tips (P3) of all pieces as they were drawn last, 3 a piece, tree space, metres. */
  tips(): Float32Array;
  /** Where the branches were drawn last, in pixels of the window, and the horizon's row: for tests. */
  onScreen(): OnScreen;
  /** Draws the tree at `time` seconds without the interface, as a data: address of a PNG. */
  capture(time: number): string;
}

/** What a picture tells its page. */
export interface PictureEvents {
  /** Something changed by itself (a size, a finger on the camera): draw again. */
  readonly onChange: () => void;
  /** The reader moved the camera, and it has come to rest here. */
  readonly onCamera: (camera: CameraPose) => void;
  /** The GPU was taken away (true), or came back. */
  readonly onLost: (lost: boolean) => void;
}
