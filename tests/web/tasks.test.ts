import { beforeAll, describe, expect, it } from 'vitest';
import { load, type Polylap } from '../../wasm/src/node.js';
import { presets } from '../../web/src/state.js';
import { chooseMesh, clickVertex, openFile, picture, readout, settled, shows, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());
let polylap: Polylap;
beforeAll(async () => {
  polylap = await load();
});

const made = (id: string) => {
  const preset = presets.find((entry) => entry.id === id);
  if (!preset || !('shape' in preset)) throw new Error(`no preset ${id} with a shape`);
  return polylap.make(preset.shape);
};

describe('smoothing', () => {
  beforeAll(() => at.page.getByRole('tab', { name: 'Smooth' }).click());

  it('steps both sides as the library does', async () => {
    const { page } = at;
    await page.getByLabel('Time step in mean squared edge lengths, value').fill('0.4');
    const session = made('noisy-torus');
    const time = 0.4 * session.info().meanSquaredEdge;
    for (let step = 1; step <= 3; step++) {
      await page.getByRole('button', { name: 'Step', exact: true }).click();
      await shows(page, 'step', step, step);
    }
    await settled(page);
    const a = session.smooth({ id: 'alexa-wardetzky' }, { time, steps: 3 }, { side: 'a' });
    const b = session.smooth({ id: 'planar' }, { time, steps: 3 }, { side: 'b' });
    for (const [side, { stats }] of [
      ['a', a],
      ['b', b],
    ] as const) {
      expect(await readout(page, 'mean-non-planarity', side)).toBeCloseTo(stats.meanNonPlanarity, 10);
      expect(await readout(page, 'area', side)).toBeCloseTo(stats.area, 10);
      expect(await readout(page, 'volume', side)).toBeCloseTo(stats.volume ?? Number.NaN, 10);
    }
    const weights = session.weights({ id: 'planar' }, { side: 'b' });
    await shows(
      page,
      'negative',
      session.weights({ id: 'alexa-wardetzky' }, { side: 'a' }).negativeOrdered,
      weights.negativeOrdered,
    );
    await picture(page, 'smooth');
  });

  it('plays, pauses in step, and goes back', async () => {
    const { page } = at;
    // Small, so that a late pause finds the surfaces still there.
    await page.getByLabel('Time step in mean squared edge lengths, value').fill('0.02');
    await page.getByRole('button', { name: 'Play' }).click();
    await page.waitForFunction(() => globalThis.polylap.results().b.step >= 6);
    await page.getByRole('button', { name: 'Pause' }).click();
    await settled(page);
    const paused = await readout(page, 'step', 'a');
    expect(await readout(page, 'step', 'b')).toBe(paused);
    await page.getByRole('button', { name: 'Reset' }).click();
    await shows(page, 'step', 0, 0);
    await settled(page);
    const shape = made('noisy-torus').shape();
    await shows(page, 'mean-non-planarity', shape.meanNonPlanarity, shape.meanNonPlanarity, 1e-12);
    await shows(page, 'negative', 2048, 0);
  });

  it('keeps the operator of the loaded mesh when told to', async () => {
    const { page } = at;
    await page.getByLabel('Time step in mean squared edge lengths, value').fill('0.4');
    await page.getByLabel('Rebuild the operator each step').uncheck();
    for (let step = 1; step <= 2; step++) {
      await page.getByRole('button', { name: 'Step', exact: true }).click();
      await shows(page, 'step', step, step);
    }
    const session = made('noisy-torus');
    const time = 0.4 * session.info().meanSquaredEdge;
    const { stats } = session.smooth({ id: 'planar' }, { time, steps: 2, rebuild: false }, { side: 'b' });
    expect(await readout(page, 'area', 'b')).toBeCloseTo(stats.area, 10);
    await page.getByLabel('Rebuild the operator each step').check();
    await page.getByRole('button', { name: 'Reset' }).click();
    await shows(page, 'step', 0, 0);
  });

  it('says why a surface has no volume', async () => {
    const { page } = at;
    await chooseMesh(page, 'saddle');
    expect(await page.locator('[data-readout=volume][data-of=a]').textContent()).toBe('none');
    expect(await page.getByText('No volume:').isVisible()).toBe(true);
  });
});

describe('smoothing that cannot go on', () => {
  it('says which face is to blame and leaves the surfaces as they were', async () => {
    const { page } = at;
    const flat = 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\n';
    await openFile(page, 'flat.obj', flat);
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 4);
    await settled(page);
    await page.getByRole('button', { name: 'Play' }).click();
    await page.locator('.error').waitFor({ state: 'visible' });
    expect(await page.locator('.error').textContent()).toMatch(/Both sides stopped at step 0.*face 1/i);
    expect(await page.getByRole('button', { name: 'Play' }).isVisible()).toBe(true);
    expect([await readout(page, 'step', 'a'), await readout(page, 'step', 'b')]).toEqual([0, 0]);
    await page.getByRole('button', { name: 'Dismiss' }).click();
  });
});

describe('harmonic interpolation', () => {
  beforeAll(async () => {
    await chooseMesh(at.page, 'grid-2');
    await at.page.getByRole('tab', { name: 'Harmonic' }).click();
  });
  const panel = () => at.page.locator('[role=tabpanel]:visible');

  it('pins by click: the centre of 2 × 2 squares is 4/3 | 1', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Pin to 0' }).click();
    for (const corner of [0, 2, 6, 8]) await clickVertex(page, 'a', corner);
    await page.getByRole('button', { name: 'Pin to 1' }).click();
    for (const middle of [1, 3, 5, 7]) await clickVertex(page, 'b', middle);
    expect(await page.evaluate(() => globalThis.polylap.state().harmonic.pins)).toHaveLength(8);
    await panel().getByLabel('Vertex', { exact: true }).fill('4');
    await page.mouse.move(2, 2);
    await shows(page, 'value', 4 / 3, 1, 1e-12);
    const texts = await panel().locator('[data-readout=value]').allTextContents();
    expect(texts).toEqual(['1.33333', '1']);
    await shows(page, 'outside', 1, 0);
    expect(await readout(page, 'range-max')).toBeCloseTo(4 / 3, 12);
    await picture(page, 'harmonic-grid');
  });

  it('follows 4λ / (1 + 2λ)', async () => {
    const { page } = at;
    for (const lambda of [0.5, 2, 0.25, 1.37]) {
      await page.getByLabel('λ of A, value').fill(String(lambda));
      await shows(page, 'value', (4 * lambda) / (1 + 2 * lambda), 1, 1e-12);
    }
    const slider = page.getByRole('slider', { name: 'λ of A' });
    await slider.focus();
    await page.keyboard.press('End');
    await shows(page, 'value', 1.6, 1, 1e-12);
    await page.getByLabel('λ of A, value').fill('0.5');
    await shows(page, 'outside', 0, 0);
    await page.getByLabel('λ of A, value').fill('1');
    await shows(page, 'value', 4 / 3, 1, 1e-12);
  });

  it('edits and removes pins in the list and by a second click', async () => {
    const { page } = at;
    await page.getByLabel('Value of the pin at vertex 1').fill('3');
    // Linear in the pins: one edge midpoint of four raised by 2.
    await shows(page, 'value', 4 / 3 + 2 / 3, 1.5, 1e-12);
    await page.getByRole('button', { name: 'Remove the pin at vertex 1' }).click();
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.length === 7);
    await clickVertex(page, 'a', 3);
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.length === 6);
    await page.getByRole('button', { name: 'Clear' }).click();
    await page.waitForFunction(() => globalThis.polylap.results().a.harmonic === null);
    expect(await page.locator('.pin-label:visible').count()).toBe(0);
  });

  it('keeps, centres and draws the range as asked', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    await page.getByLabel('Values of the boundary').selectOption('x');
    await settled(page);
    const range = async () => [await readout(page, 'range-min'), await readout(page, 'range-max')];
    const [min = 0, max = 0] = await range();
    expect(max).toBeGreaterThan(min);
    await page.getByLabel('Zero in the middle').check();
    const reach = Math.max(Math.abs(min), Math.abs(max));
    expect(await range()).toEqual([-reach, reach]);
    await page.getByLabel('Zero in the middle').uncheck();
    await page.getByLabel('Keep the range').check();
    await page.locator('.pins input').first().fill('9');
    await settled(page);
    expect(await range()).toEqual([min, max]);
    await page.getByLabel('Keep the range').uncheck();
    expect((await range())[1]).toBe(9);
    await page.getByLabel('Colours of values').selectOption('cividis');
    await page.getByLabel('Isolines').check();
    await picture(page, 'isolines');
    await page.getByLabel('Isolines').uncheck();
    await page.getByLabel('Colours of values').selectOption('viridis');
    await page.getByRole('button', { name: 'Clear' }).click();
  });

  it('pins by keyboard alone', async () => {
    const { page } = at;
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press(']');
    await page.keyboard.press('Enter');
    await page.keyboard.press('[');
    const { selected, harmonic } = await page.evaluate(() => globalThis.polylap.state());
    expect(harmonic.pins).toEqual([{ vertex: 5, value: 1 }].map((pin) => ({ ...pin, vertex: (selected ?? 0) + 1 })));
    await page.getByRole('button', { name: 'Clear' }).click();
  });

  it('marks where the maximum principle fails: one corner of an 8 × 8 grid', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.getByLabel('Values of the boundary').selectOption('corner');
    await page.waitForFunction(() => {
      const { a, b } = globalThis.polylap.results();
      return a.harmonic !== null && b.harmonic !== null;
    });
    expect(await readout(page, 'min', 'a')).toBeCloseTo(-0.1147, 4);
    expect(await readout(page, 'min', 'b')).toBeCloseTo(0, 12);
    expect(await readout(page, 'outside', 'a')).toBeGreaterThan(0);
    expect(await readout(page, 'outside', 'b')).toBe(0);
    expect(await page.locator('[data-readout=verdict]').textContent()).toContain('outside the pinned range [0, 1]');
    await picture(page, 'harmonic-corner');
  });

  it('agrees with the library on x² − y², and reproduces x', async () => {
    const { page } = at;
    await page.getByLabel('Values of the boundary').selectOption('x2-y2');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.some(({ value }) => value === -1));
    await settled(page);
    const pins = await page.evaluate(() => globalThis.polylap.state().harmonic.pins);
    expect(pins).toHaveLength(32);
    const fixed = { vertices: pins.map(({ vertex }) => vertex), values: pins.map(({ value }) => value) };
    const session = made('grid-8');
    await shows(
      page,
      'min',
      session.harmonic({ id: 'alexa-wardetzky' }, fixed).min,
      session.harmonic({ id: 'planar' }, fixed).min,
      1e-12,
    );
    await page.getByLabel('Values of the boundary').selectOption('x');
    await page.waitForFunction(
      () => globalThis.polylap.state().harmonic.pins.filter(({ value }) => value === -1).length === 9,
    );
    // Vertex 38 is at x = 2 of 8, that is −½; linear precision makes both sides say so.
    await panel().getByLabel('Vertex', { exact: true }).fill('38');
    await shows(page, 'value', -0.5, -0.5, 1e-12);
  });

  it('says why nothing is drawn when a component has no pin', async () => {
    const { page } = at;
    const square = (z: number, first: number) =>
      `v 0 0 ${z}\nv 1 0 ${z}\nv 1 1 ${z}\nv 0 1 ${z}\nf ${first} ${first + 1} ${first + 2} ${first + 3}\n`;
    await page
      .getByLabel('Mesh file')
      .setInputFiles({ name: 'two.obj', mimeType: 'text/plain', buffer: Buffer.from(square(0, 1) + square(1, 5)) });
    await page.waitForFunction(() => globalThis.polylap.results().mesh?.vertices === 8);
    await settled(page);
    await panel().getByLabel('Vertex', { exact: true }).fill('0');
    await page.locator('[data-action=pin-vertex]').click();
    await page.waitForFunction(() =>
      /component|pin|fixed|constrain/i.test(document.querySelector('[data-readout=verdict]')?.textContent ?? ''),
    );
    await page.waitForFunction(() => typeof globalThis.polylap.results().a.harmonic === 'string');
    expect(await page.locator('[data-readout=outside][data-of=a]').textContent()).toBe('–');
  });

  it('makes no noise', () => {
    expect(at.troubles).toEqual([]);
  });
});
