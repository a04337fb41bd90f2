// One tree in one of the winds that ship, for strips of frames: `show(t)` draws it at t seconds.
import { loadWind } from '../src/core/wind/load-wind.ts';
import { asked, speciesAsked, textOf, treeOnStage } from './tree-page.ts';

const { wind, faults } = await loadWind(await textOf(`winds/${asked('wind', 'breeze')}.json`), (csv) =>
  textOf(`winds/${csv}`),
);
if (!wind) throw new Error(JSON.stringify(faults));
const { show } = await treeOnStage(await speciesAsked(), wind);
show(0); // compiles
Object.assign(window, { windgroveStrip: { show } });
