import { WindTreeElement } from '../element/wind-tree-element.ts';
import { shipped } from './shipped.ts';

WindTreeElement.shipped = shipped;
