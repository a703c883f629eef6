import { readFileSync } from 'node:fs';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import {
  chooseMesh,
  dataFile,
  gridObj,
  negative,
  openFile,
  picture,
  readout,
  settled,
  shows,
  useSite,
  useVisit,
} from './browser.js';

const hexagons = readFileSync(dataFile('meshes/hexagon-sphere-2.obj'), 'utf8');
const facesOf = (text: string) => text.split('\n').filter((line) => line.startsWith('f ')).length;

const site = useSite();
const at = useVisit(site);

const source = () => at.page.evaluate(() => globalThis.polylap.state().source);
const opened = (name: string) =>
  at.page.waitForFunction((wanted) => {
    const { source: from } = globalThis.polylap.state();
    return from.kind === 'file' && from.name === wanted;
  }, name);

/** What a person does who drags a file over the page. */
const drag = (kind: string, name: string, text: string) =>
  at.page.evaluate(
    ([type, file, content]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], file));
      document
        .querySelector('.stage')
        ?.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    },
    [kind, name, text] as const,
  );

describe('a mesh comes in', () => {
  beforeEach(() => chooseMesh(at.page, 'noisy-torus'));

  it('by the file picker', async () => {
    await openFile(at.page, 'hexagons.obj', hexagons);
    await opened('hexagons.obj');
    await settled(at.page);
    expect(await readout(at.page, 'faces', 'a')).toBe(facesOf(hexagons));
    expect(await at.page.getByLabel('Mesh', { exact: true }).locator('option:checked').textContent()).toBe(
      'hexagons.obj',
    );
  });

  it('by a drop anywhere', async () => {
    await drag('dragover', 'dropped.obj', hexagons);
    expect(await at.page.getByText('Drop the mesh to open it').isVisible()).toBe(true);
    await picture(at.page, 'drop');
    await drag('drop', 'dropped.obj', hexagons);
    await opened('dropped.obj');
    await settled(at.page);
    expect(await at.page.getByText('Drop the mesh to open it').isVisible()).toBe(false);
    expect(await readout(at.page, 'faces', 'b')).toBe(facesOf(hexagons));
  });

  it('by the paste dialog, which keeps text it cannot open', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Paste…' }).click();
    const text = page.getByLabel('OBJ text', { exact: false });
    await text.fill('v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n');
    await page.getByRole('dialog').getByRole('button', { name: 'Open' }).click();
    await page.waitForFunction(() => /line 4/i.test(document.querySelector('.dialog-error')?.textContent ?? ''));
    expect(await text.inputValue()).toContain('f 1 2 9');
    await picture(page, 'paste');
    await text.fill('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
    await page.getByRole('dialog').getByRole('button', { name: 'Open' }).click();
    await opened('pasted.obj');
    await settled(page);
    expect(await page.getByRole('dialog').count()).toBe(0);
    // One unit square, λ = 1: both diagonals ½ − λ, each counted twice.
    await shows(page, 'negative', 4, 0);
  });

  it('by Ctrl V, when the clipboard holds OBJ text', async () => {
    const paste = (text: string) =>
      at.page.evaluate((content) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', content);
        document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
      }, text);
    await paste('a shopping list');
    await at.page.waitForFunction(() => /no mesh/.test(document.querySelector('.notice')?.textContent ?? ''));
    expect((await source()).kind).toBe('preset');
    await paste(hexagons);
    await opened('pasted.obj');
    await settled(at.page);
    expect(await readout(at.page, 'faces', 'a')).toBe(facesOf(hexagons));
  });
});

describe('a mesh that cannot be opened', () => {
  beforeAll(async () => {
    await chooseMesh(at.page, 'noisy-torus');
    await at.page.getByRole('tab', { name: 'Smooth' }).click();
    await at.page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(at.page, 'step', 1, 1);
  });

  it.each([
    ['a coordinate that is none', 'v 0 0 0\nv 1 0 0\nv 1 abc 0\nf 1 2 3\n', /line 3/i],
    ['a vertex that does not exist', 'v 0 0 0\nv 1 0 0\nv 1 1 0\n\nf 1 2 7\n', /line 5/i],
    ['a face with two corners', 'v 0 0 0\nv 1 0 0\nf 1 2\n', /line 3/i],
    ['a web page', '<!doctype html><p>not found', /./],
    ['nothing', '', /./],
  ])('%s is told, and the mesh on screen stays', async (_, text, place) => {
    const { page } = at;
    await openFile(page, 'broken.obj', text);
    const alert = page.locator('.error');
    await alert.waitFor({ state: 'visible' });
    expect(await alert.textContent()).toContain('broken.obj could not be opened');
    expect(await alert.textContent()).toMatch(place);
    await picture(page, 'error');
    expect(await source()).toEqual({ kind: 'preset', id: 'noisy-torus' });
    expect(await readout(page, 'step', 'a')).toBe(1);
    expect(await readout(page, 'vertices', 'a')).toBe(512);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    expect(await alert.isVisible()).toBe(false);
  });

  it('is told by the operator when a face has no area; the other side goes on', async () => {
    const { page } = at;
    await openFile(page, 'flat.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n');
    await opened('flat.obj');
    await settled(page);
    expect(await page.locator('[data-side=a] .count').textContent()).toMatch(/face 0/i);
    await chooseMesh(page, 'noisy-torus');
    expect(await negative(page)).toEqual([2048, 0]);
  });

  it('refuses what is too large before it reads it', async () => {
    const { page } = at;
    const huge = `v 0 0 0\nv 1 0 0\nv 0 1 0\n${'f 1 2 3\n'.repeat(1_000_001)}`;
    await openFile(page, 'huge.obj', huge);
    await page.locator('.error').waitFor({ state: 'visible' });
    expect(await page.locator('.error').textContent()).toMatch(/too large.*1\u202f000\u202f001/);
    await page.getByRole('button', { name: 'Dismiss' }).click();
  });
});

describe('long work', () => {
  it('can be cancelled while a mesh is opened; the mesh on screen stays', async () => {
    const { page } = at;
    await chooseMesh(page, 'noisy-torus');
    await openFile(page, 'large.obj', gridObj(550));
    // In the page, as soon as it is there: a click from out here may come when all is done.
    await page.waitForFunction(() => {
      const button = document.querySelector<HTMLElement>('[data-action=cancel]');
      const waits = button?.checkVisibility() && /Opening/.test(button.parentElement?.textContent ?? '');
      if (waits) button?.click();
      return waits;
    });
    await page.waitForFunction(() => /cancelled/.test(document.querySelector('.notice')?.textContent ?? ''));
    expect(await source()).toEqual({ kind: 'preset', id: 'noisy-torus' });
    // The worker is there for the next question, whether or not it had to be started again.
    await page.getByLabel('Operator of B').selectOption('alexa-wardetzky');
    await shows(page, 'negative', 2048, 2048);
    await page.getByLabel('Operator of B').selectOption('planar');
    await shows(page, 'negative', 2048, 0);
  });
});
