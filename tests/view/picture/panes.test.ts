import { describe, expect, it } from 'vitest';
import { panesOf } from '../../../src/view/picture/panes.ts';

const insets = { top: 0, right: 300, bottom: 0, left: 100 };

describe('panes', () => {
  it('is one without a comparison', () => {
    expect(panesOf(1000, insets, null)).toEqual([{ which: 'A', left: 0, width: 1000, shift: 0 }]);
  });

  it('are parted by the line, and the view stays', () => {
    const [a, b] = panesOf(1000, insets, { layout: 'split', at: 0.25 });
    expect(a).toEqual({ which: 'A', left: 0, width: 250, shift: 0 });
    expect(b).toEqual({ which: 'B', left: 250, width: 750, shift: 0 });
    expect(panesOf(1000, insets, { layout: 'split', at: 7 })[1]?.width).toBe(0);
  });

  it('stand side by side with the view in the middle of what is clear of each', () => {
    const [a, b] = panesOf(1000, insets, { layout: 'side', at: 0.9 });
    // 100 to 700 is clear: its middle is at 400, those of the halves at 250 and 550.
    expect([a!.left, a!.width, b!.left, b!.width]).toEqual([0, 400, 400, 600]);
    expect([400 + a!.shift, 400 + b!.shift]).toEqual([250, 550]);
  });
});
