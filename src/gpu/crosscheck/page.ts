import { WebGLRenderer } from 'three';
import { growPacked } from '../../core/pack/grow-packed.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { faultText, parseSpecies } from '../../core/species/parse.ts';
import { presets } from '../../core/wind/presets.ts';
import { capabilitiesOf, probePage } from '../capabilities.ts';
import { rendererName } from '../renderer-name.ts';
import { checkDeformers } from './deform-checks.ts';
import { curvePrograms } from './functions/curves.ts';
import { numberPrograms } from './functions/numbers.ts';
import { surfacePrograms } from './functions/surfaces.ts';
import { windPrograms } from './functions/winds.ts';
import { checkContextLoss, checkCpuPoser, checkSettings } from './host-checks.ts';
import { checkPass, checkRest } from './pass-checks.ts';
import { type Check, report } from './report.ts';
import { runProgram } from './run-program.ts';
import { syntheticTree } from './synthetic-tree.ts';
import { showChecks, showRenderer, showReport } from './table.ts';
import { checkVariants } from './variant-checks.ts';

const PIECES = 1500;
const SEED = 1;

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
  for (const program of [...numberPrograms, ...curvePrograms, ...surfacePrograms, ...windPrograms]) {
    yield runProgram(renderer, program);
  }
  const { gale, still } = presets;
  const forest = syntheticTree(PIECES);
  const tree = await aspen();
  for (const [name, of] of [
    ['forest', forest],
    ['aspen', tree],
  ] as const) {
    yield checkRest(renderer, name, of, still);
    yield checkPass(renderer, name, of, gale);
    yield checkPass(renderer, name, of, { ...gale, pose: 'lagged' });
    yield checkDeformers(renderer, name, of, gale);
  }
  yield checkPass(renderer, 'forest', forest, { ...gale, paper: true });
  yield [checkVariants(renderer, forest)];
  yield [checkCpuPoser(renderer, 'aspen', tree, gale), checkSettings(renderer, forest, gale)];
  yield await checkContextLoss(renderer, forest, gale); // a forest: its roots do not stand at the origin, where zeros would do
}

async function run(): Promise<void> {
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
