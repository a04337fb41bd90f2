import { collar } from '../deform/collar.ts';
import { type Shape, stemRadius } from '../deform/radius.ts';
import { type BarkWrap, type WrappedStem, wrapPoint } from '../look/bark-wrap.ts';
import { bezierDerivative, bezierPoint, bezierSecondDerivative, type Cubic } from '../math/bezier.ts';
import { type Handles, handlesOf, sectionFrame } from '../math/frames.ts';
import { cosTurns, sinTurns } from '../math/trig.ts';
import { length, type Mat3, subtract, type Vec3 } from '../math/vec3.ts';
import type { Pose } from '../wind/pose.ts';
import { COLLAR } from './level-shape.ts';
import type { PieceTable } from './piece-table.ts';

/** Below this part of the speed a section's inner side would fold over: as in `surfacePoint`. */
const FOLD = 0.01;

/** A tip thinner than this part of the stem's radius is a point. */
const POINTED = 1e-4;

/**
 * Writes stems ring by ring into the arrays of a mesh: the surface of `surfacePoint` (core/deform) with what a ring shares computed once,
 * collar and all, as shaders/branch/vertex.glsl draws it. A test holds it to `surfacePoint`.
 */
export class StemWriter {
  vertices = 0;
  indices = 0;
  readonly #position: Float32Array;
  readonly #normal: Float32Array;
  readonly #tangent: Float32Array;
  readonly #uv: Float32Array;
  readonly #piece: Uint32Array;
  readonly #u: Float32Array;
  readonly #v: Float32Array;
  readonly #level: Uint8Array;
  readonly #index: Uint32Array;
  readonly #table: PieceTable;
  readonly #wrap: BarkWrap;
  #bark: WrappedStem | null = null;
  #shape: Shape | null = null;
  #stemLevel = 0;
  #sectors = 3;
  #cosines: number[] = [];
  #sines: number[] = [];
  #at = 0;
  #curve: Cubic | null = null;
  #handles: Handles | null = null;
  /** First vertex of the latest ring of this stem, -1 before the first, and of the one before. */
  #ring = -1;
  #before = -1;
  #lastU = 0;

  constructor(vertices: number, triangles: number, table: PieceTable, wrap: BarkWrap) {
    this.#position = new Float32Array(3 * vertices);
    this.#normal = new Float32Array(3 * vertices);
    this.#tangent = new Float32Array(4 * vertices);
    this.#uv = new Float32Array(2 * vertices);
    this.#piece = new Uint32Array(vertices);
    this.#u = new Float32Array(vertices);
    this.#v = new Float32Array(vertices);
    this.#level = new Uint8Array(vertices);
    this.#index = new Uint32Array(3 * triangles);
    this.#table = table;
    this.#wrap = wrap;
  }

  /** Begins a stem. */
  begin(shape: Shape, level: number, sectors: number): void {
    this.#shape = shape;
    this.#stemLevel = level;
    if (sectors !== this.#sectors || this.#cosines.length === 0) {
      // The last column stands where the first does, to the bit: the seam is closed.
      const columns = Array.from({ length: sectors + 1 }, (_, column) => (column % sectors) / sectors);
      this.#cosines = columns.map(cosTurns);
      this.#sines = columns.map(sinTurns);
    }
    this.#sectors = sectors;
    this.#ring = -1;
    this.#before = -1;
  }

  /** Goes on to a piece of the stem, as it stands. */
  enter(piece: number, { curve, o }: Pose): void {
    this.#at = piece;
    const { baseRadius, length, phase } = this.#table;
    this.#bark = {
      shape: this.#shape as Shape,
      level: this.#stemLevel,
      baseRadius: baseRadius[piece]!,
      length: length[piece]!,
      phase: phase[piece]!,
    };
    this.#curve = curve;
    this.#handles = handlesOf(curve, o);
  }

  /** A ring at a Bezier parameter of the piece, and the band from the one before. */
  ring(u: number): void {
    const first = this.vertices;
    const columns = this.#sectors + 1;
    const section = this.#section(u);
    for (let column = 0; column < columns; column++) {
      const turns = column / this.#sectors;
      this.#vertex(section, this.#cosines[column]!, this.#sines[column]!, turns, false);
    }
    if (this.#ring >= 0) {
      for (let column = 0; column < this.#sectors; column++) {
        const a = this.#ring + column;
        const b = first + column;
        this.#triangle(a, a + 1, b + 1);
        this.#triangle(a, b + 1, b);
      }
    }
    this.#before = this.#ring;
    this.#ring = first;
    this.#lastU = u;
  }

  /** Ends the stem: a point where its radius has come to nothing, else a cap. */
  close(): void {
    const section = this.#section(this.#lastU);
    const pointed = section.radius < POINTED * this.#table.baseRadius[this.#at]!;
    if (pointed && this.#before >= 0) {
      // The last ring is one point: a fan from the ring before takes the place of its band.
      this.vertices = this.#ring;
      this.indices -= 6 * this.#sectors;
      this.#ring = this.#before;
    }
    for (let column = 0; column < this.#sectors; column++) {
      const turns = (column + 0.5) / this.#sectors;
      const centre = this.vertices;
      this.#vertex(section, cosTurns(turns), sinTurns(turns), turns, true);
      if (!pointed) this.#normal.set(section.frame[0], 3 * centre);
      this.#triangle(this.#ring + column, this.#ring + column + 1, centre);
    }
  }

  /** The arrays, cut to what was written. */
  done() {
    const n = this.vertices;
    return {
      vertexCount: n,
      triangleCount: this.indices / 3,
      position: this.#position.slice(0, 3 * n),
      normal: this.#normal.slice(0, 3 * n),
      tangent: this.#tangent.slice(0, 4 * n),
      uv: this.#uv.slice(0, 2 * n),
      piece: this.#piece.slice(0, n),
      u: this.#u.slice(0, n),
      v: this.#v.slice(0, n),
      level: this.#level.slice(0, n),
      index: this.#index.slice(0, this.indices),
    };
  }

  #section(u: number): Section {
    const curve = this.#curve as Cubic;
    const table = this.#table;
    const at = this.#at;
    const z0 = table.z0[at]!;
    const part = table.z1[at]! - z0;
    const z = z0 + part * u;
    const along = z * table.length[at]!;
    const speed = length(bezierDerivative(curve, u));
    return {
      u,
      z,
      part,
      along,
      centre: bezierPoint(curve, u),
      frame: sectionFrame(curve, this.#handles as Handles, u),
      speed: Math.max(speed, 1e-6 * length(subtract(curve.p3, curve.p0))),
      second: bezierSecondDerivative(curve, u),
      // Around a trunk the radius changes: what all directions share is that of the direction of T.
      radius: this.#radius(z, along, 0)[0],
    };
  }

  #radius(z: number, along: number, turns: number): [radius: number, byZ: number, q: number] {
    const table = this.#table;
    const at = this.#at;
    const stem = table.length[at]!;
    const [radius, byZ, q] = stemRadius(this.#shape as Shape, table.baseRadius[at]!, stem, z, turns);
    const [swell, slope] = collar(along, radius, table.parentRadius[at]!, COLLAR);
    return [radius * swell, byZ * swell + radius * slope * stem, q];
  }

  #vertex(
    { u, z, part, along, centre, frame, speed, second }: Section,
    c: number,
    s: number,
    turns: number,
    axis: boolean,
  ) {
    const [U, T, S] = frame;
    const [rho, byZ, q] = this.#radius(z, along, turns);
    const rhoU = byZ * part;
    const rx = s * S[0] + c * T[0];
    const ry = s * S[1] + c * T[1];
    const rz = s * S[2] + c * T[2];
    const tx = c * S[0] - s * T[0];
    const ty = c * S[1] - s * T[1];
    const tz = c * S[2] - s * T[2];
    const bend = speed > 0 ? (second[0] * rx + second[1] * ry + second[2] * rz) / speed : 0;
    const g = Math.max(speed - rho * bend, FOLD * speed);
    const nx = g * rx - rhoU * U[0] - g * q * tx;
    const ny = g * ry - rhoU * U[1] - g * q * ty;
    const nz = g * rz - rhoU * U[2] - g * q * tz;
    const n = Math.sqrt(nx * nx + ny * ny + nz * nz);
    const ax = tx + q * rx;
    const ay = ty + q * ry;
    const az = tz + q * rz;
    const a = 1 / Math.sqrt(ax * ax + ay * ay + az * az);
    const i = this.vertices++;
    const out = axis ? 0 : rho;
    this.#position[3 * i] = centre[0] + out * rx;
    this.#position[3 * i + 1] = centre[1] + out * ry;
    this.#position[3 * i + 2] = centre[2] + out * rz;
    const inverse = n > 1e-12 ? 1 / n : 0;
    this.#normal[3 * i] = n > 1e-12 ? nx * inverse : rx;
    this.#normal[3 * i + 1] = n > 1e-12 ? ny * inverse : ry;
    this.#normal[3 * i + 2] = n > 1e-12 ? nz * inverse : rz;
    this.#tangent[4 * i] = ax * a;
    this.#tangent[4 * i + 1] = ay * a;
    this.#tangent[4 * i + 2] = az * a;
    this.#tangent[4 * i + 3] = 1;
    const [across, up] = wrapPoint(this.#wrap, this.#bark as WrappedStem, turns, z);
    this.#uv[2 * i] = across;
    this.#uv[2 * i + 1] = up;
    this.#piece[i] = this.#at;
    this.#u[i] = u;
    this.#v[i] = z;
    this.#level[i] = this.#stemLevel;
  }

  #triangle(a: number, b: number, c: number): void {
    this.#index[this.indices] = a;
    this.#index[this.indices + 1] = b;
    this.#index[this.indices + 2] = c;
    this.indices += 3;
  }
}

/** What all vertices of a ring share. */
interface Section {
  readonly u: number;
  readonly z: number;
  readonly part: number;
  readonly along: number;
  readonly centre: Vec3;
  /** Columns U, T^ and S^. */
  readonly frame: Mat3;
  readonly speed: number;
  readonly second: Vec3;
  readonly radius: number;
}
