import { beforeEach, expect, test } from 'vitest';
import { type Grip, Hands } from '../../../src/view/picture/hands.ts';

class Press extends Event {
  readonly clientX: number;
  readonly clientY: number;

  constructor(name: string, x: number, y: number, rest: object = {}) {
    super(name, { cancelable: true });
    this.clientX = x;
    this.clientY = y;
    Object.assign(this, { pointerId: 1, button: 0, buttons: 0, isPrimary: true, pointerType: 'mouse' }, rest);
  }
}

let log: string[];
let canvas: EventTarget & { style: { cursor: string }; setPointerCapture(): void };
let turned: number;

const grip = (x: number): Grip => ({
  cursor: 'grab',
  distance: (px) => Math.abs(px - x),
  anchor: () => ({ x, y: 0 }),
  drag: (px, _py, done) => log.push(`drag ${px} ${done}`),
  hover: (on) => log.push(`hover ${on}`),
});

beforeEach(() => {
  log = [];
  turned = 0;
  canvas = Object.assign(new EventTarget(), { style: { cursor: '' }, setPointerCapture: () => {} });
  new Hands({
    canvas: canvas as unknown as HTMLElement,
    grips: [grip(100)],
    hold: (on) => log.push(`hold ${on}`),
    press: () => {},
    click: (x, y) => log.push(`click ${x} ${y}`),
  });
  // Node asks listeners in their order; a browser asks those that capture first, wherever the camera's stands.
  canvas.addEventListener('pointerdown', () => turned++);
});

const send = (name: string, x: number, y: number, rest?: object) => canvas.dispatchEvent(new Press(name, x, y, rest));

test('a grip is held where it was taken, and the camera keeps still meanwhile', () => {
  send('pointerdown', 108, 50);
  send('pointermove', 138, 50);
  send('pointerup', 148, 50);
  expect(log).toEqual(['hold true', 'hover true', 'drag 130 false', 'drag 140 true', 'hold false', 'hover false']);
  expect(turned).toBe(0);
});

test('a finger reaches farther than a mouse', () => {
  send('pointerdown', 120, 50);
  send('pointerup', 120, 50);
  expect(log).toEqual(['click 120 50']);
  expect(turned).toBe(1);
  send('pointerdown', 120, 50, { pointerType: 'touch' });
  expect(log.slice(1)).toEqual(['hold true', 'hover true']);
});

test('a drag beside the grips is the camera’s and no click, nor is a second finger', () => {
  send('pointerdown', 300, 50);
  send('pointerup', 320, 50);
  send('pointerdown', 300, 50);
  send('pointerdown', 350, 50, { pointerId: 2, isPrimary: false });
  send('pointerup', 350, 50, { pointerId: 2 });
  send('pointerup', 300, 50);
  expect(log).toEqual([]);
  expect(turned).toBe(3);
});

test('what is taken away is let go where it is', () => {
  send('pointerdown', 100, 50);
  send('pointercancel', 0, 0);
  expect(log).toEqual(['hold true', 'hover true', 'drag 100 true', 'hold false', 'hover false']);
});

test('says what it points at', () => {
  send('pointermove', 104, 50);
  expect(canvas.style.cursor).toBe('grab');
  send('pointermove', 300, 50);
  expect(canvas.style.cursor).toBe('');
});
