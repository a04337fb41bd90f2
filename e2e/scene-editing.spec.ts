import { expect, type Page, test } from '@playwright/test';
import { BARE, open, settled, state } from './editor-page.ts';

// Wide enough that limbs end beside the panels, not below them.
test.use({ viewport: { width: 1280, height: 720 } });

/** The aspen with its limbs and nothing on them, from near enough that each is a hundred pixels long. */
const LIMBS = `${BARE}&tree.levels=2&cam=11,3,20,0,8,0`;
const ASKED = { 'tree.levels': 2 };

// Work on the tree in the scene itself, with a mouse: what is pointed at, selected, dragged.

const onScreen = (page: Page) => page.evaluate(() => window.windgrove!.onScreen());

type Point = readonly [x: number, y: number];

/** Nine points a piece, as `onScreen` gives them. */
const POINTS = 9;

/** A limb that stands free of the others and is seen from the side: its stem, and the place half along it. */
async function freeLimb(page: Page): Promise<{ stem: number; at: Point }> {
  const { branches, stems } = await onScreen(page);
  const point = (piece: number, k: number): Point => [
    branches[2 * (POINTS * piece + k)]!,
    branches[2 * (POINTS * piece + k) + 1]!,
  ];
  const { width, height } = page.viewportSize()!;
  let best = { room: 0, stem: -1, at: [0, 0] as Point };
  for (const [piece, stem] of stems.entries()) {
    if (stem === 0 || stems.indexOf(stem) !== piece) continue;
    const at = point(piece, 5);
    // Panels lie over the sides of the picture.
    if (at[0] < 0.36 * width || at[0] > 0.64 * width || at[1] < 90 || at[1] > height - 160) continue;
    let room = Math.hypot(point(piece, 8)[0] - at[0], point(piece, 8)[1] - at[1]);
    for (const [other, its] of stems.entries()) {
      if (its === stem) continue;
      for (let k = 0; k < POINTS; k++) {
        const [x, y] = point(other, k);
        room = Math.min(room, Math.hypot(x - at[0], y - at[1]));
      }
    }
    if (room > best.room) best = { room, stem, at };
  }
  expect(best.room).toBeGreaterThan(9);
  return best;
}

const cursor = (page: Page): Promise<string> =>
  page.evaluate(() => document.querySelector<HTMLCanvasElement>('canvas[role="img"]')!.style.cursor);

/** Selects a free limb and waits for its handles. */
async function select(page: Page) {
  const limb = await freeLimb(page);
  await page.mouse.click(...limb.at);
  await settled(page);
  const { handles } = await onScreen(page);
  return { ...limb, handles };
}

/** Lets the limb go by a click on the sky. */
async function letGo(page: Page): Promise<void> {
  await page.mouse.click(0.66 * page.viewportSize()!.width, 96);
  await settled(page);
}

/** Drags from one place to another, in steps as a hand does. */
async function drag(page: Page, [x, y]: Point, [dx, dy]: Point): Promise<void> {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 3 });
  await page.mouse.move(x + dx, y + dy, { steps: 3 });
  await page.mouse.up();
  await settled(page);
}

/** How far a handle is from where it was dragged to: the tree that has grown meanwhile follows the hand. */
async function missed(page: Page, kind: 'length' | 'curve' | 'down', [x, y]: Point): Promise<number> {
  const [nowX, nowY] = (await onScreen(page)).handles[kind]!;
  return Math.hypot(nowX - x, nowY - y);
}

test('names the stem under the mouse, selects it with a click, turns the camera meanwhile, and lets it go with one on the sky', async ({
  page,
}) => {
  const complaints = await open(page, LIMBS);
  const { at } = await freeLimb(page);
  await page.mouse.move(at[0] - 3, at[1]);
  await page.mouse.move(...at);
  const named = page.locator('.stem-name').first();
  await expect(named).toContainText(/Limb \d+ of \d+/);
  await page.mouse.click(...at);
  await settled(page);
  expect(Object.keys((await onScreen(page)).handles).sort()).toContain('length');
  await letGo(page);
  expect((await onScreen(page)).handles).toEqual({});

  // The camera turns where nothing is held, and what is selected stays so.
  const { stem } = await select(page);
  const before = (await state(page)).camera;
  const { width, height } = page.viewportSize()!;
  await drag(page, [0.66 * width, 0.7 * height], [-60, 0]);
  await expect.poll(async () => (await state(page)).camera).not.toEqual(before);
  expect((await state(page)).edits).toEqual(ASKED);
  expect((await onScreen(page)).stems[0]).toBe(0);
  expect(Object.keys((await onScreen(page)).handles)).toContain('length');
  expect(stem).toBeGreaterThan(0);
  expect(complaints).toEqual([]);
});

test('handles make all limbs longer, leave wider and bend, each in one step of the history', async ({ page }) => {
  await open(page, LIMBS);
  const { handles, stem } = await select(page);
  const tip = handles.length as Point;
  await page.mouse.move(...tip);
  await expect.poll(() => cursor(page)).toBe('grab');
  const { branches, stems } = await onScreen(page);
  const first = stems.indexOf(stem);
  const [bx, by] = [branches[2 * POINTS * first]!, branches[2 * POINTS * first + 1]!];
  // 20 pixels beyond the tip: half as long again is half of what lies between.
  const reach = Math.hypot(tip[0] - bx, tip[1] - by) - 20;
  const way: Point = [(tip[0] - bx) / (reach + 20), (tip[1] - by) / (reach + 20)];
  expect((await state(page)).edits).toEqual(ASKED);
  await drag(page, tip, [0.5 * reach * way[0], 0.5 * reach * way[1]]);
  const longer = (await state(page)).edits['levels.1.length'] as number;
  // The aspen's limbs are 0.3 of the trunk.
  expect(longer / 0.3).toBeGreaterThan(1.3);
  expect(longer / 0.3).toBeLessThan(1.75);
  expect(await missed(page, 'length', [tip[0] + 0.5 * reach * way[0], tip[1] + 0.5 * reach * way[1]])).toBeLessThan(20);
  const back = async (): Promise<void> => {
    await page.keyboard.press('Control+z');
    await settled(page);
    expect((await state(page)).edits).toEqual(ASKED);
    await letGo(page);
  };
  await back();

  // The down angle by the handle on the arc.
  const { down, length } = (await select(page)).handles as Record<'down' | 'length', Point>;
  // Down, away from the trunk's top: the limb leaves at a wider angle.
  expect(length[1]).toBeLessThan(down[1] + 200);
  await drag(page, down, [0, 22]);
  const opened = (await state(page)).edits;
  expect(Object.keys(opened)).toEqual(['tree.levels', 'levels.1.downAngle']);
  const angle = opened['levels.1.downAngle'] as number;
  expect(angle).toBeGreaterThan(65);
  expect(angle).toBeLessThan(130);
  expect(await missed(page, 'down', [down[0], down[1] + 22])).toBeLessThan(12);
  await back();

  // The curve by the one in the middle.
  const curve = (await select(page)).handles.curve as Point;
  expect(curve).toBeDefined();
  await drag(page, curve, [0, 24]);
  const bent = (await state(page)).edits;
  expect(Object.keys(bent)).toEqual(['tree.levels', 'levels.1.curve']);
  // The aspen's limbs rise with a curve of -40 degrees.
  expect(bent['levels.1.curve']).toBeGreaterThan(-30);
  expect(await missed(page, 'curve', [curve[0], curve[1] + 24])).toBeLessThan(16);
});

/** The editor's picture by itself. */
async function lab(page: Page): Promise<void> {
  await page.goto('e2e/pages/view-picture.html');
  await page.waitForFunction(() => 'scene' in window);
}

test('draws captures of any size beside the picture, at exact times, and portraits of other trees', async ({
  page,
}) => {
  await lab(page);
  const seen = await page.evaluate(() => window.scene.captures());
  // As on the screen: the same view at the same size and time differs in no more than rounding.
  expect(seen.same).toBeLessThan(0.002);
  expect(seen.apart).toBeGreaterThan(0.004);
  // What is seen was not touched, and a time gives what it gave before.
  expect([seen.undisturbed, seen.again]).toEqual([0, 0]);
  expect(seen.corners).toEqual([0, 0, 0, 0]);
  expect(seen.tree).toBeGreaterThan(0.005);
  expect(seen.tree).toBeLessThan(0.6);
  expect(seen.tiled).toBeLessThan(0.002);
  expect(seen.portrait.colours).toBeGreaterThan(500);
  expect(seen.portrait.size).toEqual([120, 150]);
  expect(seen.closed).toContain('closed');
});

test('sets a hundred trees and keeps nothing of them; while one is dragged springs start near', async ({ page }) => {
  await lab(page);
  const { before, after, far, near, pure, again } = await page.evaluate(() => window.scene.trees());
  const { VertexArray: first, ...held } = before as Record<string, number>;
  const { VertexArray: last, ...kept } = after as Record<string, number>;
  expect(kept).toEqual(held);
  // One for each pair of mesh and program, made as it is first drawn: a few come late, ninety trees would leave hundreds.
  expect(last! - first!).toBeLessThan(9);
  // A far time takes some draws; a draft is there at once, and the tree that follows it is as if it had always stood there.
  expect(far).toBeGreaterThan(1);
  expect(near).toBe(1);
  expect(pure).toBeGreaterThan(1);
  expect(again).toBe(0);
});
