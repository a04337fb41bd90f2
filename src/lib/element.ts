/**
 * The element `<wind-tree>`: importing this module registers it. Species and winds that ship come from the package.
 *
 * @module windgrove/element
 */

// First, so that no element of the page asks for a species before it is known where from.
import './ship-modules.ts';
import '../element/define.ts';

export { fetchedFrom, type ShippedSource } from '../element/shipped-source.ts';
export { WindTreeElement } from '../element/wind-tree-element.ts';
export type { KitTree } from '../view/kit-tree.ts';
export { shipped } from './shipped.ts';
