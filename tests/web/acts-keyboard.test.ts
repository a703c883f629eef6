/** The lecture without a mouse: the focus is always seen, dialogs keep it and give it back. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { sharedLink, stateOf } from './acts.js';
import { readout, settled, shows, useSite, visit } from './browser.js';

const site = useSite();

/** What has the focus: its name and whether it can be seen that it has. */
const focused = (page: Page) =>
  page.evaluate(() => {
    const { activeElement: element } = document;
    if (!element || element === document.body) return { name: '', seen: true, inDialog: false };
    const labels =
      element instanceof HTMLInputElement || element instanceof HTMLTextAreaElement ? element.labels : null;
    const name = element.getAttribute('aria-label') ?? labels?.[0]?.textContent ?? element.textContent ?? '';
    const { outlineStyle, outlineWidth } = getComputedStyle(element);
    const seen = outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 2 && element.checkVisibility();
    return { name: name.trim(), seen, inDialog: element.closest('dialog') !== null };
  });

/** Tabs until something has the focus; on the way everything shows that it has it. */
async function tabTo(page: Page, name: string, key = 'Tab'): Promise<void> {
  for (let k = 0; k < 90; k++) {
    await page.keyboard.press(key);
    const at = await focused(page);
    expect(at).toEqual({ ...at, seen: true });
    if (at.name === name) return;
  }
  throw new Error(`Tab does not lead to ${name}`);
}

it('compares, selects, changes λ, smooths and shares, by keys alone', async () => {
  const { page, troubles, close } = await visit(site);
  await tabTo(page, 'Operator of B');
  await page.keyboard.type('Umb');
  await page.waitForFunction(() => globalThis.polylap.state().sides.b.operator === 'umbrella');
  for (const key of ['End', 'ArrowUp']) await page.keyboard.press(key);
  await page.waitForFunction(() => globalThis.polylap.state().sides.b.operator === 'planar');
  await settled(page);

  await tabTo(page, 'λ of A', 'Shift+Tab');
  for (let k = 0; k < 5; k++) await page.keyboard.press('ArrowLeft');
  const lambda = (await stateOf(page)).sides.a.parameters.lambda;
  expect(lambda).toBeLessThan(1);
  await settled(page);

  const { selected } = await stateOf(page);
  await page.keyboard.press(']');
  expect((await stateOf(page)).selected).toBe(((selected ?? 0) + 1) % 512);
  await page.waitForSelector(`[data-row="${(selected ?? 0) + 1}"]`);

  await tabTo(page, 'Δ Difference', 'Shift+Tab');
  await page.keyboard.press('Space');
  await page.locator('[data-view=delta]').waitFor();
  await tabTo(page, 'Weights', 'Shift+Tab');
  await page.keyboard.press('ArrowRight');
  expect((await stateOf(page)).task).toBe('smooth');
  await tabTo(page, 'Step');
  await page.keyboard.press('Enter');
  await shows(page, 'step', 1, 1);
  await settled(page);
  const area = await readout(page, 'area', 'a');

  await tabTo(page, 'Share…', 'Shift+Tab');
  await page.keyboard.press('Enter');
  const link = await sharedLink(page);
  await page.keyboard.press('Escape');
  expect((await focused(page)).name).toBe('Share…');
  const state = await stateOf(page);

  const seat = await visit(site, {}, link);
  await shows(seat.page, 'step', 1, 1);
  await settled(seat.page);
  expect(await stateOf(seat.page)).toEqual(state);
  expect(await readout(seat.page, 'area', 'a')).toBe(area);

  await page.keyboard.press('Control+z');
  await shows(page, 'step', 0, 0);
  expect([troubles, seat.troubles]).toEqual([[], []]);
  await seat.close();
  await close();
});

describe('a dialog', () => {
  it.each(['Gallery…', 'Make…', 'Paste…', 'Share…', 'Save…', 'Help'])(
    '%s takes the focus, keeps it and gives it back',
    async (opener) => {
      const { page, troubles, close } = await visit(site);
      await tabTo(page, opener);
      await page.keyboard.press('Enter');
      await page.locator('dialog[open]').waitFor();
      expect((await focused(page)).inDialog).toBe(true);
      // Once around, and a little: the browser's own bar may come in between, the page behind may not.
      const stops = await page
        .locator('dialog[open]')
        .locator('button, input, select, textarea, summary, a[href]')
        .count();
      for (let k = 0; k < stops + 3; k++) {
        await page.keyboard.press(k % 7 === 6 ? 'Shift+Tab' : 'Tab');
        const at = await focused(page);
        expect(at).toEqual({ ...at, inDialog: at.name !== '', seen: true });
      }
      await page.keyboard.press('Escape');
      await page.locator('dialog[open]').waitFor({ state: 'detached' });
      expect(await focused(page)).toEqual({ name: opener, seen: true, inDialog: false });
      expect(troubles).toEqual([]);
      await close();
    },
  );

  it('of a phone gives the focus back to the menu it was called from', async () => {
    const { page, close } = await visit(site, { viewport: { width: 390, height: 844 } });
    await tabTo(page, 'Menu');
    await page.keyboard.press('Enter');
    await tabTo(page, 'Save…');
    await page.keyboard.press('Enter');
    await page.locator('dialog[open]').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('dialog[open]').waitFor({ state: 'detached' });
    expect((await focused(page)).name).toBe('Menu');
    await close();
  });
});
