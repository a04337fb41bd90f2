/**
 * One file for a script tag, with three.js and all that ships inside: it registers `<wind-tree>` and leaves `WindTreeElement` on the window.
 *
 * @module windgrove/script
 */
import { WindTreeElement } from './element.ts';

declare global {
  interface Window {
    WindTreeElement: typeof WindTreeElement;
  }
}

window.WindTreeElement = WindTreeElement;
