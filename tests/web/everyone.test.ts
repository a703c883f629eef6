import { describe, expect, it } from 'vitest';
import { picture, readout, settled, tasks, useSite, visit } from './browser.js';

const site = useSite();

describe('widths', () => {
  it.each([1440, 1024, 899, 390, 320])('%i px: nothing is wider than the window', async (width) => {
    const { page, close } = await visit(site, { viewport: { width, height: 800 }, hasTouch: width < 900 });
    for (const task of tasks) {
      await page.getByRole('tab', { name: task }).click();
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    }
    await picture(page, `width-${width}`, true);
    await close();
  });

  it('390 px: one side at a time, both numbers in the switch', async () => {
    const { page, close } = await visit(site, { viewport: { width: 390, height: 844 }, hasTouch: true });
    const toA = page.getByRole('button', { name: 'Side A, 2048 negative weights' });
    const toB = page.getByRole('button', { name: 'Side B, 0 negative weights' });
    expect(await toA.textContent()).toContain('2\u202f048');
    expect(await page.locator('[data-view=b]').isVisible()).toBe(false);
    await toB.tap();
    expect(await page.locator('[data-view=a]').isVisible()).toBe(false);
    expect(await page.locator('[data-view=b]').isVisible()).toBe(true);
    expect(await toB.getAttribute('aria-pressed')).toBe('true');
    await page.getByRole('button', { name: 'Menu', exact: true }).click();
    for (const name of ['Menu', 'Undo', 'Make…', 'Open…', 'Paste…', 'Help']) {
      const box = await page.getByRole('button', { name }).boundingBox();
      expect(Math.min(box?.height ?? 0, box?.width ?? 0)).toBeGreaterThanOrEqual(name === 'Help' ? 32 : 44);
    }
    await page.getByRole('tab', { name: 'Smooth' }).tap();
    const play = await page.getByRole('button', { name: 'Play' }).boundingBox();
    expect((play?.y ?? Infinity) + (play?.height ?? 0)).toBeLessThan(
      (await page.locator('[data-view=b]').boundingBox())?.y ?? 0,
    );
    await page.getByRole('tab', { name: 'Weights' }).tap();
    // A touch picks.
    const at = await page.evaluate(() => {
      for (let vertex = 0; vertex < 512; vertex++) {
        const spot = globalThis.polylap.project('b', vertex);
        if (spot?.visible) return { ...spot, vertex };
      }
      return null;
    });
    if (!at) throw new Error('no vertex is visible');
    await page.touchscreen.tap(at.x, at.y);
    await page.waitForFunction((vertex) => globalThis.polylap.state().selected === vertex, at.vertex);
    await close();
  });
});

describe('by keyboard alone', () => {
  it('reaches everything in order, and sees where it is', async () => {
    const { page, close } = await visit(site);
    const stops: string[] = [];
    for (let k = 0; k < 40; k++) {
      await page.keyboard.press('Tab');
      const stop = await page.evaluate(() => {
        const { activeElement } = document;
        if (!activeElement || activeElement === document.body) return null;
        const { outlineStyle } = getComputedStyle(activeElement);
        const name = activeElement.getAttribute('aria-label') ?? activeElement.textContent ?? '';
        return outlineStyle === 'none' ? `no outline: ${name}` : name;
      });
      if (stop === null) break;
      stops.push(stop);
    }
    expect(stops.filter((stop) => stop.startsWith('no outline'))).toEqual([]);
    const at = (name: string) => stops.findIndex((stop) => stop.startsWith(name));
    const order = [
      'Mesh',
      'Make…',
      'Open…',
      'Paste…',
      'Colours',
      'Help',
      'Weights',
      'Operator of A',
      'Mesh A',
      'λ of A',
      'Operator of B',
      'Mesh B',
      'rule of B',
      'Vertex',
    ].map(at);
    expect(order).not.toContain(-1);
    expect(order).toEqual([...order].sort((p, q) => p - q));
    await close();
  });

  it('turns both meshes together, zooms, and comes back', async () => {
    const { page, close } = await visit(site);
    const where = () => page.evaluate(() => (['a', 'b'] as const).map((side) => globalThis.polylap.project(side, 0)));
    const [before] = await where();
    await page.locator('[data-view=b]').focus();
    for (const key of ['ArrowLeft', 'ArrowUp', '+']) await page.keyboard.press(key);
    const [a, b] = await where();
    expect(Math.hypot((a?.x ?? 0) - (before?.x ?? 0), (a?.y ?? 0) - (before?.y ?? 0))).toBeGreaterThan(10);
    const gap = await page.evaluate(() => {
      const left = (side: string) => document.querySelector(`[data-view=${side}]`)?.getBoundingClientRect().left ?? 0;
      return left('b') - left('a');
    });
    expect((b?.x ?? 0) - (a?.x ?? 0)).toBeCloseTo(gap, 3);
    await page.keyboard.press('0');
    const [home] = await where();
    expect(home?.x).toBeCloseTo(before?.x ?? Number.NaN, 3);
    await close();
  });

  it('changes tasks with arrows, plays with Space, finds help under ?', async () => {
    const { page, close } = await visit(site);
    await page.getByRole('tab', { name: 'Weights' }).focus();
    await page.keyboard.press('ArrowRight');
    expect(await page.getByRole('tab', { name: 'Smooth' }).getAttribute('aria-selected')).toBe('true');
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press('Space');
    await page.waitForFunction(() => globalThis.polylap.results().a.step >= 1);
    await page.keyboard.press('Space');
    await page.waitForFunction(() => !globalThis.polylap.results().playing);
    await page.keyboard.press('?');
    await page.getByRole('dialog').waitFor();
    await page.keyboard.press('Escape');
    expect(await page.getByRole('dialog').count()).toBe(0);
    await close();
  });
});

describe('the picture', () => {
  it('is missed without WebGL, the numbers are not', async () => {
    const context = await site.browser.newContext();
    const page = await context.newPage();
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
        apply: (target, self, [kind, ...rest]) =>
          String(kind).startsWith('webgl') ? null : Reflect.apply(target, self, [kind, ...rest]),
      });
    });
    await page.goto(site.url);
    await settled(page);
    expect(await readout(page, 'negative', 'a')).toBe(2048);
    expect(await page.locator('[data-view=a]').textContent()).toContain('no WebGL');
    await context.close();
  });

  it('turns once at first and then rests; not at all for those who ask for less motion', async () => {
    const positions = async (reducedMotion: 'reduce' | 'no-preference') => {
      const { page, close } = await visit(site, { reducedMotion });
      const seen: number[] = [];
      for (let k = 0; k < 12; k++) {
        seen.push((await page.evaluate(() => globalThis.polylap.project('a', 0)?.x)) ?? Number.NaN);
        await page.waitForTimeout(300);
      }
      await close();
      return seen;
    };
    const moving = await positions('no-preference');
    const still = await positions('reduce');
    expect(new Set(still).size).toBe(1);
    expect(new Set(moving).size).toBeGreaterThan(2);
    // It comes to rest where it would have been without.
    expect(moving.at(-1)).toBeCloseTo(still[0] ?? Number.NaN, 3);
    expect(moving.at(-2)).toBe(moving.at(-1));
  });

  it('follows the theme without a reload', async () => {
    const { page, close } = await visit(site);
    const card = () =>
      page
        .locator('.card')
        .first()
        .evaluate((element) => getComputedStyle(element).backgroundColor);
    expect(await card()).toBe('rgb(255, 253, 249)');
    await page.getByLabel('Colours', { exact: true }).selectOption('dark');
    expect(await card()).toBe('rgb(27, 30, 36)');
    await picture(page, 'weights-dark');
    await page.getByLabel('Colours', { exact: true }).selectOption('auto');
    await page.emulateMedia({ colorScheme: 'dark' });
    expect(await card()).toBe('rgb(27, 30, 36)');
    await page.emulateMedia({ forcedColors: 'active' });
    await picture(page, 'forced-colours');
    await close();
  });
});
