import { WebGLRenderer } from 'three';
import { presets } from '../../core/wind/presets.ts';
import { capabilitiesOf, probePage } from '../capabilities.ts';
import { rendererName } from '../renderer-name.ts';
import { curvePrograms } from './functions/curves.ts';
import { numberPrograms } from './functions/numbers.ts';
import { surfacePrograms } from './functions/surfaces.ts';
import { windPrograms } from './functions/winds.ts';
import { checkPass, checkRest } from './pass-checks.ts';
import { type Check, report } from './report.ts';
import { runProgram } from './run-program.ts';
import { syntheticTree } from './synthetic-tree.ts';
import { showChecks, showRenderer, showReport } from './table.ts';

/** Lets the page draw what it has: a run takes seconds on a software renderer. */
const breathe = () => new Promise((resolve) => setTimeout(resolve));

async function run(): Promise<void> {
  const page = probePage();
  if (!page.webgl2) return showReport(report('none', [], 0, page.reason));
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setSize(1, 1);
  const name = rendererName(renderer);
  showRenderer(name);
  const capabilities = capabilitiesOf(renderer);
  if (!capabilities.floatTargets) return showReport(report(name, [], 0, capabilities.reason));

  const start = performance.now();
  const checks: Check[] = [];
  const add = async (more: readonly Check[]) => {
    checks.push(...more);
    showChecks(more);
    await breathe();
  };
  for (const program of [...numberPrograms, ...curvePrograms, ...surfacePrograms, ...windPrograms])
    await add(runProgram(renderer, program));
  const { gale, still } = presets;
  const forest = syntheticTree(1500);
  await add(checkRest(renderer, 'forest', forest, still));
  await add(checkPass(renderer, 'forest', forest, gale));
  await add(checkPass(renderer, 'forest', forest, { ...gale, pose: 'lagged' }));
  await add(checkPass(renderer, 'forest', forest, { ...gale, paper: true }));
  showReport(report(name, checks, Math.round(performance.now() - start)));
}

run().catch((error: unknown) => {
  showReport(report('unknown', [], 0, `The cross-check could not run: ${String(error)}`));
  throw error;
});
