/** What is selected: the row of a vertex, at once on large meshes too, as numbers and as spokes on the meshes; and a face. */
import { readFile } from 'node:fs/promises';
import { describe, expect, it } from 'vitest';
import type { Side } from '../../wasm/src/types.js';
import { readState } from '../../web/src/read-state.js';
import { linkOf } from '../../web/src/share.js';
import {
  type Colour,
  chooseMesh,
  clickVertex,
  picture,
  pixels,
  readout,
  settled,
  useSite,
  useVisit,
  visit,
} from './browser.js';

const site = useSite();
const at = useVisit(site);

/** Milliseconds from the click to the numbers of that vertex in the panel. */
async function clickToNumbers(vertex: number): Promise<number> {
  const { page } = at;
  await page.evaluate((wanted) => {
    const view = document.querySelector('.stage') as HTMLElement;
    const told = globalThis as unknown as { told: Promise<number> };
    told.told = new Promise((done) => {
      view.addEventListener(
        'pointerup',
        ({ timeStamp }) => {
          const observer = new MutationObserver(() => {
            if (!document.querySelector(`table[data-row="${wanted}"]`)) return;
            observer.disconnect();
            done(performance.now() - timeStamp);
          });
          observer.observe(document.querySelector('.panel') as HTMLElement, { childList: true, subtree: true });
        },
        { capture: true, once: true },
      );
    });
  }, vertex);
  await clickVertex(page, 'a', vertex);
  return page.evaluate(() => (globalThis as unknown as { told: Promise<number> }).told);
}

/** Until no frame is under way: software takes a second for one of a large mesh, and a dozen quick ones in a row show that it has. */
const drawn = () =>
  at.page.evaluate(
    () =>
      new Promise<void>((done) => {
        let quick = 0;
        let last = performance.now();
        const frame = () => {
          const now = performance.now();
          quick = now - last < 50 ? quick + 1 : 0;
          last = now;
          if (quick >= 12) done();
          else requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
      }),
  );

describe('on 100 000 faces', () => {
  it('shows the row of a vertex within 100 ms of the click', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Make…' }).click();
    await page.getByLabel('Shape', { exact: true }).selectOption('torus');
    await page.getByLabel('quads around the hole, value').fill('500');
    await page.getByLabel('quads around the tube, value').fill('200');
    await page.getByRole('button', { name: 'Make', exact: true }).click();
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.faces === 100_000);
    await settled(page);
    const seen = await page.evaluate(() => {
      const visible: number[] = [];
      for (let v = 0; v < 100_000 && visible.length < 6; v += 7919)
        if (globalThis.polylap.project('a', v)?.visible) visible.push(v);
      return visible;
    });
    expect(seen.length).toBeGreaterThan(2);
    const times: number[] = [];
    for (const vertex of seen) {
      await drawn();
      times.push(await clickToNumbers(vertex));
      await settled(page);
    }
    console.log(
      `row of a vertex of 100 000 faces after the click: ${times.map((t) => `${t.toFixed(0)} ms`).join(', ')}`,
    );
    expect(Math.min(...times)).toBeLessThanOrEqual(100);
  });
});

/** Points on the line from one vertex to another, by their share of the way. */
async function between(side: Side, from: number, to: number, shares: readonly number[]) {
  const [p, q] = await at.page.evaluate(([of, ...vertices]) => vertices.map((v) => globalThis.polylap.project(of, v)), [
    side,
    from,
    to,
  ] as const);
  if (!p || !q) throw new Error('a vertex is nowhere to be seen');
  return shares.map((t) => ({ x: p.x + t * (q.x - p.x), y: p.y + t * (q.y - p.y) }));
}

const dark = ([r, g, b]: Colour) => r < 60 && g < 60 && b < 60;
const red = ([r, g, b]: Colour) => r > 150 && g < 110 && b < 100;
const blue = ([r, , b]: Colour) => b > 120 && r < 90;

describe('spokes', () => {
  it('are as thick as the weights of both sides, dashed and marked where these are negative', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.locator('[data-field=negative-shown]').uncheck();
    await clickVertex(page, 'a', 40);
    await page.locator('table[data-row="40"]').waitFor();
    await page.mouse.move(5, 5);
    await expect
      .poll(async () => dark((await pixels(at.page, await between('a', 40, 41, [0.5])))[0] ?? [255, 0, 0]))
      .toBe(true);
    const thickness = async (side: Side) => {
      const [middle] = await between(side, 40, 41, [0.5]);
      const across = Array.from({ length: 21 }, (_, k) => ({ x: middle?.x ?? 0, y: (middle?.y ?? 0) + k - 10 }));
      return (await pixels(at.page, across)).filter(dark).length;
    };
    // On unit squares λ = 1 gives w = 2 to the neighbours, the planar operator 1.
    const [a, b] = [await thickness('a'), await thickness('b')];
    expect(b).toBeGreaterThanOrEqual(2);
    expect(a).toBeGreaterThanOrEqual(1.5 * b);
    const along = await pixels(
      at.page,
      await between('a', 40, 50, [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.62, 0.8, 0.85, 0.9]),
    );
    expect(along.filter(red).length).toBeGreaterThan(1);
    expect(along.every(red)).toBe(false);
    expect(red(along[7] ?? [0, 0, 0])).toBe(true);
    expect((await pixels(at.page, await between('b', 40, 50, [0.3, 0.5, 0.62]))).some(red)).toBe(false);
    await picture(page, 'spokes');
  });

  it('belong to Weights alone', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Check' }).click();
    await expect
      .poll(async () => dark((await pixels(at.page, await between('a', 40, 41, [0.5])))[0] ?? [0, 0, 0]))
      .toBe(false);
    await page.getByRole('tab', { name: 'Weights' }).click();
    await expect
      .poll(async () => dark((await pixels(at.page, await between('a', 40, 41, [0.5])))[0] ?? [255, 0, 0]))
      .toBe(true);
  });
});

describe('a face', () => {
  const middleOf = (side: Side, face: number) =>
    at.page.evaluate(
      ([of, number]) => {
        const { offsets, corners } = globalThis.polylap.results().mesh?.geometry ?? {};
        const places = [...(corners?.subarray(offsets?.[number], offsets?.[number + 1]) ?? [])].map((v) =>
          globalThis.polylap.project(of, v),
        );
        const mean = (c: 'x' | 'y') => places.reduce((sum, place) => sum + (place?.[c] ?? 0), 0) / places.length;
        return { x: mean('x'), y: mean('y') };
      },
      [side, face] as const,
    );
  const selected = () =>
    at.page.evaluate(() => {
      const { selected: vertex, selectedFace } = globalThis.polylap.state();
      return { vertex, face: selectedFace };
    });
  const matrix = async (side: Side) =>
    (await at.page
      .locator(`[data-matrix=${side}] tbody td`)
      .evaluateAll((cells) => cells.map((cell) => Number((cell as HTMLElement).dataset.value)))) as number[];

  it('is selected by a click inside it, a vertex by one near it', async () => {
    const { page } = at;
    const { x, y } = await middleOf('b', 27);
    await page.mouse.click(x, y);
    await page.locator('[data-face="27"]').waitFor();
    expect(await selected()).toEqual({ vertex: 40, face: 27 });
    const [near] = await between('b', 30, 31, [0.3]);
    await page.mouse.click(near?.x ?? 0, near?.y ?? 0);
    await page.locator('table[data-row="30"]').waitFor();
    expect(await selected()).toEqual({ vertex: 30, face: 27 });
    await page.mouse.move(x, y);
    await page.locator('[data-side=b]').getByText('face 27').waitFor();
  });

  it('tells its area, its normal, and what it adds to both matrices', async () => {
    expect(await readout(at.page, 'face-area', 'a')).toBeCloseTo(1, 12);
    expect(await readout(at.page, 'n-z', 'b')).toBeCloseTo(1, 12);
    expect(await readout(at.page, 'face-non-planarity', 'a')).toBeCloseTo(0, 12);
    const [p, q, r] = [1.5, -1, 0.5];
    const wanted = { a: [p, q, r, q, q, p, q, r, r, q, p, q, q, r, q, p], b: [] as number[] };
    wanted.b = [1, -0.5, 0, -0.5, -0.5, 1, -0.5, 0, 0, -0.5, 1, -0.5, -0.5, 0, -0.5, 1];
    for (const side of ['a', 'b'] as const) {
      const found = await matrix(side);
      expect(found).toHaveLength(16);
      found.forEach((value, k) => {
        expect(value).toBeCloseTo(wanted[side][k] as number, 12);
      });
    }
    expect(await at.page.locator('[data-matrix=a] .negative').count()).toBe(4);
    expect(await at.page.locator('[data-matrix=b] .negative').count()).toBe(0);
    // The planar operator cuts the square once, the other one never.
    expect(await at.page.locator('.face figure:nth-child(1) .diagonal').count()).toBe(0);
    expect(await at.page.locator('.face figure:nth-child(2) .diagonal').count()).toBe(1);
  });

  it('is outlined on both meshes', async () => {
    const { page } = at;
    await page.mouse.move(5, 5);
    const [i, j] = await page.evaluate(() => {
      const { offsets, corners } = globalThis.polylap.results().mesh?.geometry ?? {};
      return [...(corners?.subarray(offsets?.[27], (offsets?.[27] ?? 0) + 2) ?? [])];
    });
    for (const side of ['a', 'b'] as const)
      await expect
        .poll(async () => (await pixels(at.page, await between(side, i ?? 0, j ?? 0, [0.7]))).every(blue))
        .toBe(true);
    await picture(page, 'face');
  });

  it('follows the keys, the number and the operator', async () => {
    const { page } = at;
    await page.keyboard.press('}');
    await page.locator('[data-face="28"]').waitFor();
    await page.keyboard.press('{');
    await page.getByLabel('Face', { exact: true }).fill('5');
    await page.locator('[data-face="5"]').waitFor();
    await page.getByLabel('Operator of A', { exact: true }).selectOption('tutte');
    await page.getByText('Tutte has none here: its matrix is no sum over faces.').waitFor();
    expect(await page.locator('[data-matrix=a]').count()).toBe(0);
    await page.getByLabel('Operator of A', { exact: true }).selectOption('alexa-wardetzky');
    await page.locator('[data-matrix=a]').waitFor();
  });

  it('can be taken away as CSV', async () => {
    const { page } = at;
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('[data-action=csv-face]').click(),
    ]);
    expect(download.suggestedFilename()).toBe('face-5.csv');
    const lines = (await readFile(await download.path(), 'utf8')).trimEnd().split('\n');
    expect(lines[0]).toBe('i,j,S_f_A,S_f_B');
    expect(lines).toHaveLength(17);
    const diagonal = lines.map((line) => line.split(',').map(Number)).filter(([i, j]) => i === j);
    for (const [, , a, b] of diagonal)
      expect([a, b].map((value) => value?.toFixed(9))).toEqual(['1.500000000', '1.000000000']);
  });

  it('goes into a link, but not beyond the last face', async () => {
    const { page } = at;
    const state = await page.evaluate(() => globalThis.polylap.state());
    const read = readState(JSON.parse(JSON.stringify(state)));
    expect(read.selectedFace).toBe(5);
    const { selectedFace: _, ...older } = state;
    expect(readState(older).selectedFace).toBeNull();
    expect(() => readState({ ...state, selectedFace: -1 })).toThrow('the selected face cannot be -1');
    // The link as it is shared, and the same with a face that the mesh does not have.
    for (const [face, shown] of [
      [9, 9],
      [64, null],
    ] as const) {
      const { hash } = await linkOf({ ...read, selectedFace: face }, null);
      const other = await visit(site, {}, site.url + hash);
      await other.page.waitForFunction(() => globalThis.polylap.state().source.kind === 'preset');
      expect(await other.page.evaluate(() => globalThis.polylap.state().selectedFace)).toBe(shown);
      expect(other.troubles).toEqual([]);
      await other.close();
    }
  });
});

it('makes no noise', () => {
  expect(at.troubles).toEqual([]);
});
