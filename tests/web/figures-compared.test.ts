/** The figures that compare on a surface: what is told of them, and the page that starts in them. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Client } from '../../wasm/src/index.js';
import { createClient } from '../../wasm/src/node.js';
import { openBunny } from '../../web/figures/bunny.js';
import { initialSettings, type Setting } from '../../web/figures/figure.js';
import { figure as negativeWeights } from '../../web/figures/negative-weights/figure.js';
import { figure as noisySmoothing } from '../../web/figures/noisy-smoothing/figure.js';
import { readLink } from '../../web/src/share.js';
import { complaints } from './acts.js';
import { open, useSite } from './browser.js';

describe('what is told', () => {
  let client: Client;
  beforeAll(async () => {
    client = await createClient();
  });
  afterAll(() => client.close());
  const ask = async (figure: typeof negativeWeights, change: Record<string, Setting>) => {
    const readings = await figure.compute(client, { ...initialSettings(figure), ...change });
    return Object.fromEntries(readings.map(({ id, value }) => [id, value])) as Record<string, number>;
  };

  it('counts negative weights on edges and on diagonals, and none gets rid of both', async () => {
    const at = async (lambda: number) => ask(negativeWeights, { lambda });
    expect(await at(1)).toMatchObject({ a: 18_470, 'edges-a': 0, 'diagonals-a': 18_470, b: 144 });
    expect(await at(0)).toMatchObject({ a: 10_028, 'edges-a': 10_028, 'diagonals-a': 0, b: 144 });
    const counts: number[] = [];
    for (let k = 0; k <= 40; k++) counts.push((await at(k / 20)).a as number);
    expect(Math.min(...counts)).toBe(1318);
    expect(counts.indexOf(1318)).toBe(5);
    const smooth = await at(1);
    expect([smooth['thesis-a'], smooth['thesis-b']]).toEqual([20_714, 30]);
    const noisy = await ask(negativeWeights, { surface: 'noisy' });
    expect(noisy).toMatchObject({ a: 18_562, b: 132, 'thesis-a': 23_950, 'thesis-b': 680 });
  });

  it('has negative weights of the planar operator on edges only, and two diagonals in each quad', async () => {
    const mesh = await openBunny(client, 'bunny');
    const { pairs } = await mesh.weights({ id: 'planar' });
    const { offsets, corners } = mesh.geometry;
    const diagonals = new Set<string>();
    for (let f = 0; f < mesh.faces; f++) {
      const face = corners.subarray(offsets[f], offsets[f + 1]);
      for (const k of [0, 1]) diagonals.add([face[k], face[k + 2]].sort().join(' '));
    }
    expect(diagonals.size * 2).toBe(20_072);
    for (let k = 0; k < pairs.length; k += 2)
      expect(diagonals.has([pairs[k], pairs[k + 1]].sort().join(' '))).toBe(false);
    await mesh.close();
  });

  it('measures surfaces that are nearly the same, and noise that is least after about six steps', async () => {
    const after = await Promise.all(Array.from({ length: 13 }, (_, steps) => ask(noisySmoothing, { steps })));
    const row = (id: string) => after.map((readings) => readings[id] as number);
    expect(row('largest')[0]).toBe(0);
    expect(Math.max(...row('largest'))).toBeLessThan(0.1);
    expect(row('rms')[6]).toBeCloseTo(0.0244, 4);
    expect(row('noise-a')[0]).toBe(row('noise-b')[0]);
    for (const [id, from, to] of [
      ['noise-a', 5, 7],
      ['noise-b', 5, 8],
    ] as const) {
      const least = row(id).indexOf(Math.min(...row(id)));
      expect(least).toBeGreaterThanOrEqual(from);
      expect(least).toBeLessThanOrEqual(to);
    }
    for (let steps = 1; steps <= 12; steps++) {
      expect(row('noise-a')[steps]).toBeLessThan(row('noise-b')[steps] as number);
      expect(row('non-planarity-a')[steps]).toBeLessThan(row('non-planarity-b')[steps] as number);
    }
  });

  it('says where the planar operator stops, and where the surfaces part', async () => {
    const [clean, noisy] = [await openBunny(client, 'bunny'), await openBunny(client, 'noisy-bunny')];
    const time = 0.02 * noisy.meanSquaredEdge;
    await expect(noisy.smooth({ id: 'planar' }, { time, steps: 20 }, { side: 'b' })).rejects.toThrow(
      /its projection crosses or touches itself/,
    );
    await noisy.reset();
    const [a, b] = await Promise.all([
      noisy.smooth({ id: 'alexa-wardetzky' }, { time, steps: 6 }, { side: 'a' }),
      noisy.smooth({ id: 'planar' }, { time, steps: 6 }, { side: 'b' }),
    ]);
    // The part of the noise that alternates around the quads of a vertex goes with how far the surfaces are apart there.
    const { offsets, corners } = noisy.geometry;
    const moved = noisy.geometry.positions.map((c, k) => {
      const origin = (noisy.geometry.origin[k % 3] as number) - (clean.geometry.origin[k % 3] as number);
      return c + origin - (clean.geometry.positions[k] as number);
    });
    const at = (values: ArrayLike<number>, v: number) => [0, 1, 2].map((c) => values[3 * v + c] as number);
    const alternating = new Float64Array(noisy.vertices);
    for (let f = 0; f < noisy.faces; f++) {
      const face = [...corners.subarray(offsets[f], offsets[f + 1])];
      const sum = [0, 1, 2].map((c) => face.reduce((all, v, k) => all + (-1) ** k * (at(moved, v)[c] as number), 0));
      for (const v of face) alternating[v] = (alternating[v] as number) + Math.hypot(...sum);
    }
    const apart = Float64Array.from(alternating, (_, v) =>
      Math.hypot(...at(a.coordinates, v).map((c, k) => c - (at(b.coordinates, v)[k] as number))),
    );
    expect(correlation(apart, alternating)).toBeGreaterThan(0.6);
    await Promise.all([clean.close(), noisy.close()]);
  });
});

function correlation(one: Float64Array, other: Float64Array): number {
  const mean = (values: Float64Array) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [m, n] = [mean(one), mean(other)];
  let [across, first, second] = [0, 0, 0];
  for (const [k, value] of one.entries()) {
    const [x, y] = [value - m, (other[k] as number) - n];
    across += x * y;
    first += x * x;
    second += y * y;
  }
  return across / Math.sqrt(first * second);
}

describe('what starts', () => {
  const site = useSite();
  const start = (page: Page, name = 'Start in 3D') => page.getByRole('button', { name });
  const ready = (page: Page) => page.waitForSelector('[data-figure][data-state="ready"]');
  const text = (page: Page, id: string) => page.locator(`[data-reading="${id}"]`).textContent();
  const loud = (page: Page, side: string) => page.locator(`.views .card[data-side="${side}"] .loud`).textContent();
  /** How many WebGL contexts there are on the page. */
  const contexts = (page: Page) =>
    page.evaluate(() => (globalThis as unknown as { contexts: () => number }).contexts());

  async function visit(id: string, options: { lang?: string; viewport?: { width: number; height: number } } = {}) {
    const { lang, ...rest } = options;
    const { page, troubles, close } = await open(
      site,
      `${site.url}figures/${lang ? `${lang}/` : ''}${id}.html`,
      rest,
      () => {
        const { getContext } = HTMLCanvasElement.prototype;
        const made = new Set<WebGLRenderingContext>();
        Object.assign(globalThis, { contexts: () => [...made].filter((context) => !context.isContextLost()).length });
        HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...more: unknown[]) {
          const context = getContext.call(this, kind as '2d', ...(more as []));
          if (/webgl/.test(kind) && context) made.add(context as unknown as WebGLRenderingContext);
          return context;
        } as typeof getContext;
      },
    );
    return { page, troubles, close };
  }

  async function change(page: Page, act: () => Promise<unknown>, id: string): Promise<void> {
    const before = await text(page, id);
    await act();
    await expect.poll(() => text(page, id), { timeout: 30_000 }).not.toBe(before);
    await ready(page);
  }

  it('shows both operators on the bunny with the numbers beneath, and follows its controls', async () => {
    const { page, troubles, close } = await visit('negative-weights');
    // Who only tabs past it has started nothing.
    await start(page).focus();
    expect(await page.locator('[data-figure]').getAttribute('data-state')).toBe('asleep');
    await page.keyboard.press('Enter');
    await ready(page);
    expect(await start(page).count()).toBe(0);
    expect(await page.locator('.still').isVisible()).toBe(false);
    expect(await loud(page, 'a')).toBe('18\u202f470');
    expect([await loud(page, 'a'), await loud(page, 'b')]).toEqual([await text(page, 'a'), await text(page, 'b')]);
    expect(await contexts(page)).toBe(1);
    expect(await complaints(page)).toEqual([]);

    await change(page, () => page.locator('form.controls input[type=range]').fill('0.25'), 'a');
    expect(await loud(page, 'a')).toBe('1\u202f318');
    await change(page, () => page.getByLabel('noisy').check(), 'a');
    expect([await loud(page, 'a'), await text(page, 'a')]).toEqual(['1\u202f210', '1\u202f210']);
    expect(await text(page, 'thesis-a')).toBe('23\u202f950');
    const link = page.locator('a.permalink');
    const linked = async () => (await readLink(new URL((await link.getAttribute('href')) ?? '', site.url).hash))?.state;
    await expect.poll(async () => (await linked())?.source).toEqual({ kind: 'preset', id: 'noisy-bunny' });
    expect((await linked())?.sides.a.parameters).toEqual({ lambda: 0.25 });
    await change(page, () => page.getByRole('button', { name: 'Reset' }).click(), 'a');
    expect([await loud(page, 'a'), await loud(page, 'b')]).toEqual(['18\u202f470', '144']);
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows the difference as large as one likes, of the surfaces that are measured', async () => {
    const { page, troubles, close } = await visit('noisy-smoothing');
    await change(page, () => page.locator('form.controls input[type=range]').fill('3'), 'rms');
    expect(await page.locator('.views .card[data-side="a"]').isVisible()).toBe(true);
    expect(await page.locator('.views .card[data-side="delta"]').isVisible()).toBe(false);
    await page.getByLabel('× 10', { exact: true }).check();
    const card = page.locator('.views .card[data-side="delta"]');
    await card.waitFor();
    await ready(page);
    expect(await page.locator('.views .card[data-side="a"]').isVisible()).toBe(false);
    const largest = Number(await page.locator('[data-reading="largest"]').getAttribute('data-value'));
    const rms = await text(page, 'rms');
    expect(Number(await card.locator('.loud').getAttribute('data-value'))).toBeCloseTo(largest, 5);
    expect(await card.innerText()).toContain(rms);
    await change(page, () => page.locator('form.controls input[type=range]').fill('9'), 'rms');
    await expect.poll(async () => card.innerText(), { timeout: 20_000 }).toContain(await text(page, 'rms'));
    await page.getByLabel('both surfaces').check();
    await page.locator('.views .card[data-side="a"]').waitFor();
    expect(await card.isVisible()).toBe(false);
    expect(troubles).toEqual([]);
    await close();
  });

  it('holds no WebGL context out of sight, speaks German, and fits a phone', async () => {
    const { page, troubles, close } = await visit('noisy-smoothing', {
      lang: 'de',
      viewport: { width: 320, height: 600 },
    });
    await start(page, 'In 3D starten').click();
    await ready(page);
    await expect.poll(() => contexts(page), { timeout: 20_000 }).toBe(1);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
    expect(await page.locator('.views .card[data-side="a"]').innerText()).toContain('negative Gewichte');
    expect(await complaints(page)).toEqual([]);
    await page.locator('.sources').scrollIntoViewIfNeeded();
    await expect.poll(() => contexts(page), { timeout: 20_000 }).toBe(0);
    await page.locator('.views').scrollIntoViewIfNeeded();
    await expect.poll(() => contexts(page), { timeout: 20_000 }).toBe(1);
    expect(troubles).toEqual([]);
    await close();
  });
});
