/** Weights of vertices, dragged on the mesh. */
import { beforeAll, describe, expect, it } from 'vitest';
import { complaints } from './acts.js';
import { chooseMesh, picture, readout, settled, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());
const vertex = 40;
const handle = (side: string) => at.page.locator(`[data-view=${side}]`).getByRole('spinbutton');
const omega = () => at.page.evaluate(() => globalThis.polylap.state().vertexWeights);

describe('the handle of a weight', () => {
  beforeAll(async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.locator('[role=tabpanel]:visible').getByLabel('Vertex', { exact: true }).fill(String(vertex));
  });

  it('is there where an operator takes weights', async () => {
    const { page } = at;
    expect(await handle('a').count()).toBe(0);
    await page.getByLabel('Operator of A').selectOption('weighted-cotan');
    await settled(page);
    expect(await handle('a').isVisible()).toBe(true);
    expect(await handle('b').count()).toBe(0);
    await page.getByRole('tab', { name: 'Smooth' }).click();
    expect(await handle('a').count()).toBe(0);
    await page.getByRole('tab', { name: 'Dual' }).click();
    expect(await handle('a').isVisible()).toBe(true);
    await page.getByRole('tab', { name: 'Weights' }).click();
  });

  it('makes the radius √|ω| as long as the way it is dragged, weights following', async () => {
    const { page } = at;
    const camera = await page.evaluate(() => JSON.stringify(globalThis.polylap.state().camera));
    const edge = await page.evaluate((v) => {
      const [here, there] = [globalThis.polylap.project('a', v), globalThis.polylap.project('a', v + 9)];
      return (here?.y ?? 0) - (there?.y ?? 0);
    }, vertex);
    const largest = await readout(page, 'largest', 'a');
    const box = await handle('a').boundingBox();
    if (!box) throw new Error('no handle');
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    // Half an edge of length 1: ω = 1/4.
    await page.mouse.move(x, y - edge / 2, { steps: 5 });
    await page.waitForFunction(
      (v) => Math.abs((globalThis.polylap.state().vertexWeights.a[v] ?? 0) - 0.25) < 0.01,
      vertex,
    );
    await page.waitForFunction((was) => {
      const { weights } = globalThis.polylap.results().a;
      return weights && typeof weights !== 'string' && weights.largest !== was;
    }, largest);
    await picture(page, 'weights-drag');
    await page.mouse.up();
    expect(await page.evaluate(() => JSON.stringify(globalThis.polylap.state().camera))).toBe(camera);
    expect((await omega()).b).toEqual({});
    expect(
      await page.locator('[role=tabpanel]:visible').getByLabel('Weight ω of the vertex on A, value').inputValue(),
    ).toBe(String((await omega()).a[vertex]));
    // Down through 0 to as much below.
    await page.mouse.move(x, y);
    const now = await handle('a').boundingBox();
    if (!now) throw new Error('no handle');
    await page.mouse.move(now.x + 10, now.y + 10);
    await page.mouse.down();
    await page.mouse.move(now.x + 10, now.y + 10 + edge / 2, { steps: 5 });
    await page.waitForFunction(() => Object.keys(globalThis.polylap.state().vertexWeights.a).length === 0);
    await page.mouse.move(now.x + 10, now.y + 10 + edge, { steps: 5 });
    await page.waitForFunction(
      (v) => Math.abs((globalThis.polylap.state().vertexWeights.a[v] ?? 0) + 0.25) < 0.01,
      vertex,
    );
    await page.mouse.up();
    await page.keyboard.press('Control+z');
    await page.waitForFunction(
      (v) => Math.abs((globalThis.polylap.state().vertexWeights.a[v] ?? 0) - 0.25) < 0.01,
      vertex,
    );
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => Object.keys(globalThis.polylap.state().vertexWeights.a).length === 0);
  });

  it('goes back with Escape, and listens to keys', async () => {
    const { page } = at;
    const box = await handle('a').boundingBox();
    if (!box) throw new Error('no handle');
    const undoes = () => page.evaluate(() => globalThis.polylap.results().undoes);
    const before = await undoes();
    await page.mouse.move(box.x + 10, box.y + 10);
    await page.mouse.down();
    await page.mouse.move(box.x + 10, box.y - 40, { steps: 5 });
    await page.waitForFunction(() => Object.keys(globalThis.polylap.state().vertexWeights.a).length === 1);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    expect((await omega()).a).toEqual({});
    expect(await undoes()).toBe(before);
    await handle('a').focus();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    const unit = await page.evaluate(() => globalThis.polylap.results().mesh?.meanSquaredEdge ?? 0);
    expect((await omega()).a[vertex]).toBeCloseTo(0.02 * unit, 6);
    expect(await handle('a').getAttribute('aria-valuenow')).toBe(String((await omega()).a[vertex]));
    await page.keyboard.press('Delete');
    expect((await omega()).a).toEqual({});
    expect(await complaints(page)).toEqual([]);
    expect(at.troubles).toEqual([]);
  });
});
