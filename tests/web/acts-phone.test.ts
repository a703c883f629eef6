/** A phone: one view at a time, by touch. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { load } from '../../wasm/src/node.js';
import { stateOf } from './acts.js';
import { negative, picture, readout, settled, shows, tasks, useSite, visit } from './browser.js';

const site = useSite();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** A vertex that is seen on a side, away from the one that is selected, and inside the window. */
const spotted = (page: Page, side: 'a' | 'b') =>
  page.evaluate((of) => {
    const { selected } = globalThis.polylap.state();
    const vertices = globalThis.polylap.results().mesh?.vertices ?? 0;
    for (let vertex = 0; vertex < vertices; vertex++) {
      const at = globalThis.polylap.project(of, vertex);
      if (vertex !== selected && at?.visible && at.y > 0 && at.y < innerHeight) return { ...at, vertex };
    }
    throw new Error('no vertex is seen');
  }, side);

it('opens, changes views, takes a tap, a λ and a smoothing step', async () => {
  const { page, troubles, close } = await visit(site, phone);
  expect(await negative(page)).toEqual([2048, 0]);
  const views = page.getByRole('group', { name: 'View shown' }).getByRole('button');
  for (const [k, view] of (['a', 'b', 'delta'] as const).entries()) {
    await views.nth(k).tap();
    expect((await stateOf(page)).shown).toBe(view);
    for (const other of ['a', 'b', 'delta'])
      expect(await page.locator(`[data-view=${other}]`).isVisible()).toBe(other === view);
    await picture(page, `phone-${view}`);
  }
  await views.first().tap();

  await page.locator('[data-view=a]').scrollIntoViewIfNeeded();
  const at = await spotted(page, 'a');
  await page.touchscreen.tap(at.x, at.y);
  await page.waitForFunction((vertex) => globalThis.polylap.state().selected === vertex, at.vertex);
  await page.waitForSelector(`[data-row="${at.vertex}"]`);

  // A tap near the left end of the track.
  const slider = page.getByRole('slider', { name: 'λ of A' });
  await slider.scrollIntoViewIfNeeded();
  const track = await slider.boundingBox();
  if (!track) throw new Error('there is no slider');
  await page.touchscreen.tap(track.x + 0.1 * track.width, track.y + track.height / 2);
  await page.waitForFunction(() => Number(globalThis.polylap.state().sides.a.parameters.lambda) < 0.5);
  await settled(page);
  const lambda = Number((await stateOf(page)).sides.a.parameters.lambda);
  const torus = (await load()).make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
  const { negativeOrdered } = torus.weights({ id: 'alexa-wardetzky', lambda });
  expect(negativeOrdered).toBeLessThan(2048);
  expect(await readout(page, 'negative', 'a')).toBe(negativeOrdered);

  await page.getByRole('tab', { name: 'Smooth' }).tap();
  const area = await readout(page, 'area', 'a');
  await page.getByRole('button', { name: 'Step', exact: true }).and(page.locator(':visible')).first().tap();
  await shows(page, 'step', 1, 1);
  await settled(page);
  expect(await readout(page, 'area', 'a')).toBeLessThan(area);
  expect(troubles).toEqual([]);
  await close();
});

describe('at 320 px', () => {
  it('nothing scrolls sideways: no task, no dialog', async () => {
    const { page, troubles, close } = await visit(site, { ...phone, viewport: { width: 320, height: 640 } });
    // A phone would rather zoom out than scroll.
    const widths = () =>
      page.evaluate(() => [document.documentElement.scrollWidth, document.body.scrollWidth, visualViewport?.width]);
    for (const task of tasks) {
      await page.getByRole('tab', { name: task }).tap();
      await settled(page);
      expect([task, ...(await widths())]).toEqual([task, 320, 320, 320]);
    }
    for (const action of ['gallery', 'make', 'paste', 'share', 'save', 'help']) {
      await page.getByRole('button', { name: 'Menu' }).tap();
      await page.locator(`[data-action=${action}]`).tap();
      const dialog = page.locator('dialog[open]');
      await dialog.waitFor();
      expect([action, ...(await widths())]).toEqual([action, 320, 320, 320]);
      expect([action, await dialog.evaluate((e) => e.scrollWidth - e.clientWidth)]).toEqual([action, 0]);
      await page.keyboard.press('Escape');
    }
    expect(troubles).toEqual([]);
    await close();
  });
});

it('and on a tablet both sides are there', async () => {
  const { page, troubles, close } = await visit(site, { ...phone, viewport: { width: 1024, height: 768 } });
  for (const side of ['a', 'b']) expect(await page.locator(`[data-view=${side}]`).isVisible()).toBe(true);
  expect(troubles).toEqual([]);
  await close();
});
