/** A lecture: compare, select, change λ, and hand out the link. */
import { expect, it } from 'vitest';
import { load } from '../../wasm/src/node.js';
import { numbersOf, sharedLink, stateOf, surfacesOf } from './acts.js';
import { clickVertex, picture, readout, settled, shows, useSite, visit } from './browser.js';

const site = useSite();

it('the link that a lecturer hands out opens what was on the screen: state, numbers and surfaces', async () => {
  const lecture = await visit(site);
  const { page } = lecture;
  await shows(page, 'negative', 2048, 0);

  // Compare: another operator on B, and back; then the difference beside both.
  await page.getByLabel('Operator of B').selectOption('umbrella');
  await settled(page);
  await page.getByLabel('Operator of B').selectOption('planar');
  await page.getByRole('button', { name: 'Δ Difference' }).click();
  await settled(page);

  await clickVertex(page, 'b', (await stateOf(page)).selected ?? 0);
  await page.keyboard.press(']');
  const vertex = (await stateOf(page)).selected;
  await page.waitForSelector(`[data-row="${vertex}"]`);

  await page.getByLabel('λ of A, value').fill('0.75');
  await settled(page);
  const torus = (await load()).make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
  const { negativeOrdered, smallest } = torus.weights({ id: 'alexa-wardetzky', lambda: 0.75 });
  expect(await readout(page, 'negative', 'a')).toBe(negativeOrdered);
  expect(await readout(page, 'smallest', 'a')).toBeCloseTo(smallest, 12);

  await page.getByRole('tab', { name: 'Smooth' }).click();
  for (const step of [1, 2]) {
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await shows(page, 'step', step, step);
  }
  await page.getByRole('tab', { name: 'Weights' }).click();
  await page.waitForSelector(`[data-row="${vertex}"]`);
  await settled(page);

  await page.getByRole('button', { name: 'Share…' }).click();
  const link = await sharedLink(page);
  await page.keyboard.press('Escape');

  const seat = await visit(site, { viewport: { width: 1280, height: 800 }, colorScheme: 'dark' }, link);
  await shows(seat.page, 'negative', await readout(page, 'negative', 'a'), await readout(page, 'negative', 'b'));
  await seat.page.waitForSelector(`[data-row="${vertex}"]`);
  await settled(seat.page);
  expect(await stateOf(seat.page)).toEqual(await stateOf(page));
  expect(await surfacesOf(seat.page)).toEqual(await surfacesOf(page));
  const numbers = await numbersOf(page);
  expect(numbers.length).toBeGreaterThan(30);
  expect(await numbersOf(seat.page)).toEqual(numbers);
  await picture(seat.page, 'lecture-shared');

  // In the seat it goes on from there, and leads back.
  await seat.page.getByLabel('λ of A, value').fill('0.5');
  await settled(seat.page);
  expect((await stateOf(page)).sides.a.parameters.lambda).toBe(0.75);
  await seat.page.keyboard.press('Escape');
  expect([lecture.troubles, seat.troubles]).toEqual([[], []]);
  await seat.close();
  await lecture.close();
});
