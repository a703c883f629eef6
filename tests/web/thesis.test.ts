/** The article: read without scripts, on paper and on a phone; alive where there are scripts; and right in its numbers. */
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { load, operators, type Polylap, properties } from '../../wasm/src/node.js';
import { complaints } from './acts.js';
import { dist, open, picture, useSite, type Visit } from './browser.js';

const site = useSite();
const pages = { en: 'thesis/index.html', de: 'thesis/de.html' };
const langs = ['en', 'de'] as const;
const text = (lang: (typeof langs)[number]) => readFileSync(join(dist, pages[lang]), 'utf8');
const figures = 12;

describe.each(langs)('without scripts, in %s', (lang) => {
  let at: Visit;
  beforeAll(async () => {
    at = await open(site, site.url + pages[lang], { javaScriptEnabled: false });
  });
  afterAll(() => at.close());

  it('shows every drawing, formula, table and heading', async () => {
    const { page, troubles } = at;
    expect(await page.locator('html').getAttribute('lang')).toBe(lang);
    expect(await page.locator('.live-figure').count()).toBe(figures);
    for (const drawing of await page.locator('.live-figure .drawing').all()) {
      const box = await drawing.locator('svg, img').first().boundingBox();
      expect(box?.width).toBeGreaterThan(150);
      expect(box?.height).toBeGreaterThan(80);
    }
    for (const readings of await page.locator('.live-figure .readings').all())
      expect(await readings.locator('dd').count()).toBeGreaterThan(0);
    expect(await page.locator('.formula math').count()).toBeGreaterThan(20);
    for (const math of await page.locator('.formula math').all())
      expect((await math.boundingBox())?.height).toBeGreaterThan(15);
    expect(await page.locator('.measured [data-verdict]').count()).toBe(operators.length * properties.length);
    expect(await page.locator('.measured form').isVisible()).toBe(false);
    expect(await page.locator('.live-figure .controls').first().isVisible()).toBe(false);
    expect(troubles).toEqual([]);
  });

  it('reveals the answer of each exercise', async () => {
    const { page } = at;
    const exercises = await page.locator('.exercise').all();
    expect(exercises.length).toBeGreaterThanOrEqual(8);
    for (const exercise of exercises) {
      const answer = exercise.locator('.answer');
      expect(await answer.isVisible()).toBe(false);
      await exercise.locator('summary').click();
      expect(await answer.isVisible()).toBe(true);
      // Each can be looked up: in a figure, or in the table.
      expect(await exercise.locator('a[href^="#figure-"], a[href="#measured"], math').count()).toBeGreaterThan(0);
    }
  });

  it('links to what is there', async () => {
    const { page } = at;
    const ids = await page.locator('[id]').evaluateAll((all) => all.map(({ id }) => id));
    expect(ids.filter((id, k) => ids.indexOf(id) !== k)).toEqual([]);
    const links = await page
      .locator('a[href], link[href], script[src]')
      .evaluateAll((all) => all.map((each) => each.getAttribute('href') ?? each.getAttribute('src') ?? ''));
    const broken = links.filter((link) => {
      if (link.startsWith('#')) return !ids.includes(link.slice(1));
      if (link.startsWith('data:')) return false;
      if (/^[a-z]+:/.test(link)) return !link.startsWith('https://doi.org/10.');
      return !existsSync(join(dist, normalize(join(dirname(pages[lang]), link.replace(/[?#].*$/, '')))));
    });
    expect(broken).toEqual([]);
    expect(links.filter((link) => link.startsWith('https://doi.org/')).length).toBeGreaterThan(15);
  });

  it('carries no style of its own, so that any content policy may be set', () => {
    expect(text(lang)).not.toMatch(/ style="| on\w+="|<style|<script(?![^>]* src=)/);
  });
});

it('has the same sections, figures, exercises and references in both languages', () => {
  const bones = (lang: (typeof langs)[number]) =>
    [...text(lang).matchAll(/ (?:id|data-figure|data-operator|href)="(#?[\w-]+|https:[^"]*)"/g)].map(
      ([, name]) => name,
    );
  expect(bones('de')).toEqual(bones('en'));
});

describe('with scripts', () => {
  let at: Visit;
  beforeAll(async () => {
    at = await open(site, `${site.url}${pages.en}`);
  });
  afterAll(() => at.close());

  it('fetches no core before it is wanted', async () => {
    await at.page.waitForLoadState('networkidle');
    expect([...at.requests].filter((address) => /\.wasm|worker/.test(address))).toEqual([]);
  });

  it('brings the figures to life, with one client for all', async () => {
    const { page } = at;
    const figure = page.locator('#figure-one-interior-vertex');
    const reading = (id: string) => figure.locator(`[data-reading="${id}"]`).getAttribute('data-value');
    for (const lambda of [2, 0.5]) {
      await figure.getByRole('slider', { name: 'λ' }).fill(String(lambda));
      await expect.poll(() => reading('a').then(Number)).toBeCloseTo((4 * lambda) / (1 + 2 * lambda), 6);
    }
    const workers = page.workers().length;
    expect(workers).toBeGreaterThan(0);
    await page.locator('#figure-two-cuts').scrollIntoViewIfNeeded();
    await page.locator('#figure-two-cuts [data-handle]').first().focus();
    await page.keyboard.press('ArrowRight');
    await page.locator('#figure-two-cuts[data-state="ready"]').waitFor();
    expect(page.workers().length).toBe(workers);
    expect(at.troubles).toEqual([]);
  });

  it('measures the table anew, and finds what was found when it was built', async () => {
    const { page } = at;
    const table = page.locator('.measured');
    const cells = () =>
      table.locator('[data-verdict]').evaluateAll((all) => all.map((cell) => cell.textContent?.replace(/\s+/g, ' ')));
    const printed = await cells();
    expect(new Set(printed).size).toBeGreaterThan(4);
    const verdict = (operator: string, property: string) =>
      table.locator(`[data-operator="${operator}"] [data-property="${property}"]`).getAttribute('data-verdict');
    await table.getByRole('button', { name: 'Measure' }).click();
    await table.and(page.locator('[data-state="live"]')).waitFor();
    expect(await cells()).toEqual(printed);
    expect(await verdict('planar', 'positiveWeights')).toBe('fails');
    expect(await table.locator('.when').textContent()).toMatch(
      /in your browser on: Skewed grid, 81 vertices, 64 faces/,
    );
    // The flat grid of squares, as exercise 12 says.
    await table.getByLabel('Mesh').selectOption('grid');
    await expect.poll(() => table.locator('.when').textContent()).toMatch(/Grid of squares, 81 vertices/);
    expect(await verdict('planar', 'positiveWeights')).toBe('holds');
    expect(await verdict('cotan', 'positiveWeights')).toBe('holds');
    expect(await verdict('alexa-wardetzky', 'positiveWeights')).toBe('fails');
    await table.getByLabel('Mesh').selectOption('ico-sphere');
    await expect.poll(() => table.locator('.when').textContent()).toMatch(/Sphere of triangles/);
    for (const id of ['cotan', 'alexa-wardetzky']) expect(await verdict(id, 'positiveWeights')).toBe('holds');
    expect(at.troubles).toEqual([]);
  });

  it('is led to by ?lang, at the same place', async () => {
    const { page } = at;
    await page.goto(`${site.url}${pages.en}?lang=de#planar`);
    await page.waitForURL(`${site.url}${pages.de}?lang=de#planar`);
    await page.getByRole('link', { name: 'English' }).click();
    await page.waitForURL(`${site.url}${pages.en}`);
  });
});

it('opens all answers on paper', async () => {
  const { page, troubles, close } = await open(site, site.url + pages.en);
  await page.emulateMedia({ media: 'print' });
  const shown = (selector: string) =>
    page.locator(selector).evaluateAll((all) => all.map((each) => each.checkVisibility() && each.clientHeight > 0));
  expect(new Set(await shown('.exercise .answer'))).toEqual(new Set([true]));
  expect(new Set(await shown('.contents, .measured form, .live-figure .controls'))).toEqual(new Set([false]));
  expect(new Set(await shown('.live-figure .drawing'))).toEqual(new Set([true]));
  const sheets = (await page.pdf({ format: 'A4' })).toString('latin1').match(/\/Type\s*\/Page\b/g)?.length;
  expect(sheets).toBeGreaterThan(8);
  expect(troubles).toEqual([]);
  await close();
});

it.each([
  ['en', 'light', { colorScheme: 'light' as const }],
  ['de', 'dark', { colorScheme: 'dark' as const }],
  ['en', 'narrow and dark', { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: 'dark' as const }],
  ['de', 'narrow', { viewport: { width: 320, height: 700 }, hasTouch: true }],
] as const)('axe, %s, %s: finds nothing, and nothing is wider than the screen', async (lang, name, options) => {
  const { page, troubles, close } = await open(site, site.url + pages[lang], options);
  const { width, room } = await page.evaluate(() => ({
    width: document.documentElement.scrollWidth,
    room: document.documentElement.clientWidth,
  }));
  expect(width).toBeLessThanOrEqual(room);
  for (const summary of await page.locator('.exercise summary').all()) await summary.click();
  await picture(page, `thesis-${lang}-${name}`);
  // Within formulas and pictures of meshes there is nothing to find, but thousands of elements to look at.
  await page.locator('.still svg, .formula math').evaluateAll((all) => {
    for (const each of all) each.replaceChildren();
  });
  expect(await complaints(page, 'math')).toEqual([]);
  expect(troubles).toEqual([]);
  await close();
});

describe('numbers of the exercises', () => {
  let core: Polylap;
  beforeAll(async () => {
    core = await load();
  });
  /** w_ij of an operator on OBJ text. */
  const weight = (obj: string, spec: Parameters<ReturnType<Polylap['make']>['matrices']>[0], i: number, j: number) => {
    const { colStarts, rowIndices, values } = core.open(obj, 'mesh.obj').matrices(spec).stiffness;
    for (let k = colStarts[j] ?? 0; k < (colStarts[j + 1] ?? 0); k++)
      if (rowIndices[k] === i) return -(values[k] ?? Number.NaN);
    return 0;
  };
  /** Both languages say it, each with its own decimal sign. */
  const said = (number: string) => {
    const plain = (lang: (typeof langs)[number]) =>
      text(lang)
        .replaceAll(/<[^>]*>/g, '')
        .replaceAll('−', '-');
    expect(plain('en')).toContain(number);
    expect(plain('de')).toContain(number.replace('.', ','));
  };
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4';

  it('between wide angles', () => {
    // An apex that sees the edge from (−1, 0) to (1, 0) under 100°, and one that sees it under 90°.
    const high = 1 / Math.tan((50 * Math.PI) / 180);
    const obj = `v -1 0 0\nv 1 0 0\nv 0 ${high} 0\nv 0 -1 0\nf 1 2 3\nf 2 1 4`;
    expect(weight(obj, { id: 'cotan' }, 0, 1).toFixed(4)).toBe('-0.0882');
    said('-0.0882');
  });

  it('the hypotenuse and the square', () => {
    expect(weight('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4', { id: 'cotan' }, 0, 2)).toBeCloseTo(0, 12);
    for (const [lambda, diagonal] of [
      [0, 0.5],
      [0.4, 0.1],
      [0.5, 0],
      [1, -0.5],
    ] as const) {
      expect(weight(square, { id: 'alexa-wardetzky', lambda }, 0, 2)).toBeCloseTo(diagonal, 12);
      expect(weight(square, { id: 'alexa-wardetzky', lambda }, 0, 1)).toBeCloseTo(lambda, 12);
    }
  });

  it('how far too high, and below zero', () => {
    const rim = (n: number, value: (i: number, j: number) => number) => {
      const all = Array.from({ length: (n + 1) ** 2 }, (_, k) => [k % (n + 1), Math.floor(k / (n + 1)), k] as const);
      const on = all.filter(([i, j]) => i % n === 0 || j % n === 0);
      return { vertices: on.map(([, , k]) => k), values: on.map(([i, j]) => value(i, j)) };
    };
    const small = core.make({ shape: 'grid', nx: 2, ny: 2, width: 2, height: 2 });
    const middle = rim(2, (i, j) => (i === 1 || j === 1 ? 1 : 0));
    expect(small.harmonic({ id: 'alexa-wardetzky', lambda: 2 }, middle).values[4]).toBeCloseTo(1.6, 12);
    expect(small.harmonic({ id: 'planar' }, middle).values[4]).toBeCloseTo(1, 12);
    const large = core.make({ shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 });
    const corner = rim(8, (i, j) => (i + j === 0 ? 1 : 0));
    const lowest = (lambda: number) => {
      const { values } = large.harmonic({ id: 'alexa-wardetzky', lambda }, corner);
      return Math.min(...values.filter((_, k) => !corner.vertices.includes(k)));
    };
    expect(lowest(1).toFixed(4)).toBe('-0.1147');
    said('-0.1147');
    expect(lowest(0.51)).toBeLessThan(-1e-4);
    expect(lowest(0.5)).toBeCloseTo(0, 12);
  });

  it('odd and even', () => {
    const dimension = (shape: Parameters<Polylap['make']>[0]) =>
      core.make(shape).check({ id: 'alexa-wardetzky', lambda: 0 }).kernelDimension;
    expect(dimension({ shape: 'torus', nu: 16, nv: 8 })).toBe(2);
    expect(dimension({ shape: 'torus', nu: 15, nv: 9 })).toBe(1);
    expect(dimension({ shape: 'torus', nu: 16, nv: 9 })).toBe(1);
    expect(dimension({ shape: 'grid', nx: 8, ny: 8 })).toBe(2);
  });

  it('a saddle', () => {
    const h = Math.sqrt(1.5);
    const saddle = `v 0 0 ${h}\nv 1 0 0\nv 1 1 ${h}\nv 0 1 0\n`;
    const [x, y, z] = core.open(`${saddle}f 1 2 3 4`, 'mesh.obj').face({ id: 'planar' }, 0).vectorArea;
    expect([x, y]).toEqual([expect.closeTo(0, 12), expect.closeTo(0, 12)]);
    expect(z).toBeCloseTo(1, 12);
    // Cut between the corners at height 0.
    expect(core.open(`${saddle}f 1 2 4\nf 2 3 4`, 'mesh.obj').shape().area).toBeCloseTo(2, 12);
    said('1.2247');
  });

  it('the other diagonal', () => {
    const corners = 'v 0 0 0\nv 1.6 .15 0\nv 1.9 1 0\nv -.1 .9 0\n';
    expect(weight(`${corners}f 1 2 3\nf 1 3 4`, { id: 'cotan' }, 0, 2).toFixed(4)).toBe('-0.2006');
    expect(weight(`${corners}f 1 2 3 4`, { id: 'planar' }, 1, 3).toFixed(4)).toBe('0.1965');
    said('-0.2006');
    said('0.1965');
  });

  it('moving the dual', () => {
    const triangle = `v 0 0 0\nv 1 0 0\nv .5 ${Math.sqrt(3) / 2} 0\nf 1 2 3`;
    for (const omega of [0, 0.25, 0.5, 0.8])
      expect(weight(triangle, { id: 'weighted-cotan', vertexWeights: [0, 0, omega] }, 0, 1)).toBeCloseTo(
        (0.5 - omega) / Math.sqrt(3),
        12,
      );
  });

  it('area and energy', () => {
    // Stretched by 2 and 3, a triangle of area ½.
    const energy = (u: readonly number[]) => {
      const w = (i: number, j: number) => weight('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3', { id: 'cotan' }, i, j);
      return [
        [0, 1],
        [1, 2],
        [2, 0],
      ].reduce((sum, [i = 0, j = 0]) => sum + w(i, j) * ((u[i] ?? 0) - (u[j] ?? 0)) ** 2, 0);
    };
    expect(energy([0, 2, 0]) + energy([0, 0, 3])).toBeCloseTo(2 * 0.5 * 0.5 * (4 + 9), 12);
  });

  it('soap', () => {
    const c = 0.7451;
    expect(c * Math.cosh(0.6 / c)).toBeCloseTo(1, 3);
    said('0.7451');
    // The largest h for which c cosh(h / c) can be as small as 1.
    const needed = (h: number) =>
      Math.min(...Array.from({ length: 2000 }, (_, k) => ((k + 1) / 1000) * Math.cosh(h / ((k + 1) / 1000))));
    expect(needed(0.6626)).toBeLessThan(1);
    expect(needed(0.6629)).toBeGreaterThan(1);
    said('0.6627');
  });
});
