/** Pins dragged, edited and moved on the meshes; boundaries loop by loop; what leaves the range of the pins. */
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { View } from '../../web/src/state.js';
import { chooseMesh, clickVertex, openFile, picture, readout, settled, shows, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());
const label = (view: View, vertex: number) =>
  at.page.locator(`[data-view=${view}]`).getByRole('button', { name: `Pin at vertex ${vertex},` });
const pins = (page: Page) => page.evaluate(() => globalThis.polylap.state().harmonic.pins);
const undoes = (page: Page) => page.evaluate(() => globalThis.polylap.results().undoes);
const place = async (view: View, vertex: number) => {
  const spot = await at.page.evaluate(([of, v]) => globalThis.polylap.project(of, v), [view, vertex] as const);
  if (!spot) throw new Error(`vertex ${vertex} is nowhere`);
  return spot;
};
/** Takes hold of a label and moves to a vertex, without letting go. */
const hold = async (view: View, vertex: number) => {
  const box = await label(view, vertex).boundingBox();
  if (!box) throw new Error('no label');
  await at.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await at.page.mouse.down();
};
const over = async (view: View, vertex: number) => {
  const { x, y } = await place(view, vertex);
  await at.page.mouse.move(x, y, { steps: 4 });
  await at.page.waitForFunction(
    (to) => globalThis.polylap.state().harmonic.pins.some((pin) => pin.vertex === to),
    vertex,
  );
};
const start = async () => {
  const { page } = at;
  const clear = page.getByRole('button', { name: 'Clear', exact: true });
  if (await clear.isEnabled()) await clear.click();
  await page.getByRole('button', { name: 'Pin to 0' }).click();
  await clickVertex(page, 'a', 0);
  await page.getByRole('button', { name: 'Pin to 1' }).click();
  await clickVertex(page, 'a', 80);
  await settled(page);
};

describe('labels of pins', () => {
  beforeAll(async () => {
    await at.page.getByRole('tab', { name: 'Harmonic' }).click();
    await chooseMesh(at.page, 'grid-8');
    await start();
  });

  it('are dragged from vertex to vertex, the values following, and taken back in one go', async () => {
    const { page } = at;
    const camera = await page.evaluate(() => JSON.stringify(globalThis.polylap.state().camera));
    const before = await page.evaluate(() => {
      const { harmonic } = globalThis.polylap.results().a;
      return harmonic && typeof harmonic !== 'string' ? harmonic.values[40] : undefined;
    });
    await hold('a', 80);
    await over('a', 60);
    // On the way, with the button still down.
    await page.waitForFunction((was) => {
      const { harmonic } = globalThis.polylap.results().a;
      return harmonic && typeof harmonic !== 'string' && harmonic.values[60] === 1 && harmonic.values[40] !== was;
    }, before);
    await over('a', 42);
    // Into the other view.
    await over('b', 24);
    await picture(page, 'pins-drag');
    await page.mouse.up();
    await settled(page);
    expect(await pins(page)).toEqual([
      { vertex: 0, value: 0 },
      { vertex: 24, value: 1 },
    ]);
    expect(await page.evaluate(() => JSON.stringify(globalThis.polylap.state().camera))).toBe(camera);
    expect(await page.evaluate(() => globalThis.polylap.state().selected)).toBe(24);
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins[1]?.vertex === 80);
    await page.keyboard.press('Control+y');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins[1]?.vertex === 24);
  });

  it('do not land on each other, and go back with Escape', async () => {
    const { page } = at;
    await start();
    const entry = await undoes(page);
    await hold('b', 80);
    await over('b', 20);
    const { x, y } = await place('b', 0);
    await page.mouse.move(x, y, { steps: 3 });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    expect(await pins(page)).toEqual([
      { vertex: 0, value: 0 },
      { vertex: 80, value: 1 },
    ]);
    expect(await undoes(page)).toBe(entry);
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.length === 1);
    await page.keyboard.press('Control+y');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.length === 2);
  });

  it('are moved along edges by the arrow keys, and removed by Delete', async () => {
    const { page } = at;
    await label('a', 80).focus();
    // Seen from above with y up.
    await page.keyboard.press('ArrowLeft');
    await label('a', 79).waitFor();
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    expect((await pins(page))[1]).toEqual({ vertex: 61, value: 1 });
    expect(await page.locator('.notice').textContent()).toBe('Pinned at vertex 61.');
    expect(await label('a', 61).evaluate((element) => element === document.activeElement)).toBe(true);
    await page.keyboard.press('PageDown');
    expect(await label('a', 0).evaluate((element) => element === document.activeElement)).toBe(true);
    await page.keyboard.press('ArrowLeft');
    expect((await pins(page))[0]).toEqual({ vertex: 0, value: 0 });
    await page.keyboard.press('PageUp');
    await page.keyboard.press('Delete');
    expect(await pins(page)).toEqual([{ vertex: 0, value: 0 }]);
    expect(await label('a', 0).evaluate((element) => element === document.activeElement)).toBe(true);
  });

  it('take another value where they are', async () => {
    const { page } = at;
    await start();
    await label('a', 80).dblclick();
    const field = page.getByLabel('Value at vertex 80');
    await field.fill('2.5');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins[1]?.value === 2.5);
    await page.keyboard.press('Escape');
    expect((await pins(page))[1]?.value).toBe(1);
    await page.keyboard.press('Enter');
    await page.getByLabel('Value at vertex 80').fill('-3');
    await picture(page, 'pins-edit');
    await page.keyboard.press('Enter');
    expect((await pins(page))[1]).toEqual({ vertex: 80, value: -3 });
    expect(await label('a', 80).textContent()).toBe('−3');
    expect(await page.getByLabel('Value at vertex 80').count()).toBe(0);
    await settled(page);
    await shows(page, 'min', -3, -3, 1e-12);
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins[1]?.value === 1);
  });

  it('never overlap', async () => {
    const { page } = at;
    await page.getByLabel('Values of the boundary').selectOption('value');
    await settled(page);
    for (const key of ['ArrowUp', 'ArrowUp', 'ArrowUp', 'ArrowRight', '-', '-', '-']) {
      await page.locator('[data-view=a]').focus();
      await page.keyboard.press(key);
      const boxes = await page.locator('[data-view=a] .pin-label').evaluateAll(
        (labels) =>
          new Promise<DOMRect[]>((done) => {
            requestAnimationFrame(() =>
              requestAnimationFrame(() =>
                done(
                  labels
                    .filter((each) => each.checkVisibility({ visibilityProperty: true }))
                    .map((each) => each.getBoundingClientRect()),
                ),
              ),
            );
          }),
      );
      expect(boxes.length).toBeGreaterThan(2);
      for (const [k, one] of boxes.entries())
        for (const other of boxes.slice(k + 1))
          expect(
            one.x >= other.x + other.width ||
              other.x >= one.x + one.width ||
              one.y >= other.y + other.height ||
              other.y >= one.y + one.height,
          ).toBe(true);
    }
    await page.keyboard.press('0');
  });
});

describe('labels of pins in a small view', () => {
  interface Placed {
    vertex: number;
    own: number;
    others: number;
  }
  /** Of each label that is seen, how far it is from its pin and from the nearest other one. */
  const placed = () =>
    at.page.evaluate(() => {
      const { pins } = globalThis.polylap.state().harmonic;
      const dots = pins.map(({ vertex }) => ({ vertex, at: globalThis.polylap.project('a', vertex) }));
      const labels = [...document.querySelectorAll('[data-view=a] .pin-label:not(.unplaced)')];
      return labels.map((label): Placed => {
        const box = label.getBoundingClientRect();
        const vertex = Number(/vertex (\d+)/.exec(label.innerHTML)?.[1]);
        const away = dots.map((dot) => {
          const { x, y } = dot.at ?? { x: 0, y: 0 };
          const distance = Math.hypot(
            Math.max(box.left - x, 0, x - box.right),
            Math.max(box.top - y, 0, y - box.bottom),
          );
          return { vertex: dot.vertex, distance };
        });
        return {
          vertex,
          own: away.find((each) => each.vertex === vertex)?.distance ?? Number.NaN,
          others: Math.min(...away.filter((each) => each.vertex !== vertex).map(({ distance }) => distance)),
        };
      });
    });

  it('are right beside their own, or left out until they are pointed at', async () => {
    const { page } = at;
    await page.setViewportSize({ width: 900, height: 500 });
    await page.locator('[data-view=a]').scrollIntoViewIfNeeded();
    await page.mouse.move(2, 2);
    await expect.poll(async () => (await placed()).length, { timeout: 10_000 }).toBeLessThan(32);
    const labels = await placed();
    await picture(page, 'pins-small');
    expect(labels.length).toBeGreaterThan(2);
    for (const { own, others } of labels) {
      expect(own).toBeLessThan(11);
      expect(others).toBeGreaterThan(own);
    }
    const seen = new Set(labels.map(({ vertex }) => vertex));
    const without = (await pins(page)).find(({ vertex }) => !seen.has(vertex))?.vertex ?? -1;
    const { x, y } = await place('a', without);
    await page.mouse.move(x, y);
    await label('a', without).waitFor();
    await page.mouse.move(2, 2);
    await label('a', without).waitFor({ state: 'hidden' });
    await page.setViewportSize({ width: 1440, height: 900 });
  });
});

describe('the boundary', () => {
  it('is pinned loop by loop', async () => {
    const { page } = at;
    // A ring of 3 × 3 squares without the one in the middle.
    const lines: string[] = [];
    for (let j = 0; j <= 3; j++) for (let i = 0; i <= 3; i++) lines.push(`v ${i} ${j} 0`);
    for (let j = 0; j < 3; j++)
      for (let i = 0; i < 3; i++) {
        const first = 4 * j + i + 1;
        if (i !== 1 || j !== 1) lines.push(`f ${first} ${first + 1} ${first + 5} ${first + 4}`);
      }
    await openFile(page, 'ring.obj', lines.join('\n'));
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 16);
    await settled(page);
    const loop = page.getByLabel('Loop of the boundary');
    expect(await loop.locator('option').allTextContents()).toEqual([
      'all 2 loops',
      'loop 1, 12\u00a0vertices',
      'loop 2, 4\u00a0vertices',
    ]);
    await page.getByRole('button', { name: 'Pin to 1' }).click();
    await loop.selectOption('1');
    const values = page.getByLabel('Values of the boundary');
    expect(await values.locator('option').first().textContent()).toBe('choose…');
    await values.selectOption('value');
    expect((await pins(page)).map(({ vertex }) => vertex).sort((i, j) => i - j)).toEqual([5, 6, 9, 10]);
    await loop.selectOption('0');
    expect(await values.inputValue()).toBe('');
    await values.selectOption('side');
    expect(await values.inputValue()).toBe('side');
    const all = await pins(page);
    expect(all).toHaveLength(16);
    expect(
      all
        .filter(({ value }) => value === 1)
        .map(({ vertex }) => vertex)
        .sort((i, j) => i - j),
    ).toEqual([5, 6, 9, 10, 12, 13, 14, 15]);
    await picture(page, 'pins-ring');
    // It names what is pinned as long as that is what is pinned.
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    expect(await values.inputValue()).toBe('');
  });
});

describe('the status line', () => {
  const notice = () => at.page.locator('.notice').textContent();

  it('tells of a pin set by key as long as the pins are as they are', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await chooseMesh(page, 'torus');
    await page.getByRole('button', { name: 'Pin to 1' }).click();
    expect(await page.getByLabel('Values of the boundary').locator('option').first().textContent()).toBe('no boundary');
    await page.getByRole('tabpanel').getByLabel('Vertex', { exact: true }).fill('37');
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press('Enter');
    expect(await notice()).toBe('Pinned vertex 37 to 1.');
    await page.getByRole('tab', { name: 'Dual' }).click();
    expect(await notice()).toBe('');
    await page.getByRole('tab', { name: 'Harmonic' }).click();
  });

  it('refuses a value until another one is taken', async () => {
    const { page } = at;
    const field = page.getByLabel('λ of A, value');
    await field.fill('-1');
    await field.press('Tab');
    expect(await notice()).toMatch(/^λ of A takes numbers from 0/);
    await field.fill('0.75');
    expect(await notice()).toBe('');
    await field.fill('1');
    await settled(page);
  });

  it('says where smoothing was paused until it goes on', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Smooth' }).click();
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await page.waitForFunction(() => globalThis.polylap.results().b.step >= 2);
    await page.getByRole('button', { name: 'Pause', exact: true }).click();
    await page.getByText(/^Paused at step \d+\.$/).waitFor();
    await settled(page);
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await settled(page);
    expect(await notice()).toBe('');
    await page.getByRole('tab', { name: 'Harmonic' }).click();
  });
});

it('the inspector begins at its top in another task and on another mesh', async () => {
  const { page } = at;
  const panel = page.locator('.panel');
  const down = () => panel.evaluate((element) => element.scrollTo(0, 10_000));
  const top = () => panel.evaluate((element) => element.scrollTop);
  await page.getByRole('tab', { name: 'Weights' }).click();
  await settled(page);
  await down();
  expect(await top()).toBeGreaterThan(0);
  await page.keyboard.press(']');
  await settled(page);
  expect(await top()).toBeGreaterThan(0);
  await chooseMesh(page, 'noisy-torus');
  expect(await top()).toBe(0);
  await down();
  await page.getByRole('tab', { name: 'Harmonic' }).click();
  expect(await top()).toBe(0);
});

describe('what leaves the range', () => {
  const hatched = async (side: View) => {
    const box = await at.page.locator(`[data-view=${side}]`).boundingBox();
    if (!box) throw new Error('no view');
    return (await at.page.screenshot({ clip: box })).toString('base64');
  };

  it('is counted and hatched, and rounding is not shown', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.getByLabel('λ of A, value').fill('2');
    await page.getByLabel('Values of the boundary').selectOption('corner');
    await settled(page);
    await shows(page, 'outside', 49, 0);
    expect(await page.locator('[data-side=a] [data-readout=card-outside]').textContent()).toBe(
      '49\u00a0vertices below 0',
    );
    expect(await page.locator('[data-side=b] [data-readout=card-outside]').textContent()).toBe('');
    expect(await page.locator('.legend-outside').isVisible()).toBe(true);
    expect(await page.locator('[data-readout=min][data-of=b]').textContent()).toBe('0');
    expect(await readout(page, 'min', 'a')).toBeLessThan(-0.2);
    await picture(page, 'pins-hatched');
    // The legend has its most words now: on a phone they wrap.
    for (const width of [390, 320]) {
      await page.setViewportSize({ width, height: 844 });
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
    }
    await page.setViewportSize({ width: 1440, height: 900 });
    // Another loaded range changes the colours; what is hatched stays so with one colour everywhere.
    const before = await hatched('a');
    await page.getByLabel('λ of A, value').fill('0.5');
    await shows(page, 'outside', 0, 0);
    expect(await page.locator('[data-side=a] [data-readout=card-outside]').textContent()).toBe('');
    expect(await hatched('a')).not.toBe(before);
  });

  it('makes no noise', () => {
    expect(at.troubles).toEqual([]);
  });
});
