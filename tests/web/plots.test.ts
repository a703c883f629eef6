/** Plots: their bins, ticks and blocks, and that the page draws what the numbers say. */
import { readFile } from 'node:fs/promises';
import { describe, expect, it } from 'vitest';
import { load } from '../../wasm/src/node.js';
import { faceSizes, spyBlocks, weightBins, weightsOf } from '../../web/src/plots/data.js';
import { histogram, ticks } from '../../web/src/plots/scale.js';
import type { Geometry } from '../../web/src/polylap.js';
import { chooseMesh, picture, settled, shows, useSite, useVisit } from './browser.js';

describe('scales', () => {
  it.each([
    [0, 8, 4, [0, 2, 4, 6, 8]],
    [-0.52, 2.9, 4, [0, 1, 2]],
    [0.02, 0.066, 2, [0.02, 0.04, 0.06]],
    [-1e-9, 1e-9, 2, [-1e-9, 0, 1e-9]],
    [15.2, 15.9, 2, [15.2, 15.4, 15.6, 15.8]],
    [3, 3, 2, [3]],
  ])('marks %f … %f at round numbers', (min, max, wanted, expected) => {
    expect(ticks(min, max, wanted)).toEqual(expected);
  });
  it('parts bins at 0 and loses none', () => {
    const values = [-0.5, -0.01, 0.01, 0.02, 2, 1.99];
    const bins = histogram(values, -0.5, 2, 10);
    expect(bins.reduce((sum, { count }) => sum + count, 0)).toBe(values.length);
    expect(bins.filter(({ from, to }) => from < -1e-12 && to > 1e-12)).toEqual([]);
    const below = bins.filter(({ to }) => to <= 1e-12);
    expect(below.reduce((sum, { count }) => sum + count, 0)).toBe(2);
    expect(histogram([1, 1], 1, 1, 4).reduce((sum, { count }) => sum + count, 0)).toBe(2);
  });
  it('gives both sides the same bins', () => {
    const [a, b] = weightBins([-1, 3], [0.5]);
    expect(a.map(({ from }) => from)).toEqual(b.map(({ from }) => from));
    expect(a[0]?.from).toBeLessThanOrEqual(-1);
    expect(a.at(-1)?.to).toBeGreaterThanOrEqual(3);
  });
});

describe('numbers behind them', () => {
  // S = [[2, -1, 0.5], [-1, 1, 0], [0.5, 0, -0.5]]
  const matrix = {
    rows: 3,
    cols: 3,
    colStarts: Int32Array.of(0, 3, 5, 8),
    rowIndices: Int32Array.of(0, 1, 2, 0, 1, 0, 1, 2),
    values: Float64Array.of(2, -1, 0.5, -1, 1, 0.5, 0, -0.5),
  };
  it('are the weights off the diagonal', () => {
    expect(weightsOf(matrix)).toEqual([1, -0.5, 1, -0.5]);
  });
  it('are blocks with entries, and whether a weight is negative there', () => {
    const { blocks, across } = spyBlocks(matrix);
    expect(across).toBe(3);
    expect([...blocks].sort(([p], [q]) => p - q)).toEqual([
      [0, false],
      [1, false],
      [2, true],
      [3, false],
      [4, false],
      [6, true],
      [8, false],
    ]);
    expect([...spyBlocks(matrix, 1).blocks]).toEqual([[0, true]]);
  });
  it('are faces by corners', () => {
    expect(faceSizes({ offsets: Int32Array.of(0, 4, 7, 11) } as Geometry)).toEqual([
      [3, 1],
      [4, 2],
    ]);
  });
});

describe('in the page', () => {
  const site = useSite();
  const at = useVisit(site);
  const plot = (name: string) => at.page.locator(`[data-plot=${name}]`);
  /** A column of the table, which is built when it is opened. */
  const column = async (name: string, number: number) => {
    await plot(name).getByText('Numbers').click();
    await plot(name).locator('tbody tr').first().waitFor();
    return (await plot(name).locator(`tbody td:nth-child(${number})`).allTextContents()).map(Number);
  };

  const fill = (bar: string) =>
    plot('weights-a')
      .locator(bar)
      .first()
      .evaluate((element) => getComputedStyle(element).fill);

  it('draws the weights of both sides, and gives their numbers', async () => {
    const { page } = at;
    await page.waitForFunction(() => globalThis.polylap.results().b.matrices !== null);
    expect(await plot('weights-a').getByRole('img').getAttribute('aria-label')).toBe(
      'Histogram of 4\u202f096 weights of A, 2\u202f048 of them negative',
    );
    expect(await plot('weights-b').getByRole('img').getAttribute('aria-label')).toMatch(/ 0 of them negative$/);
    expect(await plot('weights-a').locator('.bar.minus').count()).toBeGreaterThan(0);
    expect(await plot('weights-b').locator('.bar.minus').count()).toBe(0);
    const counts = await column('weights-a', 3);
    expect(counts.reduce((sum, number) => sum + number, 0)).toBe(4096);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('[data-action=csv-weights-a]').click(),
    ]);
    const lines = (await readFile(await download.path(), 'utf8')).trimEnd().split('\n');
    expect(lines[0]).toBe('from,to,weights');
    expect(lines.slice(1).reduce((sum, line) => sum + Number(line.split(',')[2]), 0)).toBe(4096);
    const [drawing] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('[data-action=svg-weights-a]').click(),
    ]);
    expect(drawing.suggestedFilename()).toBe('weights-a.svg');
    const svg = await readFile(await drawing.path(), 'utf8');
    const bars = await page.evaluate((markup) => {
      const { documentElement } = new DOMParser().parseFromString(markup, 'image/svg+xml');
      return [...documentElement.querySelectorAll('rect')].map((bar) => bar.getAttribute('fill'));
    }, svg);
    expect(bars).toHaveLength(await plot('weights-a').locator('.bar').count());
    expect(new Set(bars)).toEqual(new Set([await fill('.bar.minus'), await fill('.bar:not(.minus)')]));
    expect(svg).not.toContain('class=');
    await picture(page, 'plots');
  });

  it('draws the faces only where they differ', async () => {
    const { page } = at;
    expect(await plot('face-sizes').isVisible()).toBe(false);
    await chooseMesh(page, 'grid-8');
    expect(await plot('face-sizes').isVisible()).toBe(false);
    await page.getByLabel('Mesh', { exact: true }).selectOption('shape:voronoi');
    await plot('face-sizes').waitFor();
    await settled(page);
    const faces = await column('face-sizes', 2);
    const all = await page.evaluate(() => globalThis.polylap.results().mesh?.faces);
    expect(faces.reduce((sum, number) => sum + number, 0)).toBe(all);
  });

  it('finds the lowest eigenvalues when asked, and forgets them with the operator', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.getByRole('tab', { name: 'Check' }).click();
    await settled(page);
    expect(await plot('spectrum').isVisible()).toBe(false);
    await page.getByRole('button', { name: 'Find eigenvalues' }).click();
    await plot('spectrum').getByRole('img').waitFor();
    await settled(page);
    const session = (await load()).make({ shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 });
    const wanted = [...session.spectrum({ id: 'planar' }, 30)];
    const found = await column('spectrum', 3);
    expect(found).toHaveLength(30);
    found.forEach((value, k) => {
      expect(value).toBeCloseTo(wanted[k] as number, 5);
    });
    expect(await plot('spectrum').locator('.dot').count()).toBe(60);
    await picture(page, 'spectrum');
    await page.getByLabel('Operator of B', { exact: true }).selectOption('tutte');
    await page.waitForFunction(() => globalThis.polylap.results().b.spectrum === null);
    await settled(page);
    expect(await plot('spectrum').locator('.dot').count()).toBe(30);
    await page.getByRole('button', { name: 'Find eigenvalues' }).click();
    await page.getByText(/^B: .*not symmetric/).waitFor();
    await page.getByLabel('Operator of B', { exact: true }).selectOption('planar');
    await page.getByRole('tab', { name: 'Weights' }).click();
  });

  it('follows the surfaces over the steps', async () => {
    const { page } = at;
    await chooseMesh(page, 'noisy-torus');
    await page.getByRole('tab', { name: 'Smooth' }).click();
    expect(await plot('area').isVisible()).toBe(false);
    const areas = [await page.evaluate(() => globalThis.polylap.results().a.shape?.area)];
    for (let k = 1; k <= 3; k++) {
      await page.getByRole('button', { name: 'Step', exact: true }).click();
      await shows(page, 'step', k, k);
      areas.push(await page.evaluate(() => globalThis.polylap.results().a.shape?.area));
    }
    await settled(page);
    expect(await column('area', 2)).toEqual(areas.map((area) => Number(area?.toPrecision(6))));
    expect(await plot('volume').isVisible()).toBe(true);
    const energies = await column('energy', 2);
    expect(energies).toHaveLength(4);
    expect(energies[3]).toBeLessThan(energies[0] as number);
    const session = (await load()).make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
    expect(energies[0]).toBe(Number(session.energy({ id: 'alexa-wardetzky', lambda: 1 }).toPrecision(6)));
    await chooseMesh(page, 'noisy-saddle');
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', 1, 1);
    // What is open has no volume.
    expect(await plot('volume').isVisible()).toBe(false);
    expect(await plot('area').isVisible()).toBe(true);
  });
});
