// The panels at the sides, or in the sheet: they come when the first tree stands, so that it moves sooner.
import '../studio/drawer.ts';
import './compare-layer.ts';
import './grow-panel.ts';
import './scene-panel.ts';
import './statistics.ts';
import './time-bar.ts';
import './tree/stem-card.ts';
import './wind-panel.ts';
