import { type IUniform, Object3D } from 'three';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { StemTable } from '../../core/pack/stem-table.ts';
import type { Wind } from '../../core/wind/wind.ts';
import type { ForceField } from '../force-field.ts';
import type { Overlays } from '../picture/picture.ts';
import { windDirection } from '../wind-direction.ts';
import { Arrows } from './arrows.ts';
import type { Envelope, TreeSize } from './envelope.ts';
import { Fronts } from './fronts.ts';
import { Handle } from './handle.ts';
import { Highlight } from './highlight.ts';
import { Marker } from './marker.ts';
import { overlayUniforms, setOverlayColours } from './overlay-material.ts';
import { type StemEnds, stemEnds } from './stem-ends.ts';
import { StemHandles } from './stem-handles.ts';
import { StemOutline } from './stem-outline.ts';
import { isOdd, stemPieces } from './stem-pieces.ts';

const NONE: Overlays = { arrows: false, fronts: false, handle: false, probe: null, highlight: null };

/** Seconds of the clock that the handle glows at first, and from swell to swell. */
const GLOWS = 6;
const SWELL = 2;

/** What is drawn in the scene beside the tree: the force over the ground, gusts, the wind's handle, the probe, a branch. */
export class SceneOverlays extends Object3D {
  readonly handle: Handle;
  readonly stemHandles: StemHandles;
  readonly #uniforms = overlayUniforms();
  readonly #arrows: Arrows;
  readonly #fronts: Fronts;
  readonly #marker: Marker;
  readonly #highlight: Highlight;
  readonly #selected: StemOutline;
  readonly #hovered: StemOutline;
  /** Few trees are pruned: it is loaded when one first is. */
  #envelope: Envelope | null = null;
  #loading: Promise<void> | null = null;
  #size: TreeSize | null = null;
  readonly #changed: () => void;
  #ends: StemEnds | null = null;
  #wanted = NONE;
  #tree: PackedTree | null = null;
  #stems: StemTable | null = null;
  /** Time of the clock at which the handle was drawn first. */
  #glowing = Number.NaN;
  #touched = false;

  /**
   * `pose`: poseEven, poseOdd and poseLog2Width of the tree that the probe sticks to; `field`: the wind that is shown; `changed` is called when something
   * has come that was asked for before.
   */
  constructor(pose: Record<string, IUniform>, field: ForceField, changed: () => void) {
    super();
    this.#changed = changed;
    const shared = this.#uniforms;
    this.#arrows = new Arrows(shared, field);
    this.#fronts = new Fronts(shared, field);
    this.#marker = new Marker(shared, pose);
    this.#highlight = new Highlight(shared, pose);
    this.#hovered = new StemOutline(shared, pose, 0.25);
    this.#selected = new StemOutline(shared, pose, 1);
    this.stemHandles = new StemHandles(shared, pose);
    this.handle = new Handle(shared);
    this.add(this.#fronts, this.#arrows, this.handle);
    this.add(this.#highlight, this.#hovered, this.#selected, this.#marker, this.stemHandles);
    this.rotation.x = -Math.PI / 2; // tree space: z up to y up
    this.name = 'overlays';
    this.setDark(false);
    this.#show();
  }

  set(overlays: Overlays): void {
    this.#wanted = overlays;
    this.handle.focused = overlays.handling ?? false;
    this.#show();
  }

  get wanted(): Overlays {
    return this.#wanted;
  }

  setDark(dark: boolean): void {
    setOverlayColours(this.#uniforms, dark);
  }

  /** Size of the picture in CSS pixels. */
  setSize(width: number, height: number): void {
    this.#uniforms.overlayPixels.value.set(width, height);
  }

  /** The places of the selected stem's handles; null where none is drawn. */
  get ends(): StemEnds | null {
    return this.#ends;
  }

  /** Takes the tree that marks stick to, its reach and the radius of its crown in metres, and what of its size the envelope goes by. */
  setTree(tree: PackedTree, stems: StemTable, reach: number, crown: number, size: TreeSize): void {
    this.#tree = tree;
    this.#stems = stems;
    this.#size = size;
    this.#arrows.fit(reach);
    this.#fronts.fit(reach);
    this.handle.fit(reach, crown);
    this.#show();
  }

  /** Turns the handle to a wind. */
  setWind(wind: Wind): void {
    this.handle.set(windDirection(wind) ?? this.handle.place.direction, wind.strength);
  }

  /** The reader has found the handle: it glows no more. */
  touch(): void {
    this.#touched = true;
  }

  /** Takes what the field has of the wind of what is drawn next, at `time` seconds. */
  update(time: number): void {
    const { arrows, fronts, handle } = this.#wanted;
    if (arrows) this.#arrows.update();
    if (fronts) this.#fronts.update();
    if (!handle) return;
    if (Number.isNaN(this.#glowing)) this.#glowing = time;
    const since = time - this.#glowing;
    const on = !this.#touched && since >= 0 && since < GLOWS;
    this.handle.glow = on ? 0.5 - 0.5 * Math.cos((2 * Math.PI * since) / SWELL) : 0;
  }

  override dispose(): void {
    for (const part of [this.#arrows, this.#fronts, this.#marker, this.#highlight, this.handle]) part.dispose();
    for (const part of [this.#selected, this.#hovered, this.stemHandles]) part.dispose();
    this.#envelope?.dispose();
  }

  #showStems(): void {
    const { stem = null, hoveredStem = null, handles = false, throwing = false, envelope = null } = this.#wanted;
    const tree = this.#tree;
    const stems = this.#stems;
    const outline = (mark: StemOutline, which: number | null): boolean => {
      const there = tree !== null && stems !== null && which !== null && which < stems.count;
      mark.visible = there;
      if (there) mark.set(stemPieces(tree, stems.firstPiece[which] as number), stems.level[which] as number);
      return there;
    };
    const selected = outline(this.#selected, stem);
    outline(this.#hovered, hoveredStem === stem ? null : hoveredStem);
    const held = selected && handles && !throwing && tree && stems && stem !== null;
    this.#ends = held ? stemEnds(tree, stems, stem) : null;
    this.stemHandles.visible = this.#ends !== null;
    if (tree && this.#ends) this.stemHandles.set(tree, this.#ends);
    if (envelope) this.#loading ??= this.#loadEnvelope();
    this.#showEnvelope();
  }

  async #loadEnvelope(): Promise<void> {
    const { Envelope } = await import('./envelope.ts');
    this.#envelope = new Envelope(this.#uniforms);
    this.add(this.#envelope);
    this.#showEnvelope();
    this.#changed();
  }

  #showEnvelope(): void {
    const { envelope = null } = this.#wanted;
    const drawn = this.#envelope;
    if (!drawn) return;
    drawn.visible = this.#size !== null && envelope !== null;
    if (this.#size) drawn.fit(this.#size);
    if (envelope) drawn.set(envelope);
  }

  #show(): void {
    const { arrows, fronts, handle, probe, highlight } = this.#wanted;
    const tree = this.#tree;
    const has = (piece: number | null): piece is number => tree !== null && piece !== null && piece < tree.pieceCount;
    this.#arrows.visible = tree !== null && arrows;
    this.#fronts.visible = tree !== null && fronts;
    this.handle.visible = tree !== null && handle;
    this.#marker.visible = has(probe);
    if (tree && has(probe)) this.#marker.stick(probe, isOdd(tree, probe));
    this.#highlight.visible = has(highlight);
    if (tree && has(highlight)) this.#highlight.set(stemPieces(tree, highlight));
    this.#showStems();
  }
}
