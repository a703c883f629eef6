/** Every line of the tables, as people come by it: operators, shapes, conversions and formats. */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { conversions, load, operators, shapes } from '../../wasm/src/node.js';
import { chooseMesh, dataFile, openFile, readout, settled, shows, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());
const error = () => at.page.locator('.error');
const mesh = () =>
  at.page.evaluate(() => {
    const { mesh: shown } = globalThis.polylap.results();
    return { vertices: shown?.vertices, faces: shown?.faces };
  });

describe('operators', () => {
  it('can all be chosen on both sides, and count as the library does', async () => {
    const { page } = at;
    const session = (await load()).make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
    for (const { id, parameters } of operators) {
      for (const side of ['A', 'B']) await page.getByLabel(`Operator of ${side}`, { exact: true }).selectOption(id);
      const { negativeOrdered } = session.weights({ id } as Parameters<typeof session.weights>[0]);
      await page.waitForFunction(
        (wanted) => ['a', 'b'].every((side) => globalThis.polylap.state().sides[side as 'a'].operator === wanted),
        id,
      );
      await settled(page);
      await shows(page, 'negative', negativeOrdered, negativeOrdered);
      expect(await page.locator('[data-side=b] [data-parameter]').count()).toBe(parameters.length);
      expect(await error().isVisible()).toBe(false);
    }
  });
});

describe('shapes and conversions', () => {
  it('can all be opened from the menu', async () => {
    const { page } = at;
    const library = await load();
    for (const { id } of shapes) {
      const info = library.make({ shape: id } as Parameters<typeof library.make>[0]).info();
      await page.getByLabel('Mesh', { exact: true }).selectOption(`shape:${id}`);
      await page.waitForFunction((wanted) => {
        const { source } = globalThis.polylap.state();
        return source.kind === 'shape' && source.shape.id === wanted;
      }, id);
      await settled(page);
      expect(await mesh()).toEqual({ vertices: info.vertices, faces: info.faces });
      expect(await error().isVisible()).toBe(false);
    }
  });

  it('brings the quad bunny, smooth and noisy', async () => {
    for (const id of ['bunny', 'noisy-bunny']) {
      await chooseMesh(at.page, id);
      expect((await mesh()).vertices).toBeGreaterThan(4000);
    }
  });

  it('makes a shape with parameters of one’s own', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Make…' }).click();
    await page.getByLabel('Shape', { exact: true }).selectOption('grid');
    await page.getByLabel('cells along x, value').fill('3');
    await page.getByLabel('cells along y, value').fill('5');
    await page.getByRole('button', { name: 'Make', exact: true }).click();
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.faces === 15);
    await settled(page);
    expect(await page.getByRole('dialog').count()).toBe(0);
  });

  it('refuses what is larger than it takes, and keeps the mesh', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.getByRole('button', { name: 'Make…' }).click();
    await page.getByLabel('Shape', { exact: true }).selectOption('grid');
    await page.getByLabel('cells along x, value').fill('1001');
    await page.getByLabel('cells along y, value').fill('1000');
    await page.getByRole('button', { name: 'Make', exact: true }).click();
    await page.getByRole('alert').filter({ hasText: 'It has 1\u202f001\u202f000 faces' }).waitFor();
    expect(await page.evaluate(() => globalThis.polylap.results().mesh?.faces)).toBe(64);
    await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  });

  it.each(conversions.map(({ id }) => id))('converts the mesh on screen: %s', async (id) => {
    const { page } = at;
    await chooseMesh(page, 'torus');
    const library = await load();
    const session = library.make({ shape: 'torus', nu: 32, nv: 16 });
    const info = session.convert({ conversion: id } as Parameters<typeof session.convert>[0]).info();
    await page.getByRole('button', { name: 'Make…' }).click();
    await page.getByLabel('Change', { exact: true }).selectOption(id);
    await page.getByRole('button', { name: 'Apply' }).click();
    await page.waitForFunction(() => globalThis.polylap.state().source.changes?.length === 1);
    await settled(page);
    expect(await mesh()).toEqual({ vertices: info.vertices, faces: info.faces });
    expect(await page.getByLabel('Mesh', { exact: true }).locator('option:checked').textContent()).toMatch(/^Torus · /);
  });

  it('says in the dialog what cannot be made; the mesh stays', async () => {
    const { page } = at;
    await chooseMesh(page, 'torus');
    await openFile(page, 'one.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.faces === 1);
    await settled(page);
    await page.getByRole('button', { name: 'Make…' }).click();
    await page.getByLabel('Change', { exact: true }).selectOption('dual');
    await page.getByRole('button', { name: 'Apply' }).click();
    await page.waitForFunction(() =>
      /could not be made/.test(document.querySelector('.make-dialog .dialog-error')?.textContent ?? ''),
    );
    expect((await mesh()).faces).toBe(1);
    await page.keyboard.press('Escape');
  });
});

describe('formats', () => {
  it.each(['off', 'ply', 'stl'] as const)('drops %s', async (format) => {
    const { page } = at;
    const library = await load();
    const session = library.open(readFileSync(dataFile('meshes/triangle-sphere-2.obj')), 'sphere.obj');
    const bytes = Buffer.from(session.file(format)).toString('base64');
    await page.evaluate(
      ([name, data]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], name));
        document
          .querySelector('.stage')
          ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
      },
      [`sphere.${format}`, bytes] as const,
    );
    await page.waitForFunction((wanted) => {
      const { source } = globalThis.polylap.state();
      return source.kind === 'file' && source.name === wanted;
    }, `sphere.${format}`);
    await settled(page);
    const { vertices, faces } = session.info();
    expect(await mesh()).toEqual({ vertices, faces });
    // The corners of an STL were welded, and that is said.
    expect(await page.locator('.report').isVisible()).toBe(format === 'stl');
  });

  it('offers repair beside the error, and lists what it changed', async () => {
    const { page } = at;
    await chooseMesh(page, 'torus');
    await openFile(page, 'twice.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2\nf 1 2 3 4\nf 1 2 3 4\n');
    await error().waitFor({ state: 'visible' });
    expect((await mesh()).faces).toBe(512);
    await error().getByRole('button', { name: 'Repair and open' }).click();
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.faces === 1);
    await settled(page);
    expect(await error().isVisible()).toBe(false);
    expect(await page.locator('.report').textContent()).toMatch(/what was changed/);
    expect(await page.locator('.report li').count()).toBeGreaterThanOrEqual(2);
    expect(await readout(page, 'faces', 'a')).toBe(1);
    await page.locator('.report').getByRole('button', { name: 'Dismiss' }).click();
  });

  it('offers no repair where it would not help', async () => {
    const { page } = at;
    await openFile(page, 'text.obj', 'v 0 0 zero\nf 1 2 3\n');
    await error().waitFor({ state: 'visible' });
    await page.waitForFunction(() => globalThis.polylap.idle());
    expect(await error().getByRole('button', { name: 'Repair and open' }).isVisible()).toBe(false);
    await page.getByRole('button', { name: 'Dismiss' }).click();
  });
});

it('makes no noise', () => {
  expect(at.troubles).toEqual([]);
});
