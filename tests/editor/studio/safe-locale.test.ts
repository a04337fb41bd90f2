import { afterEach, expect, test, vi } from 'vitest';
import { mendLocale } from '../../../src/editor/studio/safe-locale.ts';

afterEach(() => vi.unstubAllGlobals());

test.each([
  ['en-US@posix', 'en'],
  ['', 'en'],
  ['de-CH', 'de-CH'],
])('a browser that speaks %j has number formats in %j', (language, mended) => {
  vi.stubGlobal('navigator', { language });
  mendLocale();
  expect(navigator.language).toBe(mended);
  expect(new Intl.NumberFormat(navigator.language).format(1)).toBe('1');
});
