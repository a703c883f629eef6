/** From what a check found wrong to where it is: by mouse, by keyboard, in motion and without. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { operators } from '../../wasm/src/node.js';
import { chooseMesh, gridObj, openFile, picture, settled, useSite, type Visit, visit } from './browser.js';

const site = useSite();
const cameraOf = (page: Page) => page.evaluate(() => globalThis.polylap.state().camera);
const placeOf = (page: Page) => page.evaluate(() => globalThis.polylap.results().place);

/** What was measured of A, where it names a place. */
const places = (page: Page) =>
  page.evaluate(() => {
    const { check } = globalThis.polylap.results().a;
    if (!check || typeof check === 'string') return [];
    return check.measurements
      .filter(({ vertices }) => vertices.length > 0)
      .map(({ property, vertices }) => ({ property, vertices: [...vertices] }));
  });
const sign = (page: Page, property: string) =>
  page.locator(`[data-property=${property}] [data-of=a]`).getByRole('button');

describe('without motion', () => {
  const at = {} as Visit;
  beforeAll(async () => {
    Object.assign(at, await visit(site));
    await at.page.getByRole('tab', { name: 'Check' }).click();
  });
  afterAll(() => at.close?.());

  it('shows the place of every failure that has one, of every operator, by keyboard', async () => {
    const { page } = at;
    await chooseMesh(page, 'noisy-saddle');
    const flown = new Set<string>();
    for (const { id } of operators) {
      await page.getByLabel('Operator of A').selectOption(id);
      await settled(page);
      await page.waitForFunction(() => globalThis.polylap.results().a.check !== null);
      for (const { property, vertices } of await places(page)) {
        await sign(page, property).focus();
        await page.keyboard.press('Enter');
        expect(await placeOf(page), `${id}: ${property}`).toEqual({ side: 'a', vertices });
        const [first = -1] = vertices;
        await page.waitForFunction((v) => globalThis.polylap.project('a', v)?.visible, first);
        expect(await page.evaluate(() => globalThis.polylap.state().selected)).toBe(first);
        flown.add(property);
      }
    }
    expect(flown.size).toBeGreaterThanOrEqual(5);
  });

  it('keeps the mark until something else is selected', async () => {
    const { page } = at;
    const [found] = await places(page);
    if (!found) throw new Error('nothing is wrong');
    await sign(page, found.property).click();
    expect(await placeOf(page)).toEqual({ side: 'a', vertices: found.vertices });
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('+');
    expect(await placeOf(page)).toEqual({ side: 'a', vertices: found.vertices });
    await page.keyboard.press(']');
    expect(await placeOf(page)).toBe(null);
  });

  it('comes near where edges are small', async () => {
    const { page } = at;
    await openFile(page, 'fine.obj', gridObj(90));
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 91 * 91);
    await page.getByLabel('Operator of A').selectOption('alexa-wardetzky');
    await settled(page);
    await page.waitForFunction(() => {
      const { check } = globalThis.polylap.results().a;
      return check && typeof check !== 'string';
    });
    const found = (await places(page)).find(({ property }) => property === 'positiveWeights');
    if (!found) throw new Error('no negative weight');
    await sign(page, 'positiveWeights').click();
    const gap = await page.waitForFunction(([i, j]) => {
      const [one, other] = [globalThis.polylap.project('a', i ?? 0), globalThis.polylap.project('a', j ?? 0)];
      const distance = one && other ? Math.hypot(one.x - other.x, one.y - other.y) : 0;
      return distance > 15 ? distance : 0;
    }, found.vertices);
    expect(await gap.jsonValue()).toBeLessThan(120);
    await picture(page, 'check-near');
    expect(at.troubles).toEqual([]);
  });
});

describe('with motion', () => {
  it('flies by mouse, and is there in the end', async () => {
    const { page, troubles, close } = await visit(site, { reducedMotion: 'no-preference' });
    await page.getByRole('tab', { name: 'Check' }).click();
    await settled(page);
    await page.waitForFunction(() => globalThis.polylap.results().a.check !== null);
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press('0');
    // The other side of the torus.
    for (let turn = 0; turn < 8; turn++) await page.keyboard.press('ArrowDown');
    const before = await cameraOf(page);
    const found = (await places(page)).find(({ property }) => property === 'positiveWeights');
    const [first = -1] = found?.vertices ?? [];
    // Every frame on the way.
    await page.evaluate((v) => {
      const seen: number[] = [];
      Object.assign(globalThis, { seen });
      const look = () => {
        const at = globalThis.polylap.project('a', v);
        if (at) seen.push(Math.round(at.x), Math.round(at.y));
        requestAnimationFrame(look);
      };
      look();
    }, first);
    await sign(page, 'positiveWeights').click();
    await page.waitForFunction(
      (was) => JSON.stringify(globalThis.polylap.state().camera) !== was,
      JSON.stringify(before),
    );
    expect(await page.evaluate((v) => globalThis.polylap.project('a', v)?.visible, first)).toBe(true);
    const stations = await page.evaluate(() => new Set((globalThis as unknown as { seen: number[] }).seen).size);
    expect(stations).toBeGreaterThan(6);
    expect((await placeOf(page))?.vertices).toEqual(found?.vertices);
    expect(troubles).toEqual([]);
    await close();
  });
});
