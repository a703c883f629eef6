/** What people type, drop and remove. */
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { parseNumber } from '../../web/src/layout/controls.js';
import { verdictOn } from '../../web/src/layout/harmonic-panel.js';
import type { Harmonic } from '../../web/src/polylap.js';
import { chooseMesh, gridObj, openFile, settled, shows, useSite, useVisit } from './browser.js';

it.each([
  ['0,5', 0.5],
  ['0.5', 0.5],
  ['−2', -2],
  [' 1e-3 ', 1e-3],
  ['.25', 0.25],
  ['', Number.NaN],
  ['1.2.3', Number.NaN],
  ['0x10', Number.NaN],
  ['Infinity', Number.NaN],
])('%j is read as %d', (text, value) => expect(parseNumber(text)).toBe(value));

it('the verdict of one side stays when the other fails', () => {
  const known = { outside: new Int32Array(2), fixedMin: 0, fixedMax: 1 } as Harmonic;
  expect(verdictOn(known, 'Face 0: it has no area.')).toMatch(
    /^A: 2\u00a0vertices outside.* B: Face 0: it has no area\.$/,
  );
  expect(verdictOn('Face 0.', 'Face 0.')).toBe('A and B: Face 0.');
  expect(verdictOn('Face 0.', 'Face 1.')).toBe('A: Face 0. B: Face 1.');
  expect(verdictOn(known, known)).toMatch(/^2 \| 2 vertices outside the pinned range \[0, 1\]/);
});

const site = useSite();
const at = useVisit(site);

const notice = () => at.page.locator('.notice').textContent();
const focused = () =>
  at.page.evaluate(
    () => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.textContent ?? '',
  );
const vertexField = () => at.page.locator('[role=tabpanel]:visible').getByLabel('Vertex', { exact: true });
const opened = (name: string) =>
  at.page.waitForFunction((wanted) => {
    const { source } = globalThis.polylap.state();
    return source.kind === 'file' && source.name === wanted;
  }, name);

describe('numbers', () => {
  beforeAll(() => chooseMesh(at.page, 'grid-2'));

  it('an impossible vertex is refused with what is possible', async () => {
    const field = vertexField();
    await field.fill('3');
    for (const text of ['77', '1.5', '-1', 'abc']) {
      await field.fill(text);
      expect(await field.getAttribute('aria-invalid')).toBe('true');
      await field.blur();
      expect(await field.inputValue()).toBe('3');
      expect(await field.getAttribute('aria-invalid')).toBe(null);
      expect(await notice()).toBe(`Vertex takes whole numbers from 0 to 8, not ${text}.`);
    }
    expect(await at.page.evaluate(() => globalThis.polylap.state().selected)).toBe(3);
    await field.fill('');
    await field.blur();
    expect(await at.page.evaluate(() => globalThis.polylap.state().selected)).toBe(null);
    await field.press('ArrowUp');
    expect(await field.inputValue()).toBe('1');
  });

  it('λ takes a decimal comma as it is typed, and says why not', async () => {
    const field = at.page.getByLabel('λ of A, value');
    await field.fill('');
    await field.pressSequentially('0,5');
    expect(await at.page.evaluate(() => globalThis.polylap.state().sides.a.parameters.lambda)).toBe(0.5);
    await field.fill('-3');
    await field.blur();
    expect(Number((await field.inputValue()).replace(',', '.'))).toBe(0.5);
    expect(await notice()).toMatch(/^λ of A takes numbers from 0 to .*, not -3\.$/);
    await field.fill('1');
  });

  it('t takes a decimal comma', async () => {
    await at.page.getByRole('tab', { name: 'Smooth' }).click();
    const field = at.page.getByLabel('Time step in mean squared edge lengths, value');
    await field.fill('');
    await field.pressSequentially('0,5');
    expect(await at.page.evaluate(() => globalThis.polylap.state().smooth.timeH2)).toBe(0.5);
    await field.fill('0');
    await field.blur();
    expect(await notice()).toMatch(/takes numbers from 1e−9/);
  });
});

describe('a new mesh', () => {
  it('shows the row of a vertex at once', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Weights' }).click();
    for (const id of ['saddle', 'grid-8', 'grid-2']) {
      await chooseMesh(page, id);
      await page.waitForSelector('[data-row]');
      expect(await page.locator('.stencil').count()).toBe(2);
    }
  });

  it('does not wait for answers about the old one, which are asked for again when it fails', async () => {
    const { page } = at;
    await openFile(page, 'large.obj', gridObj(250));
    await opened('large.obj');
    // Weights, area and volume of both sides of the large mesh are under way or wait.
    await openFile(page, 'broken.obj', 'f 1 2 3');
    await page.locator('.error').waitFor({ state: 'visible' });
    await settled(page);
    expect(
      await page.evaluate(() => ['a', 'b'].map((side) => typeof globalThis.polylap.results()[side as 'a'].weights)),
    ).toEqual(['object', 'object']);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    await page.getByLabel('λ of A, value').fill('2');
    await page.getByLabel('Mesh', { exact: true }).selectOption('torus');
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 512);
    await settled(page);
    expect(await page.locator('.error').isVisible()).toBe(false);
    await shows(page, 'negative', 2048, 0);
  });
});

describe('files', () => {
  beforeEach(() => chooseMesh(at.page, 'torus'));
  const drop = (files: [string, string][], text = '') =>
    at.page.evaluate(
      ([list, plain]) => {
        const dataTransfer = new DataTransfer();
        for (const [name, content] of list) dataTransfer.items.add(new File([content], name));
        if (plain) dataTransfer.setData('text/plain', plain);
        document
          .querySelector('.stage')
          ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
      },
      [files, text] as const,
    );

  it('of several the first mesh is opened, and the others are named', async () => {
    await drop([
      ['mat.mtl', 'newmtl red'],
      ['two.obj', gridObj(2)],
    ]);
    await opened('two.obj');
    await at.page.waitForFunction(() => /left out mat\.mtl\.$/.test(globalThis.polylap.results().notice));
    expect(await at.page.locator('.error').isVisible()).toBe(false);
    await drop([
      ['one.obj', gridObj(1)],
      ['two.obj', gridObj(2)],
    ]);
    await opened('one.obj');
    await at.page.waitForFunction(() => /left out two\.obj\.$/.test(globalThis.polylap.results().notice));
  });

  it('dropped text opens as pasted text does', async () => {
    await drop([], 'nothing to see');
    await at.page.waitForFunction(() => /no mesh/.test(globalThis.polylap.results().notice));
    await drop([], gridObj(3));
    await opened('dropped.obj');
    await settled(at.page);
  });

  it('the picker offers the formats that are read', async () => {
    expect(await at.page.getByLabel('Mesh file').getAttribute('accept')).toBe(
      '.obj,model/obj,.off,model/off,.ply,model/ply,.stl,model/stl',
    );
  });
});

describe('the focus stays near', () => {
  it('when pins go', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-2');
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    const pin = page.locator('[data-action=pin-vertex]');
    for (const vertex of [1, 3, 5]) {
      await vertexField().fill(String(vertex));
      const before = await pin.boundingBox();
      await pin.click();
      expect(await pin.textContent()).toBe('Unpin');
      expect(await pin.boundingBox()).toEqual(before);
      // On the line of the field that it is about.
      expect(Math.abs((before?.y ?? 0) - ((await vertexField().boundingBox())?.y ?? 1000))).toBeLessThan(5);
    }
    const remove = (vertex: number) => page.getByRole('button', { name: `Remove the pin at vertex ${vertex}` });
    await remove(3).focus();
    await page.keyboard.press('Enter');
    expect(await focused()).toBe('Remove the pin at vertex 5');
    await page.keyboard.press('Enter');
    expect(await focused()).toBe('Remove the pin at vertex 1');
    await page.keyboard.press('Enter');
    expect(await focused()).toBe('No pins yet');
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    const value = page.getByLabel(/^Value of the pin at vertex/).first();
    await value.focus();
    await page.keyboard.type('7');
    await page.keyboard.type('5');
    expect(await value.inputValue()).toContain('75');
    await page.getByRole('button', { name: 'Clear' }).focus();
    await page.keyboard.press('Enter');
    expect(await focused()).toBe('No pins yet');
  });

  it('when a message is dismissed', async () => {
    const { page } = at;
    await openFile(page, 'broken.obj', 'f 1 2 3');
    await page.getByRole('button', { name: 'Dismiss' }).focus();
    await page.keyboard.press('Enter');
    expect(await focused()).toBe('Harmonic');
  });
});

it('makes no noise', () => {
  expect(at.troubles).toEqual([]);
});
