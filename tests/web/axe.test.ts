/** Every task and every dialog, in light, dark and narrow, as axe sees them. */
import { expect, it } from 'vitest';
import { complaints } from './acts.js';
import { openFile, picture, settled, tasks, useSite, visit } from './browser.js';

const site = useSite();

it.each([
  ['light', { colorScheme: 'light' as const }],
  ['dark', { colorScheme: 'dark' as const }],
  ['narrow', { viewport: { width: 390, height: 844 }, hasTouch: true }],
  ['narrow and dark', { viewport: { width: 320, height: 700 }, hasTouch: true, colorScheme: 'dark' as const }],
])('axe, %s: finds nothing in any task, nor in the dialogs, nor beside an error', async (name, options) => {
  const { page, troubles, close } = await visit(site, options);
  const isNarrow = name.startsWith('narrow');
  const look = async (what: string) => expect([what, ...(await complaints(page))]).toEqual([what]);
  for (const task of tasks) {
    await page.getByRole('tab', { name: task }).click();
    if (task === 'Harmonic') await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    await settled(page);
    if (task === 'Check') await page.getByRole('button', { name: 'All reasons' }).click();
    await picture(page, `${task.toLowerCase()}-${name}`, true);
    await look(task);
  }
  if (isNarrow) {
    await page.getByRole('button', { name: 'Difference' }).click();
    await look('Δ');
    await page.getByRole('button', { name: 'Menu' }).click();
    await look('Menu');
    await page.keyboard.press('Escape');
  } else {
    await page.getByRole('button', { name: 'Δ Difference' }).click();
    await settled(page);
    await look('Δ');
  }
  await openFile(page, 'broken.obj', 'f 1 2 3');
  await page.locator('.error').waitFor({ state: 'visible' });
  await look('an error');
  for (const action of ['gallery', 'make', 'paste', 'share', 'save', 'help']) {
    if (isNarrow) await page.getByRole('button', { name: 'Menu' }).click();
    await page.locator(`[data-action=${action}]`).click();
    await page.locator('dialog[open]').waitFor();
    await picture(page, `${action}-${name}`);
    await look(action);
    await page.keyboard.press('Escape');
  }
  expect(troubles).toEqual([]);
  await close();
});
