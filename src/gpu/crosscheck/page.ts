import { WebGLRenderer } from 'three';
import { faultText } from '../../core/file/fault.ts';
import { growPacked } from '../../core/pack/grow-packed.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { parseSpecies } from '../../core/species/parse.ts';
import { capabilitiesOf, probePage } from '../capabilities.ts';
import { rendererName } from '../renderer-name.ts';
import { gale, galeOf, printed, rareWinds } from './check-winds.ts';
import { checkDeformers } from './deform-checks.ts';
import { curvePrograms } from './functions/curves.ts';
import { forestPrograms } from './functions/forests.ts';
import { leafPrograms } from './functions/leaves.ts';
import { numberPrograms } from './functions/numbers.ts';
import { surfacePrograms } from './functions/surfaces.ts';
import { windPrograms } from './functions/winds.ts';
import { checkCpuPoser, checkSettings } from './host-checks.ts';
import { checkContextLoss } from './loss-checks.ts';
import { checkPass, checkRareWind, checkRest } from './pass-checks.ts';
import { type Check, report } from './report.ts';
import { runProgram } from './run-program.ts';
import { checkBounded, checkFreeDecay, checkLongRun } from './spring-checks.ts';
import { checkDispose, checkEdit, checkReadBack, checkStandIn } from './state-checks.ts';
import { syntheticTree } from './synthetic-tree.ts';
import { showChecks, showRenderer, showReport } from './table.ts';
import { checkTips } from './tip-checks.ts';
import { checkVariants } from './variant-checks.ts';

const PIECES = 1500;
const SEED = 1;
/** A tree small enough to be read at every step. */
const FEW = 200;
/** Five and a half minutes of wind. */
const MANY = 20_000;
/** What takes minutes on a software renderer is left to who asks for it. */
const LONG = new URLSearchParams(location.search).has('long');

/** Lets the page draw what it has: a run takes seconds on a software renderer. */
const breathe = () => new Promise((resolve) => setTimeout(resolve));

/** The tree that everybody sees first, grown here. */
async function aspen(): Promise<PackedTree> {
  const answer = await fetch(new URL('species/quaking-aspen.json', document.baseURI));
  const { species, faults } = parseSpecies(await answer.text());
  if (!species) throw new Error(`Quaking aspen: ${faultText(faults[0])}`);
  return growPacked(species, SEED).packed;
}

/** All checks in order, a few at a time; the context is lost in the last of them. */
async function* allChecks(renderer: WebGLRenderer): AsyncGenerator<readonly Check[]> {
  for (const program of [
    ...numberPrograms,
    ...curvePrograms,
    ...surfacePrograms,
    ...leafPrograms,
    ...forestPrograms,
    ...windPrograms,
  ]) {
    yield runProgram(renderer, program);
  }
  const forest = syntheticTree(PIECES);
  const tree = await aspen();
  for (const [name, of] of [
    ['forest', forest],
    ['aspen', tree],
  ] as const) {
    yield checkRest(renderer, name, of);
    for (const wind of checkedWinds(name)) yield checkPass(renderer, name, of, wind);
    yield checkDeformers(renderer, name, of, galeOf('direct'));
  }
  yield checkPass(renderer, 'forest', forest, printed);
  const few = syntheticTree(FEW, 5, 3);
  for (const [name, source] of rareWinds()) yield checkRareWind(renderer, few, name, source);
  yield checkFreeDecay(renderer, few);
  yield checkBounded(renderer, 'a small tree', syntheticTree(60, 5), MANY);
  if (LONG) {
    yield checkBounded(renderer, 'aspen', tree, MANY);
    yield [checkLongRun(renderer, 'aspen', tree, MANY)];
  }
  yield [checkVariants(renderer, forest)];
  yield (['direct', 'spring', 'sway'] as const).map((model) => checkCpuPoser(renderer, 'aspen', tree, galeOf(model)));
  yield [checkSettings(renderer, forest, gale)];
  yield checkEdit(renderer, few, gale, { ...galeOf('spring'), stiffness: 2, spring: { ...gale.spring, damping: 0.3 } });
  yield [checkTips(renderer, few)];
  yield [checkStandIn(renderer, few, gale)];
  yield await checkReadBack(renderer, few, gale);
  yield [checkDispose(renderer, few, [galeOf('sway'), galeOf('spring'), galeOf('spring', 'lagged')])];
  yield await checkContextLoss(renderer, forest, gale); // a forest: its roots do not stand at the origin, where zeros would do
}

/** Every model in both poses; the aspen's sway in one, since only its frames are new. */
const checkedWinds = (name: string) => [
  ...(['direct', 'spring', 'sway'] as const).map((model) => galeOf(model)),
  galeOf('direct', 'lagged'),
  galeOf('spring', 'lagged'),
  ...(name === 'forest' ? [galeOf('sway', 'lagged')] : []),
];

async function run(): Promise<void> {
  document.getElementById('longer')?.toggleAttribute('hidden', LONG);
  const page = probePage();
  if (!page.webgl2) return showReport(report('none', [], 0, page.reason));
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setSize(16, 16);
  const name = rendererName(renderer);
  showRenderer(name);
  const capabilities = capabilitiesOf(renderer);
  if (!capabilities.floatTargets) return showReport(report(name, [], 0, capabilities.reason));

  const start = performance.now();
  const checks: Check[] = [];
  for await (const more of allChecks(renderer)) {
    checks.push(...more);
    showChecks(more);
    await breathe();
  }
  showReport(report(name, checks, Math.round(performance.now() - start)));
}

run().catch((error: unknown) => {
  showReport(report('unknown', [], 0, `The cross-check could not run: ${String(error)}`));
  throw error;
});
