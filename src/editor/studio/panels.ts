/** All panels of the studio, with the plotting library: loaded when the drawer is opened for the first time. */
import 'uplot/dist/uPlot.min.css';
import './anemometer-panel.ts';
import './compare-panel.ts';
import './field-panel.ts';
import './plots-panel.ts';
import './textures-panel.ts';
