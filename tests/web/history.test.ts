/** Going back and forth, and taking everything along in a link. */
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { chooseMesh, gridObj, openFile, picture, settled, shows, useSite, useVisit, visit } from './browser.js';

const site = useSite();
const at = useVisit(site);
beforeEach(async () => {
  await at.page.goto('about:blank');
  await at.page.goto(site.url);
  await settled(at.page);
});

const state = (page: Page) => page.evaluate(() => globalThis.polylap.state());
const points = (page: Page) =>
  page.evaluate(() => {
    const { a, b } = globalThis.polylap.results();
    return [Array.from(a.positions), Array.from(b.positions)];
  });
const undo = (page: Page) => page.getByRole('button', { name: 'Undo' });
const redo = (page: Page) => page.getByRole('button', { name: 'Redo' });
const step = async (page: Page, to: number) => {
  await page.getByRole('button', { name: 'Step', exact: true }).click();
  await shows(page, 'step', to, to);
  await settled(page);
};
const told = (page: Page, notice: string) =>
  page.waitForFunction((wanted) => globalThis.polylap.results().notice === wanted, notice);

describe('undo and redo', () => {
  it('have nothing to do at first', async () => {
    expect(await undo(at.page).isDisabled()).toBe(true);
    expect(await redo(at.page).isDisabled()).toBe(true);
  });

  it('take steps back and again, to the bit', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Smooth' }).click();
    const seen = [await points(page)];
    for (let k = 1; k <= 3; k++) {
      await step(page, k);
      seen.push(await points(page));
    }
    for (const k of [2, 1, 0]) {
      await undo(page).click();
      await shows(page, 'step', k, k);
      await settled(page);
      expect(await points(page)).toEqual(seen[k]);
    }
    expect(await undo(page).isDisabled()).toBe(true);
    for (const k of [1, 2]) {
      await redo(page).click();
      await shows(page, 'step', k, k);
      await settled(page);
      expect(await points(page)).toEqual(seen[k]);
    }
    // Another step from here is another future.
    await step(page, 3);
    expect(await points(page)).toEqual(seen[3]);
    expect(await redo(page).isDisabled()).toBe(true);
  });

  it('bring an operator, a parameter and pins back', async () => {
    const { page } = at;
    const weights = await page.evaluate(() => [globalThis.polylap.results().a.weights].map((w) => JSON.stringify(w)));
    await page.getByLabel('λ of A, value').fill('0.25');
    await settled(page);
    await page.waitForTimeout(800);
    await page.getByLabel('Operator of A').selectOption('cotan');
    await settled(page);
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    await settled(page);
    const pins = (await state(page)).harmonic.pins;
    expect(pins.length).toBeGreaterThan(0);

    await page.keyboard.press('Control+z');
    await told(page, 'Undone: the pins.');
    expect((await state(page)).harmonic.pins).toEqual([]);
    await page.keyboard.press('Control+z');
    await told(page, 'Undone: the operator of A.');
    expect((await state(page)).sides.a).toEqual({ operator: 'alexa-wardetzky', parameters: { lambda: 0.25 } });
    await page.keyboard.press('Control+z');
    await told(page, 'Undone: the parameters of A.');
    await settled(page);
    expect((await state(page)).sides.a.parameters).toEqual({ lambda: 1 });
    expect(await page.evaluate(() => [globalThis.polylap.results().a.weights].map((w) => JSON.stringify(w)))).toEqual(
      weights,
    );
    for (const key of ['Control+Shift+z', 'Control+y', 'Control+y']) await page.keyboard.press(key);
    await page.waitForFunction(
      (count) => globalThis.polylap.state().harmonic.pins.length === count && globalThis.polylap.idle(),
      pins.length,
    );
    expect((await state(page)).sides.a.operator).toBe('cotan');
  });

  it('open the mesh before again, with all that was done to it', async () => {
    const { page } = at;
    await openFile(page, 'grid.obj', gridObj(5));
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 36);
    await settled(page);
    await page.getByRole('tab', { name: 'Smooth' }).click();
    await step(page, 1);
    await step(page, 2);
    const smoothed = await points(page);
    await page.getByRole('button', { name: 'Make…' }).click();
    await page.getByLabel('Change', { exact: true }).selectOption('dual');
    await page.getByRole('button', { name: 'Apply' }).click();
    await page.waitForFunction(() => globalThis.polylap.state().source.changes?.length === 1);
    await settled(page);
    const dual = await points(page);
    await chooseMesh(page, 'saddle');

    await undo(page).click();
    await told(page, 'Undone: the mesh.');
    await settled(page);
    expect(await points(page)).toEqual(dual);
    await undo(page).click();
    await page.waitForFunction(() => globalThis.polylap.results().a.step === 2 && globalThis.polylap.idle());
    expect(await points(page)).toEqual(smoothed);
    await redo(page).click();
    await page.waitForFunction(() => globalThis.polylap.state().source.changes?.length === 1);
    await settled(page);
    expect(await points(page)).toEqual(dual);
  });

  it('remember at least fifty changes', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    for (let k = 0; k < 60; k++) {
      await page.getByRole('tabpanel').getByLabel('Vertex', { exact: true }).fill(String(k));
      await page.keyboard.press('Enter');
      await page.getByRole('button', { name: 'Pin', exact: true }).click();
    }
    await settled(page);
    expect((await state(page)).harmonic.pins.length).toBe(60);
    for (let k = 59; k >= 0; k--) {
      await undo(page).click();
      await page.waitForFunction((left) => globalThis.polylap.state().harmonic.pins.length === left, k);
    }
    expect(await undo(page).isDisabled()).toBe(true);
  });

  it('scrub over the steps without computing them', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Smooth' }).click();
    const seen = [await points(page)];
    for (let k = 1; k <= 4; k++) {
      await step(page, k);
      seen.push(await points(page));
    }
    const track = page.getByLabel('Step shown');
    for (const to of [1, 4, 0, 3]) {
      await track.fill(String(to));
      await shows(page, 'step', to, to);
      await settled(page);
      expect(await points(page)).toEqual(seen[to]);
      expect(await page.locator('[data-readout=step-of]').textContent()).toBe(`${to} / 4`);
    }
    await picture(page, 'scrubbed');
  });
});

describe('a link', () => {
  const linkFrom = async (page: Page) => {
    await page.getByRole('button', { name: 'Share…' }).click();
    // It opens when the link is there.
    await page.locator('#share-link').waitFor();
    return page.locator('#share-link').inputValue();
  };

  it('opens what was on screen, in another page', async () => {
    const { page } = at;
    await chooseMesh(page, 'noisy-saddle');
    await page.getByLabel('λ of A, value').fill('0.5');
    await page.getByRole('tab', { name: 'Smooth' }).click();
    await step(page, 1);
    await step(page, 2);
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    await page.locator('[data-side=a] .view').focus();
    await page.keyboard.press('ArrowLeft');
    await settled(page);
    const link = await linkFrom(page);
    const other = await visit(site, {}, link);
    await other.page.waitForFunction(
      () => globalThis.polylap.results().a.step === 2 && globalThis.polylap.results().a.harmonic !== null,
    );
    expect(await state(other.page)).toEqual(await state(page));
    expect(await points(other.page)).toEqual(await points(page));
    expect(await undo(other.page).isDisabled()).toBe(true);
    expect(other.troubles).toEqual([]);
    await other.close();
  });

  it('carries a small file with it, and asks for a large one', async () => {
    const { page } = at;
    await openFile(page, 'small.obj', gridObj(4));
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 25);
    await settled(page);
    const small = await visit(site, {}, await linkFrom(page));
    expect(await points(small.page)).toEqual(await points(page));
    await small.close();
    await page.getByRole('button', { name: 'Close' }).click();

    const text = gridObj(140);
    // What cannot be packed into little room.
    const rough = text.replaceAll(
      /^v (\S+) (\S+) .*$/gm,
      (_, x, y) => `v ${x} ${y} ${Math.sin(12.9898 * x + 78.233 * y)}`,
    );
    await openFile(page, 'large.obj', rough);
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 141 * 141);
    await page.getByLabel('λ of A, value').fill('0.125');
    await settled(page);
    const link = await linkFrom(page);
    expect(await page.locator('[data-value=share-note]').textContent()).toMatch(/^large\.obj is too large for a link/);
    const large = await visit(site, {}, link);
    expect(await large.page.locator('.error').textContent()).toContain('The link needs large.obj');
    await openFile(large.page, 'large.obj', rough);
    await large.page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 141 * 141);
    await settled(large.page);
    expect((await state(large.page)).sides.a.parameters).toEqual({ lambda: 0.125 });
    expect(await large.page.locator('.error').isVisible()).toBe(false);
    await large.close();
  });

  it('that is broken says so, and the page opens as ever', async () => {
    const broken = await visit(site, {}, `${site.url}#v=3&s=abcd`);
    expect(await broken.page.locator('.error').textContent()).toContain('The link cannot be opened');
    expect((await state(broken.page)).source).toEqual({ kind: 'preset', id: 'noisy-torus' });
    await broken.close();
  });
});
