import { afterEach, expect, test, vi } from 'vitest';
import { Flight } from '../../src/forest/flight.ts';

afterEach(() => vi.unstubAllGlobals());

function fly() {
  const page = new EventTarget();
  vi.stubGlobal('window', page);
  vi.stubGlobal('HTMLElement', class {});
  const flight = new Flight(new EventTarget() as HTMLElement);
  flight.place({ x: 0, y: 0, z: 5, yaw: 90, pitch: 0 });
  const key = (type: 'keydown' | 'keyup', code: string) =>
    page.dispatchEvent(Object.assign(new Event(type, { cancelable: true }), { code }));
  return { flight, key };
}

test('a key that went down and up again between two slow frames still moves the eye, once', () => {
  const { flight, key } = fly();
  key('keydown', 'KeyW');
  key('keyup', 'KeyW');
  flight.update(0.4);
  expect(flight.eye.y).toBeGreaterThan(1);
  for (let frame = 0; frame < 20; frame++) flight.update(0.4);
  const { y } = flight.eye;
  expect([flight.update(0.4), flight.eye.y]).toEqual([false, y]);
});
