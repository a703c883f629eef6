/** Edge points of the dual: read by pointing, by a tap and by number. */
import { beforeAll, describe, expect, it } from 'vitest';
import { load, type Polylap } from '../../wasm/src/node.js';
import { presets } from '../../web/src/state.js';
import { chooseMesh, picture, readout, settled, shows, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());
let polylap: Polylap;
const dual = (id: string) => {
  const preset = presets.find((entry) => entry.id === id);
  if (!preset || !('shape' in preset)) throw new Error(`no preset ${id}`);
  return polylap.make(preset.shape).dual({ mu: 0 });
};
const edgeBetween = ({ edgeVertices }: { edgeVertices: Int32Array }, i: number, j: number) => {
  for (let e = 0; e < edgeVertices.length / 2; e++)
    if (edgeVertices[2 * e] === Math.min(i, j) && edgeVertices[2 * e + 1] === Math.max(i, j)) return e;
  throw new Error('no such edge');
};
const place = async (vertex: number) => {
  const spot = await at.page.evaluate((v) => globalThis.polylap.project('a', v), vertex);
  if (!spot) throw new Error('nowhere');
  return spot;
};

describe('an edge point', () => {
  beforeAll(async () => {
    polylap = await load();
    await chooseMesh(at.page, 'grid-8');
    await at.page.getByRole('tab', { name: 'Dual' }).click();
    await at.page.waitForFunction(() => globalThis.polylap.results().b.dual !== null);
  });

  it('is read where the pointer is', async () => {
    const { page } = at;
    const edge = edgeBetween(dual('grid-8'), 40, 41);
    const [one, other] = [await place(40), await place(41)];
    await page.mouse.move((one.x + other.x) / 2 + 3, (one.y + other.y) / 2 + 3);
    await page.waitForFunction((e) => globalThis.polylap.results().edge === e, edge);
    await shows(page, 'edge-weight', 1, 1, 1e-9);
    await shows(page, 'edge-left', 0.5, 0.5, 1e-9);
    await shows(page, 'edge-right', 0.5, 0.5, 1e-9);
    expect(await page.locator('[data-readout=edge-vertices]').textContent()).toBe('between 40 and 41');
    expect(await page.locator('[data-side=a] [data-readout=card-edge]').textContent()).toBe(
      `edge ${edge}: 0.500 and 0.500, weight 1.00`,
    );
    await picture(page, 'edge-point');
    // Of no other edge, as long as no other is near.
    await page.mouse.move((one.x + other.x) / 2, (one.y + other.y) / 2 - 24);
    const next = await place(50);
    await page.mouse.move((other.x + next.x) / 2, (other.y + next.y) / 2);
    const up = edgeBetween(dual('grid-8'), 41, 50);
    await page.waitForFunction((e) => globalThis.polylap.results().edge === e, up);
  });

  it('is read by number, as the library has it, negative lengths marked', async () => {
    const { page } = at;
    await chooseMesh(page, 'noisy-torus');
    await page.waitForFunction(() => globalThis.polylap.results().b.dual !== null);
    expect(await page.evaluate(() => globalThis.polylap.results().edge)).toBe(null);
    const { lengths, weights, edgeFaces, edgePoints } = dual('noisy-torus');
    expect(edgePoints).toHaveLength(3 * weights.length);
    const edge = weights.indexOf(Math.min(...weights));
    await page.getByLabel('Edge', { exact: true }).fill(String(edge));
    await settled(page);
    expect(await readout(page, 'edge-weight', 'a')).toBeCloseTo(weights[edge] ?? Number.NaN, 10);
    expect(await readout(page, 'edge-left', 'b')).toBeCloseTo(lengths[2 * edge] ?? Number.NaN, 10);
    expect(await readout(page, 'edge-right', 'b')).toBeCloseTo(lengths[2 * edge + 1] ?? Number.NaN, 10);
    const names = await page.locator('[role=tabpanel]:visible th', { hasText: /^to face/ }).allTextContents();
    expect(names).toEqual([`to face ${edgeFaces[2 * edge]}`, `to face ${edgeFaces[2 * edge + 1]}`]);
    await page.getByLabel('Edge', { exact: true }).fill(String(weights.length));
    await page.keyboard.press('Tab');
    expect(await page.locator('.notice').textContent()).toMatch(/Edge takes whole numbers/);
  });

  it('is not read from behind, nor where it is not drawn', async () => {
    const { page } = at;
    await page.locator('[data-field=layer-points]').uncheck();
    const before = await page.evaluate(() => globalThis.polylap.results().edge);
    const box = await page.locator('[data-view=a]').boundingBox();
    if (!box) throw new Error('no view');
    await page.mouse.move(box.x + box.width / 2, box.y + 0.75 * box.height);
    await page.waitForFunction(() => globalThis.polylap.results().hovered !== null);
    expect(await page.evaluate(() => globalThis.polylap.results().edge)).toBe(before);
    await page.locator('[data-field=layer-points]').check();
    // Whatever is read along a line across the view belongs to a face in front.
    const seen = new Set<number>();
    for (let step = 1; step < 40; step++) {
      await page.mouse.move(box.x + (box.width * step) / 40, box.y + 0.7 * box.height);
      const edge = await page.evaluate(
        () =>
          new Promise<number | null>((done) =>
            requestAnimationFrame(() => requestAnimationFrame(() => done(globalThis.polylap.results().edge))),
          ),
      );
      if (edge !== null && edge !== before) seen.add(edge);
    }
    expect(seen.size).toBeGreaterThan(2);
    const { edgeVertices } = dual('noisy-torus');
    for (const edge of seen) {
      const ends = await page.evaluate(
        (vertices) => vertices.map((vertex) => globalThis.polylap.project('a', vertex)?.visible),
        [...edgeVertices.subarray(2 * edge, 2 * edge + 2)],
      );
      expect(ends).toContain(true);
    }
    expect(at.troubles).toEqual([]);
  });
});
