/** What the surfaces show: values within quads, hatching, and edges at the boundary, read from the screen. */
import { describe, expect, it } from 'vitest';
import type { Side } from '../../wasm/src/types.js';
import { type Colour, chooseMesh, pixels, settled, shows, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());

/** From coordinates (u, v) within a quad, given by the vertices at (0, 0), (1, 0), (0, 1) and (1, 1), to points of the page. */
async function within(side: Side, quad: readonly [number, number, number, number]) {
  const corners = await at.page.evaluate(
    ([of, ...vertices]) => vertices.map((vertex) => globalThis.polylap.project(of, vertex)),
    [side, ...quad] as const,
  );
  return (u: number, v: number) => {
    const shares = [(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v];
    const sum = (c: 'x' | 'y') => shares.reduce((total, share, k) => total + share * (corners[k]?.[c] ?? 0), 0);
    return { x: sum('x'), y: sum('y') };
  };
}

const bright = ([r, g, b]: Colour) => 0.3 * r + 0.6 * g + 0.1 * b;

async function openFigure(id: string): Promise<void> {
  const { page } = at;
  await page.getByRole('button', { name: 'Gallery…' }).click();
  await page.locator(`[data-entry="${id}"]`).click();
  await page.getByRole('dialog', { name: 'Gallery' }).waitFor({ state: 'detached' });
  await settled(page);
}

describe('values within quads', () => {
  it('are symmetric where the corners are: a checkerboard shows no diagonals', async () => {
    await openFigure('checkerboard');
    await at.page.waitForFunction(() => globalThis.polylap.state().mode.a === 1);
    const red = ([r, , b]: Colour) => r - b;
    for (const first of [20, 21]) {
      const spot = await within('a', [first, first + 1, first + 9, first + 10]);
      const [u, v] = [0.2, 0.42];
      const mirrored = [spot(u, v), spot(v, u), spot(1 - v, 1 - u), spot(1 - u, 1 - v), spot(0.5, 0.5), spot(0.1, 0.1)];
      await expect
        .poll(async () => Math.abs(red((await pixels(at.page, mirrored))[5] ?? [0, 0, 0])), { timeout: 10_000 })
        .toBeGreaterThan(60);
      const colours = await pixels(at.page, mirrored);
      const [one = Number.NaN, ...others] = colours.slice(0, 4).map(red);
      for (const other of others) expect(Math.abs(other - one)).toBeLessThan(12);
      // The middle is 0.
      expect(Math.abs(red(colours[4] ?? [255, 0, 0]))).toBeLessThan(25);
    }
  });
});

describe('hatching', () => {
  it('is where the value drawn leaves the range of the pins', async () => {
    const { page } = at;
    await openFigure('one-interior-vertex');
    await shows(page, 'outside', 1, 0);
    const legend = page.locator('.legend-outside > span');
    expect(await legend.evaluateAll((all) => all.map((each) => each.checkVisibility()))).toEqual([false, true]);
    const striped = async (side: Side, u: number, v: number) => {
      const spot = await within(side, [0, 1, 3, 4]);
      const { x, y } = spot(u, v);
      const row = Array.from({ length: 11 }, (_, k) => ({ x: x + k - 5, y }));
      const lights = (await pixels(page, row)).map(bright);
      return Math.max(...lights) - Math.min(...lights) > 50;
    };
    // There the value is u + v − ⅔ u v: above 1, and below.
    await expect.poll(() => striped('a', 0.8, 0.8), { timeout: 10_000 }).toBe(true);
    expect(await striped('a', 0.9, 0.4)).toBe(true);
    expect(await striped('a', 0.4, 0.9)).toBe(true);
    expect(await striped('a', 0.6, 0.6)).toBe(false);
    expect(await striped('a', 0.78, 0.38)).toBe(false);
    expect(await striped('b', 0.8, 0.8)).toBe(false);
    await page.getByLabel('λ of A, value').fill('0.5');
    await shows(page, 'outside', 0, 0);
    expect(await page.locator('.legend-outside').isVisible()).toBe(false);
    await expect.poll(() => striped('a', 0.8, 0.8), { timeout: 10_000 }).toBe(false);
  });
});

describe('edges', () => {
  it('are as strong at the boundary as inside', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Weights' }).click();
    await chooseMesh(page, 'grid-8');
    await page.mouse.move(5, 5);
    /** The ink of an edge half way between its ends, across it. */
    const ink = async (quad: readonly [number, number, number, number]) => {
      const { x, y } = (await within('b', quad))(0.5, 0);
      const colours = await pixels(
        page,
        Array.from({ length: 9 }, (_, k) => ({ x, y: y + k - 4 })),
      );
      // At the boundary the paper is on one side: the darkest is what counts.
      return Math.min(...colours.map(bright));
    };
    for (const k of [0, 2, 5, 7]) {
      const inside = await ink([36 + k, 37 + k, 45 + k, 46 + k]);
      expect(Math.abs((await ink([k, k + 1, k + 9, k + 10])) - inside)).toBeLessThan(45);
      expect(Math.abs((await ink([72 + k, 73 + k, 63 + k, 64 + k])) - inside)).toBeLessThan(45);
    }
  });

  it('make no noise', () => expect(at.troubles).toEqual([]));
});
