import { words } from './words.ts';

// Shows the parameters that a word stands in, of those that the page has; without it the page shows all of them.
const finder = document.querySelector<HTMLElement>('.finder');
const field = finder?.querySelector('input');
const status = finder?.querySelector('[role=status]');
const entries = [...document.querySelectorAll<HTMLElement>('.parameter')].map((element) => ({
  element,
  text: `${element.id} ${element.textContent}`.toLowerCase(),
}));
const groups = [...document.querySelectorAll<HTMLElement>('.group')];

function show(): void {
  const asked = field!.value.trim().toLowerCase().split(/\s+/);
  let shown = 0;
  for (const { element, text } of entries) {
    element.hidden = !asked.every((word) => text.includes(word));
    if (!element.hidden) shown += 1;
  }
  for (const group of groups) group.hidden = !group.querySelector('.parameter:not([hidden])');
  status!.textContent = words.found(shown, entries.length);
}

if (finder && field && status) {
  finder.hidden = false;
  field.addEventListener('input', show);
  // What the address names is never hidden.
  addEventListener('hashchange', () => {
    field.value = '';
    show();
    document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
  });
  show();
}
document.documentElement.dataset.ready = 'true';
