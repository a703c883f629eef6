/** What tells B from A: figures, amplified surface, swipe. */
import { describe, expect, it } from 'vitest';
import { differenceOf, isDifferent } from '../../web/src/difference.js';
import { meanEdge } from '../../web/src/mean-edge.js';
import type { Geometry, Harmonic, Mesh } from '../../web/src/polylap.js';
import { freshSide } from '../../web/src/results.js';
import { clickVertex, picture, readout, settled, shows, useSite, useVisit } from './browser.js';

describe('the difference', () => {
  // A unit square and a triangle of height 2 beside it: edges 1, 1, 1, 1 and 1, √4.25, √4.25.
  const geometry = {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 3, 0.5, 0),
    offsets: Int32Array.of(0, 4, 7),
    corners: Int32Array.of(0, 1, 2, 3, 1, 4, 2),
  } as Geometry;
  const mesh = { geometry } as Mesh;
  const h = (5 + 2 * Math.sqrt(4.25)) / 7;
  const a = freshSide(geometry.positions);
  const moved = geometry.positions.slice();
  moved[4] = 0.25;
  moved[14] = -0.5;
  const b = freshSide(moved);

  it('measures in mean edge lengths', () => {
    expect(meanEdge(geometry)).toBeCloseTo(h, 12);
    const found = differenceOf({ task: 'smooth', delta: { gain: 10 } }, { a, b, mesh });
    expect(found?.of).toBe('positions');
    expect(found?.max).toBeCloseTo(0.5 / h, 7);
    expect(found?.rms).toBeCloseTo(Math.sqrt((0.25 ** 2 + 0.5 ** 2) / 5) / h, 7);
    expect(found?.vertex).toBe(4);
    expect(found?.positions[4]).toBeCloseTo(2.5, 6);
    expect(found?.positions[14]).toBeCloseTo(-5, 6);
    expect(found?.positions[12]).toBe(3);
    expect(found?.range).toMatchObject({ min: 0, max: found?.max });
  });
  it('is signed for values, and leaves out what has none', () => {
    const harmonic = (...values: number[]) => ({ ...a, harmonic: { values: Float64Array.from(values) } as Harmonic });
    const [one, other] = [harmonic(0, 1, 2, 3, Number.NaN), harmonic(0, 1.5, 1, 3, Number.NaN)];
    const found = differenceOf({ task: 'harmonic', delta: { gain: 100 } }, { a: one, b: other, mesh });
    expect([found?.of, found?.max, found?.vertex]).toEqual(['values', 1, 2]);
    expect(Array.from(found?.values.slice(0, 4) ?? [])).toEqual([0, 0.5, -1, 0]);
    expect(found?.rms).toBeCloseTo(Math.sqrt(1.25 / 4), 12);
    expect(found?.range).toEqual({ min: -0.01, max: 0.01, single: null });
    expect(found?.positions).toBe(a.positions);
    expect(differenceOf({ task: 'harmonic', delta: { gain: 1 } }, { a: one, b: a, mesh })).toBeNull();
  });
  it('is none between equal surfaces, nor by rounding', () => {
    const found = differenceOf({ task: 'weights', delta: { gain: 1 } }, { a, b: a, mesh });
    expect(found?.max).toBe(0);
    expect(isDifferent({ max: 0 })).toBe(false);
    expect(isDifferent({ max: 1e-8 })).toBe(false);
    expect(isDifferent({ max: 1e-5 })).toBe(true);
    expect(differenceOf({ task: 'weights', delta: { gain: 1 } }, { a, b, mesh: null })).toBeNull();
  });
});

describe('in the page', () => {
  const site = useSite();
  const at = useVisit(site);
  const gain = (times: number) => at.page.getByRole('button', { name: `Difference times ${times}`, exact: true });

  it('opens a third view that says how far B is from A', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Δ Difference' }).click();
    expect(await readout(page, 'delta-max')).toBe(0);
    expect(await page.locator('[data-side=delta]').textContent()).toContain('Both surfaces are the same.');
    await page.getByRole('tab', { name: 'Smooth' }).click();
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', 1, 1);
    await settled(page);
    const expected = await page.evaluate(() => {
      const { a, b, mesh } = globalThis.polylap.results();
      const { positions, offsets, corners } = mesh?.geometry ?? { positions: [], offsets: [], corners: [] };
      const distance = (p: ArrayLike<number>, v: number, q: ArrayLike<number>, w: number) =>
        Math.hypot(...[0, 1, 2].map((c) => Number(p[3 * v + c]) - Number(q[3 * w + c])));
      let length = 0;
      for (let f = 0; f + 1 < offsets.length; f++)
        for (let c = Number(offsets[f]); c < Number(offsets[f + 1]); c++) {
          const next = c + 1 < Number(offsets[f + 1]) ? c + 1 : Number(offsets[f]);
          length += distance(positions, Number(corners[c]), positions, Number(corners[next]));
        }
      const far = Array.from({ length: a.positions.length / 3 }, (_, v) => distance(a.positions, v, b.positions, v));
      return (Math.max(...far) * corners.length) / length;
    });
    expect(expected).toBeGreaterThan(1e-3);
    expect(await readout(page, 'delta-max')).toBeCloseTo(expected, 9);
    await gain(10).click();
    expect(await gain(10).getAttribute('aria-pressed')).toBe('true');
    expect(await readout(page, 'delta-max')).toBeCloseTo(expected, 9);
    await picture(page, 'delta');
  });

  it('leads to the vertex of the largest difference', async () => {
    const { page } = at;
    const vertex = await page.evaluate(() => globalThis.polylap.results().difference?.vertex ?? -1);
    await page.locator('[data-action=delta-vertex]').click();
    expect(await page.evaluate(() => globalThis.polylap.state().selected)).toBe(vertex);
  });

  it('can be wiped between A and B, by keyboard too', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Swipe' }).click();
    const track = page.getByLabel('Share of the view that shows A');
    await track.fill('0.25');
    const { x, width } = (await page.locator('[data-view=delta]').boundingBox()) ?? { x: 0, width: 0 };
    const divider = await page.locator('.divider').boundingBox();
    expect(Math.abs((divider?.x ?? 0) + (divider?.width ?? 0) / 2 - (x + 0.25 * width))).toBeLessThan(2);
    await track.press('ArrowRight');
    expect(await page.evaluate(() => globalThis.polylap.state().delta.swipe)).toBeCloseTo(0.255, 9);
    // What is clicked is the surface that is seen there.
    await clickVertex(page, 'delta', 403);
    expect(await page.evaluate(() => globalThis.polylap.state().selected)).toBe(403);
    const card = page.locator('[data-side=delta]');
    expect(await card.locator('.card-title').textContent()).toBe('A | B');
    expect(await card.locator('[data-readout=delta-max]').isVisible()).toBe(false);
    await picture(page, 'swipe');
    // By the line itself: the mesh does not turn.
    const camera = await page.evaluate(() => JSON.stringify(globalThis.polylap.state().camera));
    const line = await page.locator('.divider').boundingBox();
    if (!line) throw new Error('no line');
    expect(line.width).toBe(24);
    await page.mouse.move(line.x + line.width / 2, line.y + 100);
    await page.mouse.down();
    await page.mouse.move(x + 0.4 * width, line.y + 120, { steps: 3 });
    await page.mouse.move(x + 0.6 * width, line.y + 140, { steps: 3 });
    await page.mouse.up();
    expect(await page.evaluate(() => globalThis.polylap.state().delta.swipe)).toBeCloseTo(0.6, 2);
    expect(await page.evaluate(() => JSON.stringify(globalThis.polylap.state().camera))).toBe(camera);
    await gain(1).click();
    expect(await card.locator('.card-title').textContent()).toBe('B − A');
    expect(await card.locator('[data-readout=delta-max]').isVisible()).toBe(true);
  });

  it('compares values in Harmonic', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    await settled(page);
    const expected = await page.evaluate(() => {
      const [a, b] = (['a', 'b'] as const).map((side) => globalThis.polylap.results()[side].harmonic);
      if (!a || !b || typeof a === 'string' || typeof b === 'string') return Number.NaN;
      return Math.max(...a.values.map((value, v) => Math.abs((b.values[v] ?? 0) - value)));
    });
    expect(await readout(page, 'delta-max')).toBe(expected);
    expect(await readout(page, 'delta-high')).toBe(expected);
    await gain(100).click();
    expect(await readout(page, 'delta-high')).toBe(expected / 100);
    await picture(page, 'delta-harmonic');
  });

  it('is one of three on a phone', async () => {
    const { page } = at;
    await page.setViewportSize({ width: 390, height: 844 });
    await page.getByRole('button', { name: 'Difference of A and B' }).click();
    expect(await page.locator('[data-view=delta]').isVisible()).toBe(true);
    expect(await page.locator('[data-view=a]').isVisible()).toBe(false);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await picture(page, 'delta-phone');
  });
});
