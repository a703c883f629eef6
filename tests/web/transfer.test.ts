/** What a visitor has to wait for: the bytes up to the opening view, as a static host would send them, and the time to its first frame. */
import { expect, it } from 'vitest';
import { negative, settled, useSite, visit } from './browser.js';

const site = useSite({ compressed: true });

/** Of all files together, compressed. */
const mostBytes = 450_000;
/** From navigation to the mesh on screen, in ms. */
const soonEnough = 1000;
/** Others may be at work on this machine: the time counts in which it can be done. */
const mostVisits = 10;

const kilobytes = (bytes: number) => (bytes / 1000).toFixed(1).padStart(8);

it('the opening view comes with at most 450 kB', async () => {
  const { page, troubles, close } = await visit(site);
  // Whatever the page still wants once it has all its numbers.
  await page.waitForLoadState('networkidle');
  await close();
  const total = site.sent.reduce((sum, { compressed }) => sum + compressed, 0);
  const row = (file: string, raw: number, compressed: number) =>
    `${file.padEnd(40)}${kilobytes(raw)}${kilobytes(compressed)}`;
  const rows = site.sent.map(({ file, raw, compressed }) => row(file, raw, compressed));
  const sum = site.sent.reduce((all, { raw }) => all + raw, 0);
  console.log([`${'kB'.padEnd(40)}     raw    gzip`, ...rows, row('in all', sum, total)].join('\n'));
  expect(troubles).toEqual([]);
  const kinds = new Set(site.sent.map(({ file }) => file.replace(/.*\./, '')));
  expect([...kinds].sort()).toEqual(['css', 'html', 'js', 'wasm']);
  // Once each, and of the two modules only the smaller.
  expect(new Set(site.sent.map(({ file }) => file)).size).toBe(site.sent.length);
  expect(site.sent.filter(({ file }) => file.endsWith('.wasm')).map(({ file }) => file)).toEqual([
    expect.stringMatching(/polylap-core/),
  ]);
  expect(total).toBeLessThanOrEqual(mostBytes);
});

it('the first frame comes within a second', async () => {
  const times: number[] = [];
  do {
    const { page, close } = await visit(site);
    times.push(await page.evaluate(() => performance.getEntriesByName('polylap:first-frame')[0]?.startTime ?? NaN));
    await close();
  } while (Math.min(...times) > soonEnough && times.length < mostVisits);
  console.log(`first frame ${times.map((time) => Math.round(time)).join(', ')} ms after navigation`);
  expect(Math.min(...times)).toBeLessThanOrEqual(soonEnough);
});

it('what takes the whole core has it fetched once, and nothing is lost where it cannot be had', async () => {
  const { page, close } = await visit(site);
  const before = await negative(page);
  const wholes = () => site.sent.filter(({ file }) => /polylap-(?!core)[^/]*\.wasm$/.test(file)).length;
  const already = wholes();
  const addresses = /\/polylap-(?!core)[^/]*\.wasm$/;
  await page.route(addresses, (route) => route.abort());
  await page.getByRole('tab', { name: 'Check' }).click();
  await page.getByText(/a part of the core could not be loaded/i).waitFor();
  await settled(page);
  expect(await negative(page)).toEqual(before);

  // On a slow line it says what it waits for.
  await page.unroute(addresses);
  let deliver = () => {};
  const wanted = new Promise<void>((resolve) => {
    deliver = resolve;
  });
  await page.route(addresses, (route) => wanted.then(() => route.continue()));
  for (const task of ['Weights', 'Check']) await page.getByRole('tab', { name: task }).click();
  await page.locator('.job', { hasText: 'Loading what this takes' }).waitFor();
  deliver();
  await settled(page);
  await page.waitForFunction(() => {
    const { a, b } = globalThis.polylap.results();
    return [a.check, b.check].every((check) => check && typeof check === 'object');
  });
  expect(wholes() - already).toBe(1);
  expect(await negative(page)).toEqual(before);
  await close();
});
