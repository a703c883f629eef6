/** Every figure on its page: light until it is touched, readable without scripts, alive under mouse and keys, and the same in the full page. */
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import type { Control, Figure } from '../../web/figures/figure.js';
import { ids } from '../../web/figures/list.js';
import { readLink } from '../../web/src/share.js';
import { complaints } from './acts.js';
import { dist, open, picture, settled, useSite } from './browser.js';

const site = useSite({ compressed: true });
const address = (id: string, lang = 'en') => `${site.url}figures/${lang === 'en' ? '' : `${lang}/`}${id}.html`;

/** The most that a figure may take before it is touched, in bytes. */
const most = 60_000;

const figureOf = (page: Page) => page.locator('[data-figure]');
const controlsOf = async (page: Page): Promise<Control[]> =>
  JSON.parse((await figureOf(page).getAttribute('data-controls')) ?? '');

/** Until the figure has computed what it was last told. */
const ready = (page: Page) => page.waitForFunction(() => document.querySelector('[data-state="ready"]'));

/** All that can be read: numbers, and the picture. */
const shown = (page: Page) =>
  figureOf(page).evaluate((figure) => ({
    numbers: [...figure.querySelectorAll<HTMLElement>('[data-reading]')].map((e) => [
      e.dataset.reading,
      e.dataset.value,
      e.textContent,
    ]),
    drawing: figure.querySelector('.drawing')?.innerHTML.replaceAll(/\s?aria-[\w-]+="[^"]*"/g, ''),
  }));

/** Pairs of labels of the drawing that lie on each other by more than the white around letters. */
const collisions = (page: Page) =>
  page.evaluate(() => {
    const labels = [...document.querySelectorAll('.drawing svg text')].filter((text) => text.textContent?.trim());
    const boxes = labels.map((text) => [text.textContent, text.getBoundingClientRect()] as const);
    return boxes.flatMap(([words, box], k) =>
      boxes.slice(k + 1).flatMap(([others, other]) => {
        const wide = Math.min(box.right, other.right) - Math.max(box.left, other.left);
        const high = Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top);
        const isOn = wide > 2 && high > 0.35 * Math.min(box.height, other.height);
        return isOn ? [`${words} on ${others}`] : [];
      }),
    );
  });

/** Does something, and waits until what is shown is not what it was. */
async function changes(page: Page, act: () => Promise<unknown>): Promise<void> {
  const before = JSON.stringify(await shown(page));
  await act();
  await expect.poll(async () => JSON.stringify(await shown(page)), { timeout: 20_000 }).not.toBe(before);
  await ready(page);
}

const middleOf = async (part: Locator) => {
  const box = await part.boundingBox();
  if (!box) throw new Error('it is nowhere');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2, ...{ width: box.width, left: box.x } };
};

/** Each control by mouse. */
async function useMouse(page: Page, control: Control): Promise<void> {
  const { mouse } = page;
  if (control.kind === 'choice') {
    const other = control.choices.find((choice) => choice !== control.initial);
    await page.locator(`input[name="${control.id}"][value="${other}"]`).click();
  } else if (control.kind === 'slider') {
    const input = page.locator(`input[name="${control.id}"]`);
    await input.scrollIntoViewIfNeeded();
    const { left, width, y } = await middleOf(input);
    const share = (control.initial - control.min) / (control.max - control.min);
    await mouse.click(left + width * (share > 0.5 ? 0.2 : 0.8), y);
  } else {
    const part = page
      .locator(control.kind === 'handle' ? `[data-handle="${control.id}"] .grip` : '[data-turn]')
      .first();
    await part.scrollIntoViewIfNeeded();
    const { x, y } = await middleOf(part);
    await mouse.move(x, y);
    await mouse.down();
    await mouse.move(x + 9, y - 7, { steps: 2 });
    await mouse.move(x + 22, y - 16, { steps: 2 });
    await mouse.up();
  }
}

/** Each control by keys. */
async function useKeys(page: Page, control: Control): Promise<void> {
  const { keyboard } = page;
  if (control.kind === 'choice') {
    await page.locator(`input[name="${control.id}"]:checked`).focus();
    await keyboard.press('ArrowDown');
  } else if (control.kind === 'slider') {
    await page.locator(`input[name="${control.id}"]`).focus();
    await keyboard.press(control.initial === control.max ? 'PageDown' : 'PageUp');
  } else {
    const part = page.locator(control.kind === 'handle' ? `[data-handle="${control.id}"]` : '[data-turn]').first();
    await part.focus();
    await keyboard.press('ArrowLeft');
    // It keeps the focus, whatever was drawn anew.
    await expect.poll(() => part.evaluate((element) => element === document.activeElement)).toBe(true);
  }
}

it('the list leads to every figure, with its picture', async () => {
  for (const lang of ['en', 'de']) {
    const { page, troubles, close } = await open(site, address('index', lang));
    expect(await page.locator('html').getAttribute('lang')).toBe(lang);
    const links = page.locator('.figure-list a');
    expect(await links.evaluateAll((all) => all.map((link) => link.getAttribute('href')))).toEqual(
      ids.map((id) => `${id}.html`),
    );
    for (const image of await page.locator('.figure-list img').all()) {
      await image.scrollIntoViewIfNeeded();
      await expect.poll(() => image.evaluate((one: HTMLImageElement) => one.naturalWidth)).toBeGreaterThan(100);
    }
    expect(await complaints(page)).toEqual([]);
    await picture(page, `figures-${lang}`, true);
    await page.setViewportSize({ width: 320, height: 700 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
    expect(troubles).toEqual([]);
    await close();
  }
});

describe.each(ids)('%s', (id) => {
  it('is light until it is touched: no core, no worker, no WebGL', async () => {
    const from = site.sent.length;
    const { page, troubles, close } = await open(site, address(id), {}, () => {
      const { getContext } = HTMLCanvasElement.prototype;
      const asked: string[] = [];
      Object.assign(globalThis, { asked });
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
        asked.push(kind);
        return getContext.call(this, kind as '2d', ...(rest as []));
      } as typeof getContext;
    });
    await page.waitForLoadState('networkidle');
    const sent = site.sent.slice(from);
    const sum = sent.reduce((total, { compressed }) => total + compressed, 0);
    console.log(`${id}: ${sum} bytes`);
    expect(sum).toBeGreaterThan(1000);
    expect(sum).toBeLessThanOrEqual(most);
    expect(sent.filter(({ file }) => /wasm|worker/.test(file))).toEqual([]);
    expect(page.workers()).toEqual([]);
    expect(await page.evaluate(() => (globalThis as unknown as { asked: string[] }).asked)).toEqual([]);
    expect(await figureOf(page).getAttribute('data-state')).toBe('asleep');
    expect(troubles).toEqual([]);
    await close();
  });

  it('reads without scripts, in both languages', async () => {
    for (const lang of ['en', 'de']) {
      const { page, troubles, close } = await open(site, address(id, lang), { javaScriptEnabled: false });
      expect(await page.title()).toMatch(/ · polylap$/);
      expect(await page.locator('.drawing svg').first().isVisible()).toBe(true);
      expect(await page.locator('[data-reading]').count()).toBeGreaterThan(0);
      for (const text of await page.locator('h1, .caption, .try li, .why p, .sources li, dd').allInnerTexts())
        expect(text.trim()).not.toBe('');
      // What nothing would answer to is not there.
      expect(await page.locator('.controls').isVisible()).toBe(false);
      expect(await page.getByRole('link', { name: lang === 'en' ? 'Deutsch' : 'English' }).isVisible()).toBe(true);
      const links = await page
        .locator('a, link[href]')
        .evaluateAll((all) => all.map((link) => (link as HTMLAnchorElement).href));
      // oEmbed has the address where the site will be.
      for (const link of links.filter((one) => one.startsWith(site.url))) {
        const { pathname } = new URL(link);
        expect([link, existsSync(join(dist, pathname.slice(new URL(site.url).pathname.length)))]).toEqual([link, true]);
      }
      expect(troubles).toEqual([]);
      await close();
    }
  });

  it('axe finds nothing, in light, dark and narrow, and nothing is cut off', async () => {
    for (const [lang, colorScheme, width] of [
      ['en', 'light', 1200],
      ['en', 'dark', 390],
      ['de', 'light', 320],
    ] as const) {
      const { page, close } = await open(site, address(id, lang), { colorScheme, viewport: { width, height: 800 } });
      expect([lang, colorScheme, width, ...(await complaints(page))]).toEqual([lang, colorScheme, width]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      expect(await collisions(page)).toEqual([]);
      await picture(page, `figure-${id}-${colorScheme}-${width}`, true);
      await close();
    }
  });
});

const figures = import.meta.glob<Figure>('../../web/figures/*/figure.ts', { import: 'figure', eager: true });
const drawn = ids.filter((id) => figures[`../../web/figures/${id}/figure.ts`]?.kind === 'drawn');

describe.each(drawn)('%s, touched', (id) => {
  it('is computed anew and shows what was printed', async () => {
    const { page, troubles, close } = await open(site, address(id));
    const printed = await shown(page);
    await page.locator('.drawing').hover();
    await ready(page);
    expect(page.workers().length).toBeGreaterThan(0);
    const computed = await shown(page);
    expect(computed.numbers.map(([name, , text]) => [name, text])).toEqual(
      printed.numbers.map(([name, , text]) => [name, text]),
    );
    expect(troubles).toEqual([]);
    await close();
  });

  it('answers to the mouse and to keys, and goes back', async () => {
    const { page, troubles, close } = await open(site, address(id));
    await page.locator('.controls button').focus();
    await ready(page);
    const begin = await shown(page);
    for (const control of await controlsOf(page))
      for (const use of [useMouse, useKeys]) {
        await changes(page, () => use(page, control));
        await page.locator('.controls button[type=reset]').click();
        await expect.poll(() => shown(page)).toEqual(begin);
      }
    expect(troubles).toEqual([]);
    await close();
  });

  it('opens in the full page as it stands', async () => {
    const { page, troubles, close } = await open(site, address(id));
    const [first] = (await controlsOf(page)).filter(({ view }) => !view);
    const link = page.locator('a.permalink');
    const before = await link.getAttribute('href');
    if (first) {
      await changes(page, () => useKeys(page, first));
      await expect.poll(() => link.getAttribute('href')).not.toBe(before);
    }
    const href = await link.evaluate((anchor: HTMLAnchorElement) => anchor.href);
    const wanted = await readLink(new URL(href).hash);
    await link.click();
    await settled(page);
    const state = await page.evaluate(() => globalThis.polylap.state());
    const { file: _, ...source } = { file: 0, ...wanted?.state.source };
    expect(state).toEqual({
      ...wanted?.state,
      source: expect.objectContaining(source),
      // Something to read is chosen where nothing was.
      selected: wanted?.state.selected ?? state.selected,
    });
    expect(await page.locator('.error').isVisible()).toBe(false);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('under a finger', () => {
  it('a handle moves and the page stays; beside it the page scrolls', async () => {
    const options = { viewport: { width: 390, height: 500 }, hasTouch: true, isMobile: true };
    const { page, troubles, close } = await open(site, address('two-cuts'), options);
    const session = await page.context().newCDPSession(page);
    const drag = async (x: number, from: number, to: number) => {
      const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: { x: number; y: number }[]) =>
        session.send('Input.dispatchTouchEvent', { type, touchPoints });
      await send('touchStart', [{ x, y: from }]);
      for (let step = 1; step <= 6; step++) await send('touchMove', [{ x, y: from + ((to - from) * step) / 6 }]);
      await send('touchEnd', []);
    };
    const grip = page.locator('[data-handle="corner-2"] .grip');
    await grip.scrollIntoViewIfNeeded();
    const scrolled = () => page.evaluate(() => scrollY);
    const before = await scrolled();
    const at = await middleOf(grip);
    await changes(page, () => drag(at.x, at.y, at.y + 30));
    expect(await scrolled()).toBe(before);
    const now = await middleOf(grip);
    expect(now.y - at.y).toBeGreaterThan(20);

    const title = await middleOf(page.locator('.drawing'));
    await drag(title.left + 4, 400, 250);
    await expect.poll(scrolled).toBeGreaterThan(before + 50);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('a figure that cannot be computed', () => {
  const id = 'one-interior-vertex';

  it('says so and stays as it was, and is computed when it can be', async () => {
    const { page, close } = await open(site, address(id));
    const printed = await shown(page);
    await page.route('**/*.wasm', (route) => route.abort());
    const slider = page.locator('input[type=range]').first();
    await slider.focus();
    await page.getByText('The solver could not be loaded').waitFor();
    expect(await shown(page)).toEqual(printed);
    await page.unroute('**/*.wasm');
    await changes(page, () => page.keyboard.press('PageUp'));
    expect(await page.locator('.note').innerText()).toBe('');
    await close();
  });

  it('goes to the language that is asked for', async () => {
    const { page, troubles, close } = await open(site, `${address(id)}?lang=de`);
    await page.waitForURL('**/figures/de/**');
    expect(await page.locator('html').getAttribute('lang')).toBe('de');
    expect(troubles).toEqual([]);
    await close();
  });
});
