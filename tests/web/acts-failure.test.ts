/** What may break under a page: its worker, its graphics context. */
import type { Locator, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { difference, numbersOf, stateOf, surfacesOf } from './acts.js';
import { gridObj, openFile, settled, shows, useSite, visit } from './browser.js';

const site = useSite();

const told = (page: Page, wanted: RegExp) =>
  page.waitForFunction(
    ([source]) => new RegExp(source ?? '').test(document.querySelector('.notice')?.textContent ?? ''),
    [wanted.source],
  );

/** Smooths an opened mesh by two steps. */
async function prepared(page: Page): Promise<void> {
  await openFile(page, 'grid.obj', gridObj(6));
  await page.waitForFunction(() => globalThis.polylap.state().source.kind === 'file');
  await settled(page);
  await page.getByRole('tab', { name: 'Smooth' }).click();
  for (const step of [1, 2]) {
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', step, step);
  }
  await settled(page);
}

/** As an error that nobody expected ends a worker. */
const kill = (page: Page, which: number) =>
  page.workers()[which]?.evaluate(() => {
    setTimeout(() => {
      throw new Error('killed by a test');
    });
  });

/** A picture is done when two in a row are alike. */
async function steady(place: Locator): Promise<Buffer> {
  let before = await place.screenshot();
  for (;;) {
    const again = await place.screenshot();
    if (again.equals(before)) return again;
    before = again;
  }
}

const unexpected = (troubles: readonly string[]) => troubles.filter((trouble) => !trouble.includes('killed by a test'));

describe('a worker that dies', () => {
  it.each([0, 1])(
    'is started again: worker %i; the mesh, its surfaces and all numbers stay, and a message says so',
    async (which) => {
      const { page, troubles, close } = await visit(site);
      await prepared(page);
      const [state, surfaces, numbers] = [await stateOf(page), await surfacesOf(page), await numbersOf(page)];
      expect(page.workers().length).toBe(2);
      await kill(page, which);
      await told(page, /^The worker was started again: .*The mesh is as it was\.$/);
      expect(page.workers().length).toBe(2);
      expect([await stateOf(page), await surfacesOf(page), await numbersOf(page)]).toEqual([state, surfaces, numbers]);

      // It goes on from where it was: the third step is the one that an undisturbed page takes.
      await page.getByRole('button', { name: 'Step', exact: true }).click();
      await shows(page, 'step', 3, 3);
      const twin = await visit(site);
      await prepared(twin.page);
      await twin.page.getByRole('button', { name: 'Step', exact: true }).click();
      await shows(twin.page, 'step', 3, 3);
      expect(await surfacesOf(page)).toEqual(await surfacesOf(twin.page));
      await twin.close();
      expect(unexpected(troubles)).toEqual([]);
      await close();
    },
  );

  it('in the middle of work loses the answer it was at, says so, and gives it when asked again', async () => {
    const { page, troubles, close } = await visit(site);
    // So that the workers have the whole core, and stay, when there is more to check.
    await page.getByRole('tab', { name: 'Check' }).click();
    await settled(page);
    await openFile(page, 'large.obj', gridObj(120));
    await page.waitForFunction(() => /properties/.test(document.querySelector('.job')?.textContent ?? ''));
    for (const which of [0, 1]) await kill(page, which);
    await told(page, /started again/);
    await page.waitForFunction(() => globalThis.polylap.idle());
    // Whatever is asked next asks for what was lost, too.
    for (const task of ['Weights', 'Check']) await page.getByRole('tab', { name: task }).click();
    await settled(page);
    await page.waitForFunction(() => {
      const { a, b } = globalThis.polylap.results();
      return a.check && b.check && typeof a.check !== 'string' && typeof b.check !== 'string';
    });
    expect((await stateOf(page)).source.kind).toBe('file');
    expect(unexpected(troubles)).toEqual([]);
    await close();
  });
});

describe('a graphics context that is lost', () => {
  it.each(['Weights', 'Smooth', 'Harmonic', 'Dual'])(
    'in %s: a message stands where the meshes were, then the same picture',
    async (task) => {
      const { page, troubles, close } = await visit(site);
      await page.getByRole('tab', { name: task }).click();
      if (task === 'Harmonic') await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
      await page.getByRole('button', { name: 'Δ Difference' }).click();
      await settled(page);
      const stage = page.locator('.stage');
      let before = await stage.screenshot();
      // A picture is done when two in a row are alike.
      for (let again = await stage.screenshot(); !again.equals(before); again = await stage.screenshot())
        before = again;

      await page.evaluate(() => {
        const context = document.querySelector<HTMLCanvasElement>('canvas.scene')?.getContext('webgl2');
        const extension = context?.getExtension('WEBGL_lose_context');
        Object.assign(globalThis, { restore: () => extension?.restoreContext() });
        extension?.loseContext();
      });
      await page.getByText('The graphics card took the picture away.').first().waitFor();
      // What can be done without a picture can be done.
      await page.getByLabel('λ of A, value').fill('0.5');
      await settled(page);
      await page.getByLabel('λ of A, value').fill('1');
      await settled(page);
      await page.evaluate(() => (globalThis as unknown as { restore: () => void }).restore());
      await told(page, /^The picture is back\.$/);
      expect(await page.getByText('The graphics card took').first().isVisible()).toBe(false);
      await page.waitForFunction(() => !document.querySelector('.view-message')?.checkVisibility());
      expect(await difference(page, before, await steady(stage))).toBeLessThan(0.001);
      // three.js tells the console that it lost and found its context.
      expect(troubles.filter((trouble) => !/Context (Lost|Restored)/i.test(trouble))).toEqual([]);
      await close();
    },
  );
});
