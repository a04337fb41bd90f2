import { words } from './words.ts';

/** Gives every citation a button that copies it. */
for (const block of document.querySelectorAll('.bibtex')) {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = words.copy;
  const said = document.createElement('span');
  said.setAttribute('role', 'status');
  said.append(button);
  button.addEventListener('click', async () => {
    const text = block.querySelector('pre')?.textContent ?? '';
    const copied = await Promise.resolve(navigator.clipboard?.writeText(text))
      .then(() => Boolean(navigator.clipboard))
      .catch(() => false);
    // Without leave to copy, the text is selected: the reader's own key does the rest.
    if (!copied) getSelection()?.selectAllChildren(block.querySelector('pre') ?? block);
    button.textContent = copied ? words.copied : words.selected;
  });
  block.append(said);
}
document.documentElement.dataset.ready = 'true';
