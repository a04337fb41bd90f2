import {
  AmbientLight,
  AnimationMixer,
  Box3,
  DirectionalLight,
  type Mesh,
  type MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { ExportOptions } from '../../src/core/io/export-options.ts';
import type { Species } from '../../src/core/species/species.ts';
import type { Wind } from '../../src/core/wind/wind.ts';
import { exportInWorker } from '../../src/view/picture/export-in-worker.ts';

// Exports a tree in the worker, reads it again with three's loader and draws it: what a person does with our file.

/** What is asked of the page. */
export interface Asked {
  readonly species: Species;
  readonly seed: number;
  readonly wind: Wind;
  readonly options: ExportOptions;
}

/** What came of it. */
export interface Answer {
  readonly hash: string;
  readonly bytes: number;
  readonly stages: readonly string[];
  readonly nodes: number;
  readonly triangles: number;
  readonly bounds: readonly number[];
  readonly seconds: number;
  readonly images: readonly (readonly [name: string, width: number])[];
  /** Part of the picture that the tree covers, its mean colour, and the part that differs a second later. */
  readonly covered: number;
  readonly colour: readonly number[];
  readonly moved: number;
}

const canvas = document.querySelector('canvas') as HTMLCanvasElement;

async function hashOf(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

async function exported({ species, seed, wind, options }: Asked): Promise<Answer> {
  const stages: string[] = [];
  const [file] = await exportInWorker(species, seed, wind, options, { onProgress: ({ stage }) => stages.push(stage) });
  if (!file) throw new Error('no file');
  const hash = await hashOf(file.bytes);
  const { scene: tree, animations } = await new GLTFLoader().parseAsync(file.bytes.buffer, '');
  const renderer = new WebGLRenderer({ canvas, preserveDrawingBuffer: true });
  const scene = new Scene();
  const sun = new DirectionalLight('#fff', 2);
  sun.position.set(1, 2, 1.5);
  scene.add(tree, sun, new AmbientLight('#fff', 1));
  const box = new Box3().setFromObject(tree, true);
  const size = box.getSize(new Vector3());
  const centre = box.getCenter(new Vector3());
  const camera = new PerspectiveCamera(30, canvas.width / canvas.height, 0.1, 500);
  camera.position.copy(centre).add(new Vector3(0, 0, 2.4 * Math.max(size.y, size.x)));
  const mixer = new AnimationMixer(tree);
  for (const clip of animations) mixer.clipAction(clip).play();
  const picture = (time: number): Uint8Array => {
    mixer.setTime(time);
    renderer.render(scene, camera);
    const gl = renderer.getContext();
    const pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  };
  const [a, b] = [picture(0).slice(), picture(1)];
  const count = canvas.width * canvas.height;
  const sum = [0, 0, 0];
  let covered = 0;
  let moved = 0;
  for (let i = 0; i < a.length; i += 4) {
    const lit = [0, 1, 2].map((k) => a[i + k] as number);
    if (Math.max(...lit) > 8) {
      covered++;
      lit.forEach((x, k) => {
        sum[k] = (sum[k] as number) + x;
      });
    }
    if (lit.some((x, k) => Math.abs(x - (b[i + k] as number)) > 12)) moved++;
  }
  const images = new Map<string, number>();
  let nodes = 0;
  let triangles = 0;
  tree.traverse((part) => {
    nodes++;
    const mesh = part as Mesh;
    if (!mesh.isMesh) return;
    triangles += (mesh.geometry.index?.count ?? 0) / 3;
    const { map, normalMap, roughnessMap, aoMap } = mesh.material as MeshStandardMaterial;
    for (const texture of [map, normalMap, roughnessMap, aoMap]) {
      if (texture) images.set(texture.name, (texture.image as { width: number }).width);
    }
  });
  renderer.dispose();
  return {
    hash,
    bytes: file.bytes.length,
    stages: [...new Set(stages)],
    nodes,
    triangles,
    bounds: [...box.min.toArray(), ...box.max.toArray()],
    seconds: animations[0]?.duration ?? 0,
    images: [...images],
    covered: covered / count,
    colour: sum.map((x) => x / Math.max(1, covered)),
    moved: moved / count,
  };
}

/** Begins an export and calls it off when it first tells how far it is: the name of what it rejects with. */
async function calledOff({ species, seed, wind, options }: Asked): Promise<string> {
  const control = new AbortController();
  try {
    await exportInWorker(species, seed, wind, options, { signal: control.signal, onProgress: () => control.abort() });
    return 'done';
  } catch (error) {
    return error instanceof Error ? error.name : String(error);
  }
}

export type ExportPage = { readonly exported: typeof exported; readonly calledOff: typeof calledOff };

Object.assign(window, { windgroveExport: { exported, calledOff } satisfies ExportPage });
document.documentElement.dataset.ready = 'true';
