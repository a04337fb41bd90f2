import { PerspectiveCamera } from 'three';
import { frameTree } from '../../src/view/framing.ts';
import { drawStillPicture } from '../../src/view/still-picture.ts';
import { grown } from './grown.ts';

// The picture that is shown without WebGL2: `species` and `dark` in the address.
const q = new URLSearchParams(location.search);
const canvas = document.querySelector('canvas') as HTMLCanvasElement;
const { species, packed, box } = await grown(q.get('species') ?? 'quaking-aspen', 1);
canvas.width = innerWidth;
canvas.height = innerHeight;
const aspect = canvas.width / canvas.height;
const { position, target } = frameTree(box, 30, aspect, 0.2);
const camera = new PerspectiveCamera(30, aspect, 0.1, 1000);
camera.position.copy(position);
camera.lookAt(target);
const start = performance.now();
drawStillPicture(canvas.getContext('2d') as CanvasRenderingContext2D, camera, packed, species, { dark: q.has('dark') });
Object.assign(window, { done: true, report: { milliseconds: performance.now() - start } });
