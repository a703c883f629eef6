import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { load, operators, type Polylap } from '../../wasm/src/node.js';
import { presets } from '../../web/src/state.js';
import { negative, picture, readout, settled, shows, useSite, useVisit } from './browser.js';

const [first] = presets;
if (!first || !('shape' in first)) throw new Error('the first preset is no shape');
const torus = first.shape;

const site = useSite();
let polylap: Polylap;
beforeAll(async () => {
  polylap = await load();
});

describe('the first view', () => {
  const at = useVisit(site);

  it('reads 2048 against 0', async () => {
    expect(await negative(at.page)).toEqual([2048, 0]);
    expect(await at.page.getByLabel('Negative weights of A').textContent()).toBe('2\u202f048');
    expect(await at.page.getByLabel('Operator of A').inputValue()).toBe('alexa-wardetzky');
    expect(await at.page.getByLabel('Operator of B').inputValue()).toBe('planar');
    await picture(at.page, 'weights-light');
  });

  it('shows figures that the library confirms', async () => {
    const session = polylap.make(torus);
    const shape = session.shape();
    const info = session.info();
    const weights = session.weights({ id: 'alexa-wardetzky' });
    for (const side of ['a', 'b'] as const) {
      expect(await readout(at.page, 'vertices', side)).toBe(info.vertices);
      expect(await readout(at.page, 'faces', side)).toBe(info.faces);
      expect(await readout(at.page, 'non-planarity', side)).toBeCloseTo(shape.meanNonPlanarity, 12);
    }
    expect(await readout(at.page, 'smallest', 'a')).toBeCloseTo(weights.smallest, 12);
    expect(await readout(at.page, 'largest', 'a')).toBeCloseTo(weights.largest, 12);
  });

  it('offers the operators of the table with their formulas', async () => {
    const menu = at.page.getByLabel('Operator of A').locator('option');
    expect(await menu.evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value))).toEqual(
      operators.map(({ id }) => id),
    );
    expect(await at.page.locator('.formula math').count()).toBe(2);
  });

  it('drew a frame, and says when', async () => {
    const first = await at.page.evaluate(() => performance.getEntriesByName('polylap:first-frame')[0]?.startTime);
    console.log(`first frame ${Math.round(first ?? Number.NaN)} ms after navigation`);
    expect(first).toBeGreaterThan(0);
  });

  it('draws dashes on the surface of A only', async () => {
    // The views are all that is compared; vermilion is the only red on them.
    const red = async (side: string) => {
      const box = await at.page.locator(`[data-view=${side}]`).boundingBox();
      if (!box) throw new Error('no view');
      const image = (await at.page.screenshot({ clip: box })).toString('base64');
      return at.page.evaluate(async (data) => {
        const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const context = canvas.getContext('2d');
        context?.drawImage(bitmap, 0, 0);
        const pixels = context?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? [];
        let count = 0;
        for (let i = 0; i < pixels.length; i += 4) if ((pixels[i] ?? 0) > 150 && (pixels[i + 1] ?? 0) < 100) count++;
        return count;
      }, image);
    };
    expect(await red('a')).toBeGreaterThan(3000);
    expect(await red('b')).toBe(0);
  });

  it('makes no noise and asks nobody else', () => {
    expect(at.troubles).toEqual([]);
  });
});

describe('operators and parameters', () => {
  const at = useVisit(site);

  it('changes sides by their menus', async () => {
    const { page } = at;
    await page.getByLabel('Operator of B').selectOption('alexa-wardetzky');
    await shows(page, 'negative', 2048, 2048);
    await page.getByLabel('Operator of A').selectOption('planar');
    await shows(page, 'negative', 0, 2048);
    await page.getByLabel('Operator of A').selectOption('alexa-wardetzky');
    await page.getByLabel('Operator of B').selectOption('planar');
    await shows(page, 'negative', 2048, 0);
  });

  it('moves λ by keyboard, and ends at the newest value', async () => {
    const { page } = at;
    const slider = page.getByRole('slider', { name: 'λ of A' });
    await slider.focus();
    for (let k = 0; k < 55; k++) await page.keyboard.press('ArrowLeft');
    expect(Number(await slider.inputValue())).toBeCloseTo(0.45, 9);
    expect(await page.getByLabel('λ of A, value').inputValue()).toBe('0.45');
    const expected = polylap.make(torus).weights({ id: 'alexa-wardetzky', lambda: 0.45 });
    await shows(page, 'negative', expected.negativeOrdered, 0);
    await shows(page, 'smallest', expected.smallest, polylap.make(torus).weights({ id: 'planar' }).smallest, 1e-12);
  });

  it('takes a number beyond the slider, and refuses one beyond the table', async () => {
    const { page } = at;
    const field = page.getByLabel('λ of A, value');
    await field.fill('7');
    const expected = polylap.make(torus).weights({ id: 'alexa-wardetzky', lambda: 7 });
    await page.waitForFunction(() => globalThis.polylap.state().sides.a.parameters.lambda === 7);
    await settled(page);
    await shows(page, 'negative', expected.negativeOrdered, 0);
    await field.fill('-3');
    await field.blur();
    expect(await field.inputValue()).toBe('7');
  });

  it('sets the triangulation rule', async () => {
    const { page } = at;
    await page.getByLabel('rule of B').selectOption('fan');
    const expected = polylap.make(torus).weights({ id: 'planar', rule: 'fan' });
    expect(expected.negativeOrdered).toBeGreaterThan(0);
    await page.waitForFunction(
      (count) => document.querySelector<HTMLElement>('[data-side=b] [data-readout=negative]')?.dataset.value === count,
      String(expected.negativeOrdered),
    );
  });

  it('reads the row of a vertex on both sides', async () => {
    const { page } = at;
    await page.getByLabel('Mesh', { exact: true }).selectOption('grid-8');
    await settled(page);
    await page.getByLabel('λ of A, value').fill('1');
    await page.getByLabel('rule of B').selectOption('delaunay');
    await page.locator('[role=tabpanel]:visible').getByLabel('Vertex', { exact: true }).fill('40');
    await page.waitForSelector('[data-row="40"]');
    await settled(page);
    // On unit squares the edge weight is 2λ and the diagonal weight ½ − λ; the planar operator has the five-point star.
    const row = (neighbour: string) =>
      page
        .locator('[data-row="40"] tr', { has: page.getByRole('rowheader', { name: neighbour, exact: true }) })
        .locator('td')
        .evaluateAll((cells) => cells.map((cell) => Number((cell as HTMLElement).dataset.value)));
    const [edgeA = Number.NaN, edgeB = Number.NaN] = await row('41');
    expect(edgeA).toBeCloseTo(2, 12);
    expect(edgeB).toBeCloseTo(1, 12);
    const [diagonalA = Number.NaN, diagonalB = Number.NaN] = await row('50');
    expect(diagonalA).toBeCloseTo(-0.5, 12);
    expect(diagonalB).toBeCloseTo(0, 12);
  });

  it('makes no noise', () => {
    expect(at.troubles).toEqual([]);
  });
});

describe('the operator table alone decides', () => {
  it('no source of the page but its declared opening pair and the figures of the gallery names an operator', () => {
    const folder = new URL('../../web/src/', import.meta.url);
    const sources = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.ts'));
    expect(sources.length).toBeGreaterThan(20);
    const naming = sources.filter((name) => {
      const text = readFileSync(new URL(name, folder), 'utf8');
      return operators.some(({ id }) => text.includes(`'${id}'`));
    });
    expect(naming.sort()).toEqual(['gallery.ts', 'state.ts']);
  });
});
