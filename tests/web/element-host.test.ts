/** What `<polylap-compare>` leaves to its host, and takes from it: keys, the wheel, sizes, colours, policies, the language. */
import { describe, expect, it } from 'vitest';
import { picture } from './browser.js';
import { showsNegative, soon, stateOf, useHosts } from './hosts.js';

const hosts = useHosts();
const element = (id: string, attributes = '') => `<polylap-compare id="${id}" ${attributes}></polylap-compare>`;

describe('the host', () => {
  it('keeps the keys that turn its pages under keys=release, and only those', async () => {
    const { page, close } = await hosts.open(
      element('released', 'keys="release" task="smooth"') +
        element('captured', 'task="smooth"') +
        element('none', 'keys="none"'),
      { viewport: { width: 1200, height: 1900 } },
    );
    const heard = async (id: string, keys: readonly string[]) => {
      await page.evaluate(() => {
        globalThis.keys = [];
      });
      await page.locator(`#${id} [data-view=a]`).focus();
      for (const key of keys) await page.keyboard.press(key);
      return page.evaluate(() => globalThis.keys);
    };
    const camera = async (id: string) => (await stateOf(page, id)).camera;
    const pages = ['ArrowRight', 'ArrowUp', ' ', 'PageDown'];
    expect(await heard('released', pages)).toEqual(pages);
    expect(await camera('released')).toBeNull();
    expect(await page.locator('#released').getByRole('button', { name: 'Play' }).isVisible()).toBe(true);
    expect(await heard('released', ['+'])).toEqual([]);
    expect(await camera('released')).not.toBeNull();
    expect(await heard('captured', ['ArrowRight', 'ArrowUp'])).toEqual([]);
    expect(await camera('captured')).not.toBeNull();
    expect(await heard('none', ['ArrowRight', '+', ']'])).toEqual(['ArrowRight', '+', ']']);
    expect(await camera('none')).toBeNull();
    // Who has clicked on a control goes on turning pages; who has come to it by Tab uses it.
    await page.locator('#released').getByRole('button', { name: 'Step' }).click();
    await page.evaluate(() => {
      globalThis.keys = [];
    });
    await page.keyboard.press('ArrowRight');
    expect(await page.evaluate(() => [globalThis.keys, document.activeElement?.tagName])).toEqual([
      ['ArrowRight'],
      'BODY',
    ]);
    const slider = page.locator('#released').getByLabel('λ of A', { exact: true });
    const before = await slider.inputValue();
    await slider.focus();
    await page.keyboard.press('ArrowLeft');
    expect(await slider.inputValue()).not.toBe(before);
    expect(await page.evaluate(() => globalThis.keys)).toEqual(['ArrowRight']);
    await close();
  });

  it('keeps the wheel, unless it gives it away', async () => {
    const { page, close } = await hosts.open(
      `${element('scroll', 'controls="none"')}${element('zoom', 'controls="none" wheel="zoom"')}<p class="long"></p>`,
      { style: '.long { height: 3000px }', viewport: { width: 1200, height: 900 } },
    );
    const top = () => page.evaluate(() => scrollY);
    await page.locator('#zoom [data-view=a]').hover();
    await page.mouse.wheel(0, 100);
    await soon(async () => (await stateOf(page, 'zoom')).camera).not.toBeNull();
    expect(await top()).toBe(0);
    await page.locator('#scroll [data-view=a]').hover();
    await page.mouse.wheel(0, 100);
    await soon(top).toBeGreaterThan(0);
    await close();
  });

  it('may show it smaller, as decks do, and all stays where it belongs', async () => {
    const { page, troubles, close } = await hosts.open(element('one', 'mesh="grid-8" controls="none" views="a"'), {
      style: 'main { transform: scale(0.5); transform-origin: 0 0; width: 1600px }',
    });
    const box = await page.locator('#one [data-view=a]').boundingBox();
    if (!box) throw new Error('there is no view');
    // The square stands in the middle.
    const shot = await page.locator('#one [data-view=a]').screenshot();
    const [left, right] = await page.evaluate(async (data) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context?.drawImage(bitmap, 0, 0);
      const row = context?.getImageData(0, Math.round(bitmap.height / 2), bitmap.width, 1).data ?? [];
      const differs = Array.from({ length: bitmap.width }, (_, k) =>
        [0, 1, 2].some((c) => Math.abs((row[4 * k + c] ?? 0) - (row[c] ?? 0)) > 12),
      );
      return [differs.indexOf(true) / bitmap.width, differs.lastIndexOf(true) / bitmap.width];
    }, shot.toString('base64'));
    expect(left).toBeGreaterThan(0);
    expect((left ?? 0) + (right ?? 0)).toBeCloseTo(1, 1);
    // The ring is around the vertex that the pointer is near.
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.locator('#one [data-view=a] .hover-ring').waitFor();
    const ring = await page.locator('#one [data-view=a] .hover-ring').boundingBox();
    const middle = { x: (ring?.x ?? 0) + (ring?.width ?? 0) / 2, y: (ring?.y ?? 0) + (ring?.height ?? 0) / 2 };
    expect(Math.hypot(middle.x - box.x - box.width / 2, middle.y - box.y - box.height / 2)).toBeLessThan(12);
    await picture(page, 'element-scaled');
    expect(troubles).toEqual([]);
    await close();
  });

  it('has its colours followed, and may give its own', async () => {
    const { page, troubles, close } = await hosts.open(
      element('auto', 'controls="none"') + element('dark', 'controls="none" theme="dark"'),
      {
        style:
          ':root { color-scheme: light } :root.night { color-scheme: dark } #auto { --polylap-card: rgb(1, 2, 3) } #dark::part(counter) { color: rgb(4, 5, 6) }',
        viewport: { width: 1200, height: 1100 },
      },
    );
    const colour = (id: string, selector: string, property: 'color' | 'backgroundColor') =>
      page
        .locator(`#${id} ${selector}`)
        .first()
        .evaluate((e, name) => getComputedStyle(e)[name], property);
    const [light, dark] = ['rgb(29, 32, 37)', 'rgb(232, 234, 237)'];
    expect(await colour('auto', '.polylap', 'color')).toBe(light);
    expect(await colour('dark', '.polylap', 'color')).toBe(dark);
    expect(await colour('auto', '.card', 'backgroundColor')).toBe('rgb(1, 2, 3)');
    expect(await colour('dark', '.loud', 'color')).toBe('rgb(4, 5, 6)');
    // The surface is painted anew when nothing but a class of the host has changed.
    const surface = async () => (await page.locator('#auto [data-view=b]').screenshot()).toString('base64');
    const before = await surface();
    await page.evaluate(() => document.documentElement.classList.add('night'));
    await soon(() => colour('auto', '.polylap', 'color')).toBe(dark);
    await soon(async () => (await surface()) === before).toBe(false);
    await picture(page, 'element-night');
    expect(troubles).toEqual([]);
    await close();
  });

  it('may forbid all styles and scripts but its own', async () => {
    const policy =
      "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; style-src 'self'; img-src data: blob:; connect-src 'self'";
    const { page, troubles, close } = await hosts.open(element('one', 'controls="full"'), { policy });
    await showsNegative(page, 'one', 2048, 0);
    for (const task of ['Smooth', 'Harmonic', 'Dual', 'Check'])
      await page.locator('#one').getByRole('tab', { name: task }).click();
    expect(troubles).toEqual([]);
    await close();
  });

  it('speaks German, and so does it', async () => {
    const { page, troubles, close } = await hosts.open(element('one'), { lang: 'de-AT' });
    expect(await page.locator('#one').getByRole('tab').allTextContents()).toEqual([
      'Gewichte',
      'Glätten',
      'Harmonisch',
      'Dual',
      'Prüfen',
    ]);
    expect(troubles).toEqual([]);
    await close();
  });
});
