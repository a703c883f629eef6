/** Homework: a mesh of one's own, its properties, three steps, and a file that the command line makes, too. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { inFolder, meshFolder, native, readCoordinates } from '../wasm/native.js';
import { openFile, picture, settled, shows, useSite, visit } from './browser.js';

const site = useSite();
const name = 'hexagon-sphere-2.obj';
const file = fileURLToPath(new URL(name, meshFolder));
const sides = ['a', 'b'] as const;
const operators = {
  a: ['--operator', 'alexa-wardetzky', '--set', 'lambda=0.4'],
  b: ['--operator', 'planar'],
};

it('what is checked, smoothed and saved in the page is what the command line makes of the same file', async () => {
  const { page, troubles, close } = await visit(site);
  await openFile(page, name, readFileSync(file));
  await page.waitForFunction((wanted) => {
    const { source } = globalThis.polylap.state();
    return source.kind === 'file' && source.name === wanted;
  }, name);
  await page.getByLabel('λ of A, value').fill('0.4');
  await settled(page);

  await page.getByRole('tab', { name: 'Check' }).click();
  await page.waitForFunction(() => {
    const { a, b } = globalThis.polylap.results();
    return typeof a.check === 'object' && a.check && typeof b.check === 'object' && b.check;
  });
  await settled(page);
  await picture(page, 'homework-check');
  for (const side of sides) {
    const measured = await page.evaluate((of) => {
      const { check } = globalThis.polylap.results()[of];
      if (check === null || typeof check === 'string') throw new Error('nothing was measured');
      return check.measurements.map(({ property, verdict }) => [property, verdict]);
    }, side);
    const { properties } = JSON.parse(native('check', file, ...operators[side], '--json'));
    expect(measured.length).toBeGreaterThan(6);
    for (const [property, verdict] of measured)
      expect([property, properties[property ?? '']?.measured]).toEqual([property, verdict]);
  }

  await page.getByRole('tab', { name: 'Smooth' }).click();
  await page.getByLabel('Time step in mean squared edge lengths, value').fill('0.05');
  for (const step of [1, 2, 3]) {
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', step, step);
  }
  await settled(page);
  await page.getByRole('button', { name: 'Save…' }).click();
  const saved: Record<string, string> = {};
  for (const side of sides) {
    await page.getByLabel('Side', { exact: true }).selectOption(side);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save surface' }).click(),
    ]);
    saved[side] = await download.path();
  }
  inFolder((folder) => {
    for (const side of sides) {
      const [mine, out] = [saved[side] ?? '', join(folder, `${side}.obj`)];
      native('smooth', file, ...operators[side], '--time-h2', '0.05', '--steps', '3', '-o', out);
      const [ours, theirs] = [readCoordinates(mine), readCoordinates(out)];
      expect(ours.length).toBe(theirs.length);
      const worst = Math.max(...ours.map((value, k) => Math.abs(value - (theirs[k] ?? Number.NaN))));
      const relative = worst / Math.max(...theirs.map(Math.abs));
      console.log(
        `side ${side}: ${ours.length / 3} vertices, largest relative difference ${relative.toExponential(1)}`,
      );
      expect(relative).toBeLessThanOrEqual(1e-9);
      const faces = (path: string) => readFileSync(path, 'utf8').match(/^f .*$/gm);
      expect(faces(mine)).toEqual(faces(out));
    }
  });
  expect(troubles).toEqual([]);
  await close();
});
