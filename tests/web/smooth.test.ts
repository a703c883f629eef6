/** Smoothing to its end: what the page says when it pauses, stops, or has nothing left to smooth. */
import { beforeEach, describe, expect, it } from 'vitest';
import { PolylapError } from '../../web/src/polylap.js';
import { isFaceRefused, stopped } from '../../web/src/stops.js';
import { chooseMesh, openFile, picture, readout, settled, shows, useSite, useVisit, visit } from './browser.js';

describe('what stopped', () => {
  const side = (letter: 'a' | 'b', reason: string, collapsed = false, step = 3) => ({
    side: letter,
    step,
    collapsed,
    reason,
  });
  it('names each side with its own reason', () => {
    expect(stopped([side('a', 'One.'), side('b', 'Two.')])).toEqual({
      title: 'Both sides stopped at step 3',
      text: 'A: One. B: Two.',
    });
    expect(stopped([side('a', 'One.'), side('b', 'One.')]).text).toBe('One.');
    expect(stopped([side('a', 'One.'), side('b', 'Two.', true, 4)]).title).toBe(
      'Side A stopped at step 3; Side B stopped at step 4: the surface has collapsed there',
    );
  });
  it('knows a refused face', () => {
    expect(isFaceRefused(new PolylapError('degenerate-face', 'face 8: no area', 8))).toBe(true);
    expect(isFaceRefused(new PolylapError('worker-failed', 'gone'))).toBe(false);
  });
});

describe('in the page', () => {
  const site = useSite();
  const at = useVisit(site);
  beforeEach(async () => {
    await chooseMesh(at.page, 'torus');
    await chooseMesh(at.page, 'noisy-torus');
    await at.page.getByRole('tab', { name: 'Smooth' }).click();
  });
  const notice = () => at.page.locator('.notice').textContent();
  const stops = () =>
    at.page.waitForFunction(() => globalThis.polylap.idle() && globalThis.polylap.results().error !== null);

  it('says where it paused, also between two steps', async () => {
    const { page } = at;
    for (let round = 0; round < 4; round++) {
      const before = await readout(page, 'step', 'a');
      await page.getByRole('button', { name: 'Play' }).click();
      await page.waitForFunction((step) => globalThis.polylap.results().b.step > step + 1, before);
      // Later in each round, so that some pauses fall between steps.
      await page.waitForTimeout(35 * round);
      await page.getByRole('button', { name: 'Pause' }).click();
      await page.waitForFunction(
        () => globalThis.polylap.idle() && globalThis.polylap.results().notice !== 'Smoothing …',
      );
      expect(await notice()).toBe(`Paused at step ${await readout(page, 'step', 'a')}.`);
    }
  });

  it('offers the way back in every task', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', 1, 1);
    for (const task of ['Weights', 'Harmonic']) {
      await page.getByRole('tab', { name: task }).click();
      expect(await page.locator('.progressed').textContent()).toMatch(/^step 1/);
    }
    await page.getByRole('button', { name: 'Reset' }).click();
    await page.waitForFunction(() => globalThis.polylap.results().a.step === 0);
    expect(await page.locator('.progressed').isVisible()).toBe(false);
    await page.waitForFunction(() => globalThis.polylap.results().notice === 'Back to the loaded mesh.');
  });

  it('says that a surface has collapsed; Reset takes the message away', async () => {
    const { page } = at;
    await page.getByLabel('Time step in mean squared edge lengths, value').fill('0.4');
    await page.getByRole('button', { name: 'Play' }).click();
    await stops();
    const step = await readout(page, 'step', 'b');
    expect(await page.locator('.error').textContent()).toMatch(/stopped at step \d+: the surface has collapsed there/);
    expect(await notice()).toBe(`Stopped at step ${step}.`);
    await picture(page, 'collapsed');
    await page.getByRole('button', { name: 'Reset' }).click();
    await shows(page, 'step', 0, 0);
    await page.locator('.error').waitFor({ state: 'hidden' });
  });

  it('stops by itself when nothing is left, without rebuilding', async () => {
    const { page } = at;
    await page.getByLabel('Time step in mean squared edge lengths, value').fill('10');
    await page.getByLabel('Rebuild the operator each step').uncheck();
    await page.getByRole('button', { name: 'Play' }).click();
    await stops();
    expect(await page.locator('.error').textContent()).toMatch(
      /the surface has collapsed there.*millionth of its area/,
    );
    const area = await readout(page, 'area', 'a');
    expect(area).toBeGreaterThan(0);
    await page.getByLabel('Rebuild the operator each step').check();
    await page.getByRole('button', { name: 'Reset' }).click();
    await shows(page, 'step', 0, 0);
  });

  it('a step that succeeds takes the message away', async () => {
    const { page } = at;
    await openFile(page, 'broken.obj', 'f 1 2 3');
    await page.locator('.error').waitFor({ state: 'visible' });
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', 1, 1);
    await page.locator('.error').waitFor({ state: 'hidden' });
  });

  it('plays the first mesh for ten seconds at least', async () => {
    const fresh = await visit(site);
    await fresh.page.getByRole('tab', { name: 'Smooth' }).click();
    await fresh.page.getByRole('button', { name: 'Play' }).click();
    await fresh.page.waitForTimeout(10_000);
    const { a, b, playing } = await fresh.page.evaluate(() => globalThis.polylap.results());
    console.log(`after 10 s of play: steps ${a.step} | ${b.step}`);
    expect(playing).toBe(true);
    expect(b.step).toBeGreaterThan(10);
    await fresh.close();
  });

  it('makes no noise', async () => {
    await settled(at.page);
    expect(at.troubles).toEqual([]);
  });
});
