import { expect, type Page, test } from '@playwright/test';
import type { Check, Report } from '../src/gpu/crosscheck/report.ts';

/** A whole run takes half a minute on a quiet machine with software GL, and its time on a busy one. */
const LONGEST = 240_000;

/** Opens the page and waits for its report: the text of `#report`, written when all is done. */
async function reportOf(page: Page, query = ''): Promise<Report> {
  await page.goto(`crosscheck.html${query}`);
  await expect(page.locator('#report')).not.toBeEmpty({ timeout: LONGEST });
  return JSON.parse((await page.locator('#report').textContent()) ?? '');
}

/** Functions of the GLSL library that have a twin, and what is checked as a whole: each has at least one line. */
const MUST_BE_CHECKED = [
  'sinTurns',
  'cosTurns',
  'power',
  'angleOfChord',
  'hashPcg',
  'hashUnit',
  'texelOf',
  'leafSwing',
  'leanTowards',
  'turnAlong',
  'hemiOctahedral',
  'fromHemiOctahedral',
  'viewDirection',
  'viewFrame',
  'nearestViews',
  'treePixels',
  'treeShare',
  'treeShares',
  'ditherAt',
  'cardTexel',
  'leafTexel',
  'leafTree',
  'rotateByQuaternion',
  'matrixFromQuaternion',
  'bezierPoint',
  'bezierDerivative',
  'bezierSecondDerivative',
  'arcLength',
  'holdArc',
  'edgesOf',
  'handlesOf',
  'projectedHandlesOf',
  'transport',
  'tangentAt',
  'sectionFrame',
  'taperRadius',
  'powerTaper',
  'flare',
  'clampedFlare',
  'bulges',
  'lobes',
  'stemRadius',
  'surfacePoint',
  'paperSurfacePoint',
  'windForce',
  'linearWindForce',
  'wavesForce',
  'wavePush',
  'profileFactor',
  'gustsForce',
  'recordForce',
  'gustEnvelope',
  'gustWidth',
  'gustPush',
  'bendVector',
  'bendPiece',
  'mixPush',
  'springTarget',
  'springStep',
  'mixSpring',
  'springStir',
  'swaySwing',
  'swayStir',
  'poseFromParent',
  'branch deformer, variants',
  ...['forest', 'aspen'].flatMap((tree) => [
    `rest pose, ${tree}`,
    ...['direct, exact', 'spring, exact', 'sway, exact', 'direct, lagged', 'spring, lagged'].flatMap((how) => [
      ...[1, 10, 600].map((step) => `wind pass, ${tree}, ${how}, step ${step}`),
      `wind pass, ${tree}, ${how}, arc length`,
      `wind pass, ${tree}, ${how}, sought`,
      `wind pass, ${tree}, ${how}, sought back and forth`,
    ]),
    ...['bark', 'bark of a trunk', 'bark of a plain stem'].flatMap((bark) => [
      `deformed ${tree}, ${bark}, positions`,
      `deformed ${tree}, ${bark}, normals`,
    ]),
    `deformed ${tree}, leaves, positions`,
    `deformed ${tree}, leaves, normals`,
  ]),
  'wind pass, forest, paper, direct, exact, step 600',
  ...['direct', 'spring'].flatMap((model) => [
    `wind pass, ${model}, 8 waves, gusts, profile and record, between two steps`,
    `wind pass, ${model}, 16 waves while one wind fades into another, at a step`,
  ]),
  ...['direct', 'spring', 'sway'].flatMap((from) =>
    ['direct', 'spring', 'sway']
      .filter((to) => to !== from)
      .map((to) => `wind pass, ${from} fading into ${to}, between two steps`),
  ),
  'spring, free decay, frequency',
  'spring, free decay, damping',
  'spring, a small tree, 20,000 steps at Beaufort 11',
  'spring, a small tree, 20,000 steps at Beaufort 11, arc length',
  'wind pass, spring, an edit while playing',
  'wind pass, spring, sought after an edit',
  'wind pass, spring, while it catches up',
  'wind pass, no tip leaps',
  'wind pass, exact, read back',
  'wind pass, lagged, read back',
  'wind pass, dispose',
  ...['direct', 'spring', 'sway'].map((model) => `pose on the CPU, aspen, ${model}`),
  'wind pass, settings of the renderer',
  'wind pass, spring, exact, after a lost context',
  'wind pass, spring, lagged, after a lost context',
];

/** What is asked for less than a thousandth: measured of a swing rather than computed, or of numbers in the thousands. */
const LOOSER: Record<string, number> = {
  'spring, free decay, frequency': 0.01,
  'spring, free decay, damping': 0.01,
  'springStep, acceleration': 0.02,
};

test.describe('on this renderer', () => {
  let report: Report;
  const errors: string[] = [];
  let shown = '';
  let rows = 0;

  test.beforeAll(async ({ browser }) => {
    test.setTimeout(LONGEST + 20_000);
    const page = await browser.newPage();
    page.on('pageerror', (error) => errors.push(error.message));
    report = await reportOf(page);
    shown = (await page.locator('main').textContent()) ?? '';
    rows = await page.locator('#checks tr').count();
    await page.close();
  });

  test('every check passes', () => {
    const failed = report.checks.filter((check) => !check.pass);
    expect(failed).toEqual([]);
    expect(report.reason).toBeUndefined();
    expect(report.pass).toBe(true);
    expect(errors).toEqual([]);
  });

  test('the renderer is named and the table shows each check', () => {
    expect(report.renderer.length).toBeGreaterThan(3);
    expect(shown).toContain(report.renderer);
    expect(rows).toBe(report.checks.length);
    expect(shown).toContain('agrees with the reference');
  });

  test('each function and each whole is checked', () => {
    const names = report.checks.map((check) => check.name);
    const missing = MUST_BE_CHECKED.filter((wanted) => !names.some((name) => name.startsWith(wanted)));
    expect(missing).toEqual([]);
    expect(new Set(names).size).toBe(names.length);
  });

  test('no check is vacuous', () => {
    // Two computations that agree to the last bit are one computation, but for what is exact by design: tolerance 0.
    const vacuous = ({ samples, maxError, tolerance }: Check) =>
      samples === 0 || (tolerance > 0 && maxError === 0) || maxError < 0;
    expect(report.checks.filter(vacuous)).toEqual([]);
    const loose = report.checks.filter(({ name, tolerance }) => tolerance > (LOOSER[name] ?? 1e-3));
    expect(loose).toEqual([]);
  });
});

test('the table fits a phone', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 800 });
  await page.goto('crosscheck.html');
  await expect(page.locator('#checks tr').first()).toBeVisible();
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(width).toBeLessThanOrEqual(390);
  await expect(page.locator('#checks td').first()).toBeVisible();
});

test('without WebGL2 the page says so', async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const report = await reportOf(page);
  expect(report.pass).toBe(false);
  expect(report.checks).toEqual([]);
  expect(report.reason).toContain('WebGL2');
  await expect(page.locator('#verdict')).toContainText('WebGL2');
});

test('without float targets the page says so', async ({ page }) => {
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const original = gl.getExtension as (name: string) => unknown;
    gl.getExtension = function (this: WebGL2RenderingContext, name: string) {
      return name === 'EXT_color_buffer_float' ? null : original.call(this, name);
    } as typeof gl.getExtension;
  });
  const report = await reportOf(page);
  expect(report.pass).toBe(false);
  expect(report.reason).toContain('32-bit float');
});

test('a GPU that gives wrong numbers from float targets is found out', async ({ page }) => {
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const original = gl.readPixels as (...args: unknown[]) => void;
    gl.readPixels = function (this: WebGL2RenderingContext, ...args: unknown[]) {
      original.apply(this, args);
      const out = args[6];
      if (out instanceof Float32Array) out.set(out.map((value) => Math.round(value * 1024) / 1024));
    } as typeof gl.readPixels;
  });
  const report = await reportOf(page);
  expect(report.pass).toBe(false);
  expect(report.reason).toContain('wrong numbers');
});
