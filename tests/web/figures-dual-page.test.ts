/** The figures of duals and of the Dirichlet energy, as one drags and slides them. */
import type { Locator, Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { readLink } from '../../web/src/share.js';
import type { State } from '../../web/src/state.js';
import { settled, useSite } from './browser.js';

const site = useSite();
let page: Page;
let troubles: string[];
beforeEach(async () => {
  page = await site.browser.newPage({ viewport: { width: 1000, height: 1200 }, reducedMotion: 'reduce' });
  troubles = [];
  page.on('console', (message) => message.type() === 'error' && troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
});
afterEach(async () => {
  await page.close();
  expect(troubles).toEqual([]);
});

const open = (id: string) => page.goto(`${site.url}figures/${id}.html`);
const ready = () => page.waitForSelector('[data-figure][data-state="ready"]');
const reading = (id: string) => page.locator(`[data-reading="${id}"]`);
const value = async (id: string) => Number(await reading(id).getAttribute('data-value'));
const isBad = (id: string) => reading(id).evaluate((element) => element.classList.contains('bad'));
const count = (selector: string) => page.locator(`.drawing ${selector}`).count();

async function slide(name: string, to: number): Promise<void> {
  await page.locator(`input[name="${name}"]`).fill(String(to));
  await ready();
}

async function middleOf(handle: Locator) {
  const { x, y, width, height } = (await handle.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  return [x + width / 2, y + height / 2] as const;
}

/** To a point of the handle's plane. */
async function drag(id: string, to: readonly [number, number]): Promise<void> {
  const handle = page.locator(`[data-handle="${id}"]`);
  await handle.scrollIntoViewIfNeeded();
  const [x, y] = await middleOf(handle);
  const target = await handle.evaluate((element, [u, v]) => {
    const matrix = element.closest('svg')?.querySelector<SVGGElement>('[data-plane]')?.getScreenCTM();
    const point = new DOMPoint(u, v).matrixTransform(matrix ?? undefined);
    return [point.x, point.y] as const;
  }, to);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move((x + target[0]) / 2, (y + target[1]) / 2);
  await page.mouse.move(...target);
  await page.mouse.up();
  await ready();
}

/** The full page, with what the figure showed. @param current whether the link says so already: it is written after the drawing */
async function follow(current: (state: State, mesh: string) => boolean): Promise<void> {
  const link = page.locator('a.permalink');
  await expect
    .poll(async () => {
      const found = await readLink(new URL((await link.getAttribute('href')) ?? '', site.url).hash);
      return found ? current(found.state, (await found.file?.text()) ?? '') : false;
    })
    .toBe(true);
  await link.click();
  await page.waitForFunction(() => globalThis.polylap?.state().source.kind === 'file');
  await settled(page);
}

const smallestOfA = () =>
  page.evaluate(() => {
    const { weights } = globalThis.polylap.results().a;
    return typeof weights === 'object' ? weights?.smallest : weights;
  });

describe('circumcentric dual', () => {
  it('turns its dual edge around when both apexes come near, and back on reset', async () => {
    await open('circumcentric-dual');
    const before = await reading('cotan').innerText();
    expect(await count('.dual')).toBe(1);
    await drag('left', [-0.5, 0.2]);
    await drag('right', [0.6, -0.1]);
    const cot = async (id: string) => 1 / Math.tan((((await value(id)) / 180) * Math.PI) as number);
    expect(await value('cotan')).toBeCloseTo(((await cot('left')) + (await cot('right'))) / 2, 10);
    expect(await value('ratio')).toBeCloseTo(await value('cotan'), 12);
    expect(await value('cotan')).toBeCloseTo(-0.6175, 1);
    expect([await isBad('cotan'), await isBad('ratio')]).toEqual([true, true]);
    expect([await count('.dual'), await count('.edge-negative')]).toEqual([0, 1]);
    await page.getByRole('button', { name: 'Reset' }).click();
    await ready();
    expect(await reading('cotan').innerText()).toBe(before);
    expect([await count('.dual'), await count('.edge-negative')]).toEqual([1, 0]);
  });

  it('is moved by the arrow keys, and opens in the full page with the weight that it shows', async () => {
    await open('circumcentric-dual');
    await page.locator('[data-handle="left"]').focus();
    await ready();
    for (let k = 0; k < 20; k++) await page.keyboard.press('ArrowRight');
    await page.waitForFunction(
      () => document.querySelector('[data-handle="left"]')?.getAttribute('aria-valuetext') === '−0.50, 0.30',
    );
    await ready();
    const shown = await value('cotan');
    expect(shown).toBeLessThan(0);
    await follow((_, mesh) => Math.abs(Number(mesh.split('\n')[2]?.split(' ')[1]) + 0.5) < 1e-9);
    expect(await page.evaluate(() => globalThis.polylap.results().mesh?.vertices)).toBe(4);
    expect(await smallestOfA()).toBeCloseTo(shown, 10);
  });
});

describe('power weights', () => {
  it('are the cotan weights at 0, and negative on the ring or on the spokes far from it', async () => {
    await open('power-weights');
    await slide('omega', 0);
    expect(await value('change')).toBe(0);
    expect(await count('.edge-negative')).toBe(0);
    for (const omega of [1.2, -1.2]) {
      await slide('omega', omega);
      expect(await value('negative')).toBe(6);
      // Below 0 the circle is dashed, too.
      expect(await count('line.edge-negative')).toBe(6);
      expect(await count('circle.edge-negative')).toBe(omega < 0 ? 1 : 0);
      expect(await count('text.bad')).toBe(omega < 0 ? 6 : 0);
    }
    await drag('middle', [0.3, -0.3]);
    expect(await value('residual')).toBeLessThan(1e-12);
    expect(await value('ratio')).toBeLessThan(1e-12);
    expect(await count('.dotted')).toBe(0);
    await page.getByLabel('of its triangles, too').check();
    await ready();
    expect(await count('circle.dotted')).toBe(6);
  });

  it('open in the full page with ω at the same vertex', async () => {
    await open('power-weights');
    await slide('omega', 1.2);
    const smallest = await value('smallest');
    await follow(({ vertexWeights }) => vertexWeights.a[0] === 1.2);
    expect(await page.evaluate(() => globalThis.polylap.state().vertexWeights.a)).toEqual({ 0: 1.2 });
    expect(await smallestOfA()).toBeCloseTo(smallest, 8);
  });
});

describe('orthogonal dual', () => {
  it('says when it is not usable', async () => {
    await open('orthogonal-dual');
    expect(await page.locator('.drawing').innerText()).not.toContain('Not usable');
    expect(await isBad('shift')).toBe(false);
    await page.getByLabel('8 × 8, sheared').check();
    await slide('amount', 0.2);
    expect(await value('shift')).toBeCloseTo(3.5 * 0.2 * Math.hypot(1 + 0.2 / 1.04, 1 / 1.04), 9);
    expect(await isBad('shift')).toBe(true);
    expect(await page.locator('.drawing svg').textContent()).toContain('Not usable');
    expect(await count('.edge-negative')).toBe(await value('negative'));
    await page.getByLabel('4 × 4, sheared').check();
    await ready();
    expect(await value('shift')).toBeCloseTo(1.5 * 0.2 * Math.hypot(1 + 0.2 / 1.04, 1 / 1.04), 9);
    expect(await isBad('shift')).toBe(false);
    expect(await page.locator('.drawing svg').textContent()).not.toContain('Not usable');
    await slide('amount', 0);
    expect(await value('shift')).toBeLessThan(1e-12);
    await follow((_, mesh) => mesh.startsWith('v -2 -2 0\nv -1 -2 0'));
    expect(await page.evaluate(() => globalThis.polylap.results().mesh?.faces)).toBe(16);
    expect(await page.evaluate(() => globalThis.polylap.state().task)).toBe('dual');
  });
});

describe('Dirichlet energy', () => {
  it('is the area where the image is similar, and more elsewhere', async () => {
    await open('dirichlet-energy');
    expect(await value('excess')).toBeGreaterThan(0.01);
    // The triangle itself, moved.
    await drag('p', [0.2, 0.1]);
    await drag('q', [1.4, 0.1]);
    await drag('r', [0.6, 1.1]);
    const area = 0.6;
    expect(await value('area')).toBeCloseTo(area, 1);
    expect(await value('excess')).toBeLessThan(1e-3);
    await drag('r', [0.6, -0.3]);
    expect(await value('excess')).toBeGreaterThan(0.05);
    expect((await value('energy')) - (await value('area'))).toBeCloseTo(await value('excess'), 12);
    const before = await value('area');
    await drag('c', [0.1, 1.2]);
    expect(await value('area')).toBeCloseTo(before, 12);
  });
});
