/** What must fit: cards, panel, names and numbers, at the sizes of windows that people have. */
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { openFile, picture, settled, tasks, useSite, visit } from './browser.js';

const site = useSite();

const longName = `${'a-mesh-with-quite-a-name-'.repeat(4)}.obj`;

/** Things of a card that reach over its edge. */
const overflowing = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('.card')].flatMap((card) => {
      const { right } = card.getBoundingClientRect();
      return [...card.querySelectorAll<HTMLElement>('.card-head > *, .count > *, .parameter > *, .view, .figures')]
        .filter((element) => element.checkVisibility())
        .filter((element) => element.getBoundingClientRect().right > right + 0.5)
        .map((element) => `${element.className}: ${element.textContent}`);
    }),
  );
/** Numbers that their places cut off. */
const cut = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('[data-readout]')]
      .filter((element) => element.checkVisibility() && element.scrollWidth > element.clientWidth + 1)
      .filter((element) => element.matches('td'))
      .map((element) => `${element.dataset.readout}: ${element.textContent}`),
  );
const size = (page: Page) =>
  page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.documentElement;
    return { width: scrollWidth, height: scrollHeight };
  });

describe.each([
  [1200, 800],
  [1280, 720],
  [1320, 800],
  [1366, 768],
  [1440, 900],
  [900, 800],
  [1000, 800],
  [1024, 768],
  [390, 844],
])('%i × %i', (width, height) => {
  it('keeps everything in its place', async () => {
    const { page, close } = await visit(site, { viewport: { width, height } });
    const look = async () => {
      expect(await overflowing(page)).toEqual([]);
      const document = await size(page);
      expect(document.width).toBeLessThanOrEqual(width);
      if (width >= 1200) expect(document.height).toBeLessThanOrEqual(height);
    };
    // A vertex with a long row.
    const spokes = Array.from({ length: 60 }, (_, k) => 2 * Math.PI * (k / 60));
    const polygon = spokes.map((a) => `v ${Math.cos(a)} ${Math.sin(a)} 0`).join('\n');
    await look();
    await picture(page, `size-${width}`);
    await openFile(page, longName, `${polygon}\nf ${spokes.map((_, k) => k + 1).join(' ')}\n`);
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 60);
    await settled(page);
    await page.locator('[role=tabpanel]:visible').getByLabel('Vertex', { exact: true }).fill('7');
    await page.waitForSelector('[data-row="7"]');
    await look();
    await picture(page, `size-${width}-long`);
    for (const task of tasks) {
      await page.getByRole('tab', { name: task }).click();
      await look();
    }
    await close();
  });
});

it('numbers are whole, however small or large the mesh', async () => {
  const { page, close } = await visit(site);
  for (const scale of [1e-7, 3.7e8]) {
    const [p, q, r] = [1.2345678, 1.1234567, 1.3456789].map((x) => x * scale);
    await openFile(
      page,
      `scale-${scale}.obj`,
      `v 0 0 0\nv ${p} 0 0\nv ${p} ${q} ${0.1 * scale}\nv 0 ${q} 0\nv 0 0 ${r}\nv ${p} 0 ${r}\nf 1 4 3 2\nf 1 2 6 5\n`,
    );
    await page.waitForFunction((name) => {
      const { source } = globalThis.polylap.state();
      return source.kind === 'file' && source.name === name;
    }, `scale-${scale}.obj`);
    await settled(page);
    for (const task of tasks) {
      await page.getByRole('tab', { name: task }).click();
      if (task === 'Harmonic') {
        await page.getByLabel('Value of the next pin').fill(String(-1.23456789 * scale));
        await page.getByLabel('Values of the boundary').selectOption('value');
        await settled(page);
      }
      expect(await cut(page)).toEqual([]);
    }
    await page.getByRole('tab', { name: 'Smooth' }).click();
    expect(await page.locator('[data-readout=area][data-of=a]').textContent()).toMatch(/e−?\d+$/);
  }
  await close();
});

it('equal pins give one calm colour, and a legend that says so', async () => {
  const { page, close } = await visit(site);
  await page.getByRole('tab', { name: 'Harmonic' }).click();
  for (const vertices of [[3], [3, 100, 300]]) {
    const value = vertices.length === 1 ? 1 : 0.3;
    await page.getByLabel('Value of the next pin').fill(String(value));
    for (const vertex of vertices) {
      await page.locator('[role=tabpanel]:visible').getByLabel('Vertex', { exact: true }).fill(String(vertex));
      await page.getByRole('button', { name: 'Pin', exact: true }).click();
    }
    await page.waitForFunction(
      (pinned) =>
        globalThis.polylap.results().b.harmonic !== null && globalThis.polylap.state().harmonic.pins.length === pinned,
      vertices.length,
    );
    await settled(page);
    expect(await page.locator('.legend-values').textContent()).toMatch(new RegExp(`^${value} everywhere`));
    expect(await page.locator('[data-readout=range-max]').isVisible()).toBe(false);
    await picture(page, `single-${vertices.length}`);
    await page.getByRole('button', { name: 'Clear' }).click();
  }
  await close();
});
