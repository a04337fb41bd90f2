import { noChange } from 'lit';
import { Directive, type DirectiveParameters, directive, type PropertyPart } from 'lit/directive.js';
import { setCommittedValue } from 'lit/directive-helpers.js';

/** Keys that step a number: what was typed before them is used. */
const STEPS = new Set(['ArrowUp', 'ArrowDown']);

class UnlessTyping extends Directive {
  private typing = false;
  private listens = false;

  override render(value: string): string {
    return value;
  }

  override update(part: PropertyPart, [value]: DirectiveParameters<this>): unknown {
    const box = part.element as HTMLInputElement;
    if (!this.listens) this.listen(box);
    if (this.typing || box.value === value) return noChange;
    setCommittedValue(part);
    return value;
  }

  /** Before those who use what was typed: they may draw the box again at once. */
  private listen(box: HTMLInputElement): void {
    this.listens = true;
    const done = (): void => {
      this.typing = false;
    };
    box.addEventListener('input', () => {
      this.typing = true;
    });
    box.addEventListener('change', done, { capture: true });
    box.addEventListener('blur', done, { capture: true });
    box.addEventListener('keydown', (event) => STEPS.has(event.key) && done(), { capture: true });
  }
}

/** `.value` of a text box: as lit's `live`, but what is being typed stays, however often the page is drawn meanwhile. */
export const unlessTyping = directive(UnlessTyping);
