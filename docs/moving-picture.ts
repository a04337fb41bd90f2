// The tree of the README's moving picture, one frame at a time: `show(t)` draws it at t seconds. Everything that moves has a
// period that fits into LOOP seconds a whole number of times, so the last frame leads into the first.

import type { Species } from '../src/core/species/species.ts';
import { STILL, type Wave, type Wind } from '../src/core/wind/wind.ts';
import { speciesAsked, treeOnStage } from './tree-page.ts';

/** Seconds after which the picture repeats. */
const LOOP = 4;

/** A wave that passes `times` times in a loop. */
const wave = (
  amplitude: number,
  degrees: number,
  wavelength: number,
  times: number,
  sharpness: number,
  phase: number,
): Wave => ({
  on: true,
  solo: false,
  amplitude,
  direction: (degrees * Math.PI) / 180,
  wavelength,
  speed: (wavelength * times) / LOOP,
  sharpness,
  phase,
});

/** About a gale, so that a picture of a few seconds shows what moves. */
const wind: Wind = {
  ...STILL,
  name: 'picture',
  waves: [
    wave(0.19, 15, 48, 1, 2.2, 0),
    wave(0.085, -20, 19, 2, 1.8, 0.37),
    wave(0.045, 42, 10, 3, 1.6, 0.71),
    wave(0.027, -52, 7, 4, 1.5, 0.18),
  ],
};

/** Seconds that the branches swing before the first frame: after that they repeat with the waves. */
const RUN_IN = 10 * LOOP;

const file = await speciesAsked();
// Leaves repeat after sixteen beats (WindTree): let a loop be that, or twice that, whichever is nearer to the species.
const rate = (16 / LOOP) * Math.max(1, Math.round((file.wind.flutterRate * LOOP) / 16));
const species: Species = { ...file, wind: { ...file.wind, flutterRate: rate } };

const { stage, show } = await treeOnStage(species, wind);
// Closer than the whole of it: the crown fills the picture.
stage.controls.target.y *= 1.12;
stage.camera.position.lerp(stage.controls.target, 0.22);
// The first frame compiles.
show(RUN_IN);
Object.assign(window, { windgrovePicture: { show: (time: number) => show(RUN_IN + time), loop: LOOP } });
