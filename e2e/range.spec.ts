import { expect, type Page, test } from '@playwright/test';

// The page about Weber & Penn's degradation at range: what it draws is counted from its draws.
test.use({ viewport: { width: 400, height: 500 } });

const ready = (page: Page) =>
  page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, { timeout: 60_000 });

/** The figures under the picture: triangles, lines, points. */
const figures = async (page: Page): Promise<number[]> => {
  const texts = await page.locator('.figures dd').allTextContents();
  return texts.slice(0, 3).map((text) => Number(text.replaceAll(',', '')));
};

test('counts what it draws beside the printed table, follows the range, keeps it in the address, and says what is wrong there', async ({
  page,
}) => {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  await page.goto('range.html?wind=0&range=120&quality=7&seasn=winter');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('quality: found “7”; allowed: a number from 0.1 to 1.');
  await expect(alert).toContainText('seasn: found “winter”; allowed: season, if that was meant.');
  await alert.getByRole('button').click();
  await expect(alert).toHaveCount(0);
  await ready(page);
  const row = (n: number) => page.locator('#table-2 tbody tr').nth(n).locator('.ours, .none').allTextContents();
  expect(await row(1)).toEqual(['0', '0', '0', '36', '36', '36', '36']);
  expect(await row(7)).toEqual(['13,557', '13,557', '13,557', '13,557', '12,201', '1,695', '1,695']);
  const [triangles, lines, points] = (await figures(page)) as [number, number, number];
  expect(lines).toBe(36 + 224 + 2607);
  await page.getByRole('button', { name: '240 m' }).click();
  await ready(page);
  const far = await figures(page);
  expect(far[0]).toBeLessThan(triangles / 10);
  expect(far[1]).toBe(36 + 153);
  expect(far[2]).toBeLessThan(points);
  expect(page.url()).toContain('range=240');
  expect(complaints).toEqual([]);
});
