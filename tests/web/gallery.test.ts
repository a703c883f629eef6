/** Meshes and figures to choose from. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { load, type Polylap } from '../../wasm/src/node.js';
import { type Facts, groups, stateOf } from '../../web/src/gallery.js';
import { initialState } from '../../web/src/state.js';
import { chooseMesh, dist, openFile, readout, settled, useSite, useVisit, visit } from './browser.js';

const site = useSite();
const at = useVisit(site);
const entries = groups.flatMap((group) => group.entries);
const facts = JSON.parse(readFileSync(join(dist, 'gallery/facts.json'), 'utf8')) as Record<string, Facts>;

const state = (page: Page) => page.evaluate(() => globalThis.polylap.state());
async function choose(page: Page, id: string): Promise<void> {
  await page.getByRole('button', { name: 'Gallery…' }).click();
  await page.locator(`[data-entry="${id}"]`).click();
  await page.waitForFunction(
    (source) => {
      const now = JSON.stringify(globalThis.polylap.state().source);
      return now === source && globalThis.polylap.results().mesh;
    },
    JSON.stringify(entries.find((entry) => entry.id === id)?.source),
  );
  await settled(page);
}

describe('the gallery', () => {
  it('is no part of what the page opens with', () => {
    expect([...at.requests].filter((url) => /gallery|meshes/.test(url))).toEqual([]);
  });

  it('has a card for each entry, with a picture that loads and figures measured when the page was built', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Gallery…' }).click();
    await page.getByRole('dialog', { name: 'Gallery' }).waitFor();
    const cards = page
      .getByRole('dialog', { name: 'Gallery' })
      .getByRole('button')
      .filter({ has: page.locator('img') });
    expect(await cards.evaluateAll((all) => all.map((card) => (card as HTMLElement).dataset.entry))).toEqual(
      entries.map(({ id }) => id),
    );
    for (const card of await cards.all()) {
      await card.scrollIntoViewIfNeeded();
      await card.locator('img').evaluate((image: HTMLImageElement) => image.decode());
    }
    const noisy = page.locator('[data-entry="noisy-torus"]');
    expect(await noisy.textContent()).toContain('512\u00a0quads');
    expect(await noisy.locator('.card-facts b').allTextContents()).toEqual(['2\u202f048', '0']);
    await page.keyboard.press('Escape');
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('Gallery…');
  });

  it('is reached, searched and left by keyboard', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Gallery…' }).focus();
    await page.keyboard.press('Enter');
    await page.getByRole('dialog', { name: 'Gallery' }).waitFor();
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => (document.activeElement as HTMLElement).dataset.entry)).toBe(entries[0]?.id);
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => globalThis.polylap.results().a.harmonic !== null);
    expect((await state(page)).task).toBe('harmonic');
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('Gallery…');
    expect(at.troubles).toEqual([]);
  });

  it('says why when its list does not load, and opens when it does', async () => {
    const { page, close } = await visit(site);
    await page.route('**/facts.json', (route) => route.fulfill({ status: 503 }));
    await page.getByRole('button', { name: 'Gallery…' }).click();
    await page.locator('.error').waitFor({ state: 'visible' });
    expect(await page.locator('.error').textContent()).toContain(
      'The gallery cannot be shown. The file gallery/facts.json',
    );
    await page.unroute('**/facts.json');
    await page.getByRole('button', { name: 'Gallery…' }).click();
    await page.getByRole('dialog', { name: 'Gallery' }).waitFor();
    await close();
  });
});

describe('an entry', () => {
  beforeEach(async () => {
    await at.page.goto('about:blank');
    await at.page.goto(site.url);
    await settled(at.page);
  });

  it.each(entries.filter(({ figure }) => figure).map(({ id }) => id))('%s is the state it says', async (id) => {
    const { page } = at;
    await choose(page, id);
    const entry = entries.find((each) => each.id === id);
    if (!entry) throw new Error('no entry');
    const { selected, ...wanted } = stateOf(entry, initialState());
    await page.waitForFunction((step) => globalThis.polylap.results().b.step === step, wanted.step);
    await settled(page);
    const now = await state(page);
    expect(now).toMatchObject(wanted);
    expect(now.selected).toBe(selected ?? now.selected);
    expect(now.selected).not.toBeNull();
    // The step of a figure leads on from what its card says.
    if (wanted.step === 0 && id !== 'power-weights')
      expect([await readout(page, 'negative', 'a'), await readout(page, 'negative', 'b')]).toEqual(facts[id]?.negative);
    expect(await readout(page, 'faces', 'a')).toBe(facts[id]?.faces);
    const panel = page.locator('.panel');
    expect(await panel.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBe(0);
  });

  it('of the thesis comes out as there: the middle is 4/3 against 1, A dips below 0, its kernel has two dimensions', async () => {
    const { page } = at;
    const value = (side: 'a' | 'b', pick: 'min' | 'max') =>
      page
        .waitForFunction(
          ([of, what]) => {
            const { harmonic } = globalThis.polylap.results()[of];
            return harmonic && typeof harmonic !== 'string' ? { value: harmonic[what] } : null;
          },
          [side, pick] as const,
        )
        .then((handle) => handle.jsonValue())
        .then((found) => found?.value);
    await choose(page, 'one-interior-vertex');
    expect(await value('a', 'max')).toBeCloseTo(4 / 3, 12);
    expect(await value('b', 'max')).toBeCloseTo(1, 12);
    await choose(page, 'maximum-principle');
    expect(await value('a', 'min')).toBeCloseTo(-0.1147, 4);
    expect(await value('b', 'min')).toBeCloseTo(0, 12);
    await choose(page, 'checkerboard');
    await page.waitForFunction(() => {
      const [a, b] = [globalThis.polylap.results().a.check, globalThis.polylap.results().b.check];
      return typeof a === 'object' && a?.kernelDimension === 2 && typeof b === 'object' && b?.kernelDimension === 1;
    });
    expect((await state(page)).mode).toEqual({ a: 1, b: null });
    await choose(page, 'two-cuts');
    expect(await readout(page, 'smallest', 'a')).toBeCloseTo(-0.2006, 4);
  });

  it('with a vertex weight does what its card says', async () => {
    const { page } = at;
    await choose(page, 'power-weights');
    const before = await readout(page, 'negative', 'a');
    expect(before).toBe(await readout(page, 'negative', 'b'));
    await page.getByRole('textbox', { name: 'Weight ω of the vertex on A, value' }).fill('0.1');
    await page.waitForFunction((was) => {
      const { weights } = globalThis.polylap.results().a;
      return weights && typeof weights !== 'string' && weights.negativeOrdered > was;
    }, before);
    await page.getByRole('tab', { name: 'Check' }).click();
    await page.locator('[data-property=linearPrecision] [data-of=a] [data-verdict=holds]').waitFor();
  });

  it('is one change to undo, and to do again', async () => {
    const { page } = at;
    await page.getByLabel('Operator of B').selectOption('umbrella');
    await page.getByLabel('λ of A, value').fill('0.25');
    await settled(page);
    const before = await state(page);
    await choose(page, 'maximum-principle');
    const after = await state(page);
    expect(after.harmonic.pins.length).toBe(32);
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => globalThis.polylap.results().notice === 'Undone: the figure.');
    expect(await state(page)).toEqual(before);
    await page.keyboard.press('Control+Shift+z');
    await page.waitForFunction(() => globalThis.polylap.results().notice === 'Done again: the figure.');
    expect(await state(page)).toEqual(after);
  });

  it('that is a mesh leaves the task and the operators as they are', async () => {
    const { page } = at;
    await page.getByLabel('Operator of B').selectOption('umbrella');
    await page.getByRole('tab', { name: 'Smooth' }).click();
    await choose(page, 'shape-star');
    const { task, sides, source } = await state(page);
    expect([task, sides.b.operator, source.kind]).toEqual(['smooth', 'umbrella', 'shape']);
    expect(await readout(page, 'faces', 'a')).toBe(1);
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.waitForFunction(() => globalThis.polylap.state().source.kind === 'preset');
    expect((await state(page)).sides.b.operator).toBe('umbrella');
  });

  it('whose file does not come leaves the mesh on screen and what belongs to it', async () => {
    const { page } = at;
    await page.route('**/patchwork.obj', (route) => route.fulfill({ status: 404 }));
    const before = await state(page);
    await page.getByRole('button', { name: 'Gallery…' }).click();
    await page.locator('[data-entry="patchwork"]').click();
    await page.locator('.error').waitFor({ state: 'visible' });
    expect(await page.locator('.error').textContent()).toContain('the server says 404');
    expect(await state(page)).toEqual(before);
    expect(await page.getByRole('button', { name: 'Undo' }).isDisabled()).toBe(true);
    await page.unroute('**/patchwork.obj');
  });

  it('replaces an opened file, which undo brings back', async () => {
    const { page } = at;
    await openFile(page, 'quad.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
    await page.waitForFunction(() => globalThis.polylap.state().source.kind === 'file');
    await settled(page);
    await choose(page, 'soup');
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.waitForFunction(() => globalThis.polylap.state().source.kind === 'file');
    await settled(page);
    expect(await readout(page, 'faces', 'a')).toBe(1);
    await chooseMesh(page, 'noisy-torus');
  });
});

describe('the meshes that are files', () => {
  let polylap: Polylap;
  beforeAll(async () => {
    polylap = await load();
  });
  const open = (name: string) => polylap.open(readFileSync(join(dist, 'meshes', name)), name);

  /** Faces of a session with a concave corner, as seen along their vector area. */
  function concave(session: ReturnType<typeof open>): number {
    const { offsets, corners, positions } = session.geometry();
    const point = (v: number) => [0, 1, 2].map((k) => positions[3 * v + k] ?? 0) as [number, number, number];
    const minus = (p: readonly number[], q: readonly number[]) =>
      p.map((c, k) => c - (q[k] ?? 0)) as [number, number, number];
    const cross = ([a, b, c]: readonly [number, number, number], [d, e, f]: readonly [number, number, number]) =>
      [b * f - c * e, c * d - a * f, a * e - b * d] as [number, number, number];
    let count = 0;
    for (let f = 0; f + 1 < offsets.length; f++) {
      const face = [...corners.subarray(offsets[f], offsets[f + 1])].map(point);
      const next = (k: number) => face[(k + 1) % face.length] as [number, number, number];
      const turns = face.map((p, k) => cross(minus(next(k), p), minus(next(k + 1), next(k))));
      const area = face.reduce(
        (sum: readonly number[], p, k) => sum.map((c, axis) => c + (cross(p, next(k))[axis] ?? 0)),
        [0, 0, 0],
      );
      if (turns.some((turn) => turn.reduce((sum, c, axis) => sum + c * (area[axis] ?? 0), 0) < 0)) count++;
    }
    return count;
  }

  it('a soup: pieces that touch nowhere, most with a concave corner, none flat', () => {
    const soup = open('polygon-soup.obj');
    const { faces, components, issues } = soup.info();
    expect([faces, components, issues]).toEqual([24, 24, []]);
    expect(concave(soup)).toBeGreaterThan(18);
    expect(soup.shape().meanNonPlanarity).toBeGreaterThan(0.01);
  });

  it('a patchwork: closed and in one piece, of large concave faces', () => {
    const patchwork = open('patchwork.obj');
    const { faces, components, boundary, maxCorners, issues } = patchwork.info();
    expect([components, boundary.length, issues]).toEqual([1, 0, []]);
    expect(maxCorners).toBeGreaterThan(12);
    expect(concave(patchwork)).toBeGreaterThan(faces / 2);
    expect(patchwork.shape().volume).toBeCloseTo((4 / 3) * Math.PI, 0);
  });
});
