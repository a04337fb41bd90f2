import { WindTreeElement } from './wind-tree-element.ts';

declare global {
  interface HTMLElementTagNameMap {
    'wind-tree': WindTreeElement;
  }
}

// Two copies of the library on one page: the first one stays.
if (!customElements.get('wind-tree')) customElements.define('wind-tree', WindTreeElement);
