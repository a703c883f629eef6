/** What can be saved: every file is read again, by our own readers where there are any. */
import { readFile } from 'node:fs/promises';
import type { Download, Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { load, operators } from '../../wasm/src/node.js';
import { csv, matrixMarket } from '../../web/src/numbers-text.js';
import { settled, shows, useSite, useVisit } from './browser.js';

describe('numbers as text', () => {
  const sparse = (values: number[]) => ({
    rows: 2,
    cols: 2,
    colStarts: Int32Array.of(0, 2, 4),
    rowIndices: Int32Array.of(0, 1, 0, 1),
    values: Float64Array.from(values),
  });
  it('writes the lower half of symmetric matrices', () => {
    expect(matrixMarket(sparse([1, -0.1, -0.1, 2]), 'c')).toBe(
      '%%MatrixMarket matrix coordinate real symmetric\n% c\n2 2 3\n1 1 1\n2 1 -0.1\n2 2 2\n',
    );
  });
  it('writes all of others, but no zeros off the diagonal', () => {
    expect(matrixMarket(sparse([0, -0.1, 0, 1e-300]), 'c')).toBe(
      '%%MatrixMarket matrix coordinate real general\n% c\n2 2 3\n1 1 0\n2 1 -0.1\n2 2 1e-300\n',
    );
  });
  it('quotes what needs it', () => {
    expect(
      csv(
        ['a', 'b,c'],
        [
          [1, 'say "x"'],
          [Number.NaN, undefined],
        ],
      ),
    ).toBe('a,"b,c"\n1,"say ""x"""\n,\n');
  });
});

describe('in the page', () => {
  const site = useSite();
  const at = useVisit(site);
  const bytes = async (download: Download) => readFile(await download.path());
  const saved = async (page: Page, action: string) => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator(`[data-action=save-${action}]`).click(),
    ]);
    return { name: download.suggestedFilename(), contents: await bytes(download) };
  };

  beforeAll(async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Smooth' }).click();
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', 1, 1);
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    await page.getByRole('tab', { name: 'Weights' }).click();
    await settled(page);
    await page.getByRole('button', { name: 'Save…' }).click();
    await page.getByLabel('Side', { exact: true }).selectOption('b');
  });

  it.each(['obj', 'ply', 'off'] as const)('saves the smoothed surface as %s, to the last digit', async (format) => {
    const { page } = at;
    await page.getByLabel('Format').selectOption(format);
    const { name, contents } = await saved(page, 'surface');
    expect(name).toBe(`noisy-torus-b.${format}`);
    const polylap = await load();
    const again = polylap.open(contents, name);
    const reference = polylap.make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
    const t = 0.02 * reference.info().meanSquaredEdge;
    const { coordinates } = reference.smooth({ id: 'planar' }, { time: t }, { side: 'b' });
    expect(Array.from(again.coordinates())).toEqual(Array.from(coordinates));
  });

  it('saves matrices', async () => {
    const { name, contents } = await saved(at.page, 'stiffness');
    expect(name).toBe('noisy-torus-b-S.mtx');
    const [head, comment, size, ...lines] = contents.toString().trimEnd().split('\n');
    expect(head).toBe('%%MatrixMarket matrix coordinate real symmetric');
    expect(comment).toMatch(/^% polylap: S of Planar, rule delaunay; Noisy torus$/);
    expect(size).toBe(`512 512 ${lines.length}`);
    // Rows of S sum to 0.
    const sums = new Float64Array(512);
    for (const line of lines) {
      const [i = 0, j = 0, value = 0] = line.split(' ').map(Number);
      sums[i - 1] = (sums[i - 1] ?? 0) + value;
      if (i !== j) sums[j - 1] = (sums[j - 1] ?? 0) + value;
    }
    expect(Math.max(...sums.map(Math.abs))).toBeLessThan(1e-12);
    expect((await saved(at.page, 'mass')).contents.toString()).toContain('M of Planar');
  });

  it('saves the row of the selected vertex and the values', async () => {
    const { page } = at;
    const vertex = await page.evaluate(() => globalThis.polylap.state().selected);
    const row = await saved(page, 'row');
    expect(row.name).toBe(`noisy-torus-row-${vertex}.csv`);
    const [head, ...lines] = row.contents.toString().trimEnd().split('\n');
    expect(head).toBe('column,S_A,S_B');
    expect(lines).toHaveLength(9);
    const column = (k: number) => lines.reduce((sum, line) => sum + Number(line.split(',')[k]), 0);
    expect(Math.abs(column(1)) + Math.abs(column(2))).toBeLessThan(1e-12);
    const values = (await saved(page, 'values')).contents.toString().trimEnd().split('\n');
    expect(values).toHaveLength(513);
    const shown = await page.evaluate(() => {
      const { harmonic } = globalThis.polylap.results().b;
      return harmonic && typeof harmonic !== 'string' ? harmonic.values[7] : undefined;
    });
    expect(Number(values[8]?.split(',')[8])).toBe(shown);
  });

  it('saves pictures, twice as fine, with and without ground', async () => {
    const { page } = at;
    const box = await page.locator('[data-view=b]').boundingBox();
    const corner = async (contents: Buffer) =>
      page.evaluate(async (data) => {
        const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext('2d');
        context?.drawImage(image, 0, 0);
        const inked = context
          ?.getImageData(0, 0, image.width, image.height)
          .data.filter((x, k) => k % 4 === 3 && x > 0);
        return { width: image.width, alpha: context?.getImageData(0, 0, 1, 1).data[3], inked: inked?.length ?? 0 };
      }, contents.toString('base64'));
    const clear = await corner((await saved(page, 'png')).contents);
    expect(clear).toMatchObject({ width: Math.round(2 * (box?.width ?? 0)), alpha: 0 });
    expect(clear.inked).toBeGreaterThan(10_000);
    await page.getByLabel('transparent').uncheck();
    expect(await corner((await saved(page, 'png')).contents)).toMatchObject({ alpha: 255 });
  });

  it('saves the stencil as a drawing that stands alone', async () => {
    const { name, contents } = await saved(at.page, 'svg');
    expect(name).toMatch(/^noisy-torus-vertex-\d+-b\.svg$/);
    const drawing = contents.toString();
    expect(drawing).toMatch(/^<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    expect(drawing).not.toContain('class=');
    expect(drawing).toMatch(/stroke="rgb/);
  });

  it('cites what the operators come from, each work once', async () => {
    const { page } = at;
    const entries = page.getByLabel('BibTeX', { exact: true });
    const bibtexOf = (id: string) => operators.find((entry) => entry.id === id)?.bibtex ?? '';
    const both = `${bibtexOf('alexa-wardetzky')}\n\n${bibtexOf('planar')}`;
    expect(await entries.inputValue()).toBe(both);
    const { name, contents } = await saved(page, 'bibtex');
    expect(name).toBe('polylap.bib');
    expect(contents.toString()).toBe(`${both}\n`);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.locator('[data-action=copy-bibtex]').click();
    await page.getByText('Copied.').waitFor();
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(both);
    await page.getByRole('button', { name: 'Close' }).click();
    await page.getByLabel('Operator of A', { exact: true }).selectOption('orthogonal-dual');
    await page.getByRole('button', { name: 'Save…' }).click();
    expect(await entries.inputValue()).toBe(bibtexOf('planar'));
  });

  it('saves the row and its drawing in any task, of the vertex selected there', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Close' }).click();
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await page.getByRole('tabpanel').getByLabel('Vertex', { exact: true }).fill('37');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Save…' }).click();
    const row = await saved(page, 'row');
    expect(row.name).toBe('noisy-torus-row-37.csv');
    const own = row.contents
      .toString()
      .split('\n')
      .find((line) => line.startsWith('37,'));
    const drawing = await saved(page, 'svg');
    expect(drawing.name).toBe('noisy-torus-vertex-37-b.svg');
    expect(drawing.contents.toString()).toMatch(/stroke="rgb/);
    await page.getByRole('button', { name: 'Close' }).click();
    await page.getByRole('tab', { name: 'Weights' }).click();
    await page.waitForFunction(() => {
      const { row: there } = globalThis.polylap.results().b;
      return there && typeof there !== 'string' && there.vertex === 37;
    });
    const diagonal = await page.evaluate(() => {
      const { row: there } = globalThis.polylap.results().b;
      return there && typeof there !== 'string' ? there.values[[...there.columns].indexOf(37)] : undefined;
    });
    expect(Number(own?.split(',')[2])).toBe(diagonal);
    await page.getByRole('button', { name: 'Save…' }).click();
  });

  it('says what is missing', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Close' }).click();
    await page.getByLabel('Vertex', { exact: true }).first().fill('');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Save…' }).click();
    await page.locator('[data-action=save-row]').click();
    expect(await page.getByRole('alert').filter({ hasText: 'select a vertex' }).count()).toBe(1);
  });
});
