import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';

// The lesson that measures the reader's machine: nothing by itself, and no more than is asked for.
test('measures when asked to, stops when asked to, and keeps what it has found', async ({ page }) => {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto('learn/how-fast.html');
  const panel = page.locator('#measuring');
  const yours = page.locator('figure[data-figure="frames"] dl > div', { hasText: 'Your machine' }).locator('dd');
  await expect(panel.getByRole('status')).toContainText('Nothing is measured yet');
  await expect(yours).toContainText('–');
  await expect(panel.getByRole('button', { name: 'Download CSV' })).toBeDisabled();
  await panel.getByRole('button', { name: 'Measure this machine' }).click();
  // A line takes two measurements.
  await expect(panel.locator('tbody tr').nth(1)).toBeVisible();
  await panel.getByRole('button', { name: 'Stop' }).click();
  await expect(panel.getByRole('status')).toContainText('Stopped');
  const [first] = await panel.locator('tbody tr').first().locator('td').allTextContents();
  expect(first?.replace(/\s/g, '')).toBe('10000');
  await expect(yours).not.toContainText('–');
  const download = page.waitForEvent('download');
  await panel.getByRole('button', { name: 'Download CSV' }).click();
  const [head, line] = (await readFile(await (await download).path(), 'utf8')).split('\r\n');
  expect(head).toBe('kind,size,milliseconds,per_second,median_by_least,renderer');
  expect(line).toMatch(/^frames,10000,[\d.]+,[\d.]+,[\d.]+,"/);
  expect(complaints).toEqual([]);
});
