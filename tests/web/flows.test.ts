/** Flows of smoothing: chosen per side, explained where they are unstable, kept in history and links. */
import { beforeEach, describe, expect, it } from 'vitest';
import { moveOf, optionsOf, possible } from '../../web/src/moves.js';
import type { Mesh, Shape, Stability } from '../../web/src/polylap.js';
import { readState } from '../../web/src/read-state.js';
import { linkOf, readLink } from '../../web/src/share.js';
import { growth, verdict } from '../../web/src/stability.js';
import { initialState, type State } from '../../web/src/state.js';
import { chooseMesh, picture, readout, settled, shows, useSite, useVisit, visit } from './browser.js';

describe('what an explicit step does', () => {
  const rough: Stability = { largest: 8, smallest: 0, limit: 0.25 };
  it('multiplies the roughest mode by 1 − tλ', () => {
    expect(growth(rough, 0.1)).toBeCloseTo(0.2, 12);
    expect(growth(rough, 0.5)).toBe(-3);
    expect(growth({ largest: 8, smallest: -1, limit: 0 }, 0.1)).toBeCloseTo(1.1, 12);
  });
  it('is said in h²', () => {
    expect(verdict(rough, 0.1, 0.5)).toMatchObject({
      unstable: false,
      compared: 'stable for t < 0.500 h²',
      roughest: '4.00',
    });
    const beyond = verdict(rough, 2, 0.5);
    expect(beyond).toMatchObject({ unstable: true, compared: 't = 2 h² > 0.500 h²' });
    expect(beyond.effect).toBe('the roughest mode grows 7.0-fold a step, with alternating sign.');
  });
  it('is never stable with a negative eigenvalue', () => {
    const { unstable, effect } = verdict({ largest: 8, smallest: -1, limit: 0 }, 0.01, 1);
    expect(unstable).toBe(true);
    expect(effect).toBe('S has the eigenvalue −1.00/h², and a mode grows 1.010-fold a step.');
  });
});

describe('flows as data', () => {
  const chosen: State = {
    ...initialState(),
    smooth: {
      timeH2: 0.3,
      rebuild: false,
      flow: { a: 'conformalised', b: 'explicit' },
      keepVolume: true,
      fixBoundary: true,
    },
  };
  const mesh = (boundary: number) => ({ meanSquaredEdge: 2, boundary: new Int32Array(boundary) }) as Mesh;
  const shape = (volume: number | null) => ({ volume }) as Shape;

  it('are told to each side in its own way', () => {
    const move = moveOf(chosen);
    expect(optionsOf(move, 'b', mesh(0))).toEqual({
      time: 0.6,
      steps: 1,
      flow: 'explicit',
      rebuild: false,
      keepVolume: true,
      fixBoundary: true,
    });
    expect(optionsOf(move, 'a', mesh(0)).flow).toBe('conformalised');
  });
  it('ask for nothing that a mesh has not', () => {
    const on = (boundary: number, volume: number | null) => {
      const { keepVolume, fixBoundary } = possible(moveOf(chosen), mesh(boundary), shape(volume));
      return [keepVolume, fixBoundary];
    };
    expect(on(0, 4)).toEqual([true, false]);
    expect(on(12, null)).toEqual([false, true]);
  });
  it('go into links, in moves too', async () => {
    const state = { ...chosen, moves: [{ ...moveOf(chosen), steps: 3 }], step: 2 };
    const { hash } = await linkOf(state, null);
    const read = (await readLink(hash))?.state;
    expect(read?.smooth).toEqual(state.smooth);
    expect(JSON.stringify(read?.moves)).toBe(JSON.stringify(state.moves));
  });
  it('are implicit in links that say nothing of them', () => {
    const plain = JSON.parse(JSON.stringify({ ...chosen, moves: [moveOf(chosen)] }));
    for (const of of [plain.smooth, plain.moves[0]])
      for (const key of ['flow', 'keepVolume', 'fixBoundary']) delete of[key];
    const { smooth, moves } = readState(plain);
    const old = { ...initialState().smooth, timeH2: 0.3, rebuild: false };
    expect(smooth).toEqual(old);
    expect(moves[0]).toMatchObject(old);
  });
  it.each([
    ['an unknown flow', { flow: { a: 'upwards', b: 'explicit' } }, /the flow of A cannot be "upwards"/],
    ['half of the flows', { flow: { a: 'implicit' } }, /the flow of B/],
    ['a volume that is no choice', { keepVolume: 1 }, /keepVolume must be true or false/],
  ])('are refused with %s', (_, wrong, message) => {
    const plain = JSON.parse(JSON.stringify({ ...chosen, smooth: { ...chosen.smooth, ...wrong } }));
    expect(() => readState(plain)).toThrow(message);
  });
});

describe('in the page', () => {
  const site = useSite();
  const at = useVisit(site);
  const time = () => at.page.getByLabel('Time step in mean squared edge lengths, value');
  const step = () => at.page.getByRole('button', { name: 'Step', exact: true }).click();
  const flowOf = (side: string) => at.page.getByLabel(`Flow of ${side}`);
  const note = () => at.page.locator('[data-stability=b]');
  const noteSays = (pattern: string) =>
    at.page.waitForFunction(
      (source) => new RegExp(source).test(document.querySelector('[data-stability=b]')?.textContent ?? ''),
      pattern,
    );

  beforeEach(async () => {
    await at.page.goto('about:blank');
    await at.page.goto(site.url);
    await settled(at.page);
    await at.page.getByRole('tab', { name: 'Smooth' }).click();
  });

  it('says why a step is unstable, takes it all the same, and takes it back', async () => {
    const { page } = at;
    expect(await note().isVisible()).toBe(false);
    await flowOf('B').selectOption('explicit');
    await noteSays('stable for t < [\\d.]+ h².*multiplies the roughest mode by');
    expect(await note().getAttribute('class')).not.toContain('negative');
    const limit = Number(/t < ([\d.]+) h²/.exec((await note().textContent()) ?? '')?.[1]);
    expect(limit).toBeGreaterThan(0.02);
    const { h2, stability } = await page.evaluate(() => {
      const { mesh, b } = globalThis.polylap.results();
      return { h2: mesh?.meanSquaredEdge ?? 0, stability: b.stability as Stability };
    });
    expect(stability.limit / h2).toBeCloseTo(limit, 2);
    expect(stability.limit * stability.largest).toBeCloseTo(2, 12);

    const top = (await note().boundingBox())?.y;
    const below = page.getByLabel('Rebuild the operator each step');
    const place = (await below.boundingBox())?.y;
    await time().fill('0.5');
    await noteSays(`B unstable: t = 0.5 h² > ${limit} h².*grows [\\d.]+-fold a step, with alternating sign`);
    expect(await note().getAttribute('class')).toContain('negative');
    expect((await note().boundingBox())?.y).toBe(top);
    expect((await below.boundingBox())?.y).toBe(place);
    const factor = Math.abs(1 - 0.5 * h2 * stability.largest);
    expect(Number(/grows ([\d.]+)-fold/.exec((await note().textContent()) ?? '')?.[1])).toBeCloseTo(factor, 0);
    await picture(page, 'flow-unstable');

    const rough = await readout(page, 'mean-non-planarity', 'b');
    await step();
    await shows(page, 'step', 1, 1);
    expect(await readout(page, 'mean-non-planarity', 'b')).toBeGreaterThan(rough);
    expect(await readout(page, 'mean-non-planarity', 'a')).toBeLessThan(rough);
    await page.getByRole('button', { name: 'Undo' }).click();
    await shows(page, 'step', 0, 0);
    await settled(page);
    expect(await readout(page, 'mean-non-planarity', 'b')).toBe(rough);
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.waitForFunction(() => globalThis.polylap.state().smooth.flow.b === 'implicit');
    expect(await flowOf('B').inputValue()).toBe('implicit');
    expect(await note().isVisible()).toBe(false);
  });

  it('refuses what would overflow, and keeps the surfaces', async () => {
    const { page } = at;
    for (const side of ['A', 'B']) await flowOf(side).selectOption('explicit');
    await page.getByLabel('Rebuild the operator each step').uncheck();
    await time().fill('1000000');
    await page.getByRole('button', { name: 'Play' }).click();
    await page.waitForFunction(() => globalThis.polylap.idle() && globalThis.polylap.results().error !== null);
    const error = await page.locator('.error').textContent();
    expect(error).toMatch(/stopped at step \d+.*explicit step would take vertex \d+ beyond/);
    expect(error).not.toMatch(/collapsed/);
    const steps = await readout(page, 'step', 'b');
    expect(await readout(page, 'step', 'a')).toBe(steps);
    expect(await readout(page, 'area', 'b')).toBeGreaterThan(1e6);
    await page.getByRole('button', { name: 'Reset' }).click();
    await shows(page, 'step', 0, 0);
  });

  it('keeps the volume of a closed surface, whatever the flow', async () => {
    const { page } = at;
    const volume = await readout(page, 'volume', 'a');
    await page.getByLabel('Keep the volume').check();
    await flowOf('A').selectOption('conformalised');
    for (let k = 1; k <= 3; k++) {
      await step();
      await shows(page, 'step', k, k);
    }
    await shows(page, 'volume', volume, volume, 1e-11 * volume);
    await page.getByLabel('Keep the volume').uncheck();
    await step();
    await shows(page, 'step', 4, 4);
    expect(await readout(page, 'volume', 'b')).toBeLessThan(0.999 * volume);
    expect(await page.getByLabel('Fix the boundary').isDisabled()).toBe(true);
    expect(await page.locator('label', { hasText: 'Fix the boundary' }).textContent()).toContain(
      'the surface is closed',
    );
  });

  it('fixes the boundary of an open surface, which has no volume to keep', async () => {
    const { page } = at;
    await page.getByLabel('Keep the volume').check();
    await chooseMesh(page, 'noisy-saddle');
    const keep = page.getByLabel('Keep the volume');
    await page.waitForFunction(() => document.querySelector<HTMLInputElement>('[data-field=keepVolume]')?.disabled);
    expect(await keep.isChecked()).toBe(false);
    expect(await page.locator('label', { hasText: 'Keep the volume' }).textContent()).toContain('the surface is open');
    await page.getByLabel('Fix the boundary').check();
    await flowOf('A').selectOption('conformalised');
    await flowOf('B').selectOption('explicit');
    const moved = () =>
      page.evaluate(() => {
        const { mesh, a, b } = globalThis.polylap.results();
        if (!mesh) return null;
        const { positions } = mesh.geometry;
        const rim = new Set(mesh.boundary);
        const most = (now: Float32Array, on: boolean) =>
          Math.max(...now.map((x, k) => (rim.has(Math.floor(k / 3)) === on ? Math.abs(x - (positions[k] ?? 0)) : 0)));
        return {
          rim: [most(a.positions, true), most(b.positions, true)],
          inner: [most(a.positions, false), most(b.positions, false)],
        };
      });
    await step();
    await shows(page, 'step', 1, 1);
    const there = await moved();
    expect(there?.rim).toEqual([0, 0]);
    for (const inner of there?.inner ?? []) expect(inner).toBeGreaterThan(0.001);
    await page.getByLabel('Fix the boundary').uncheck();
    await step();
    await shows(page, 'step', 2, 2);
    for (const rim of (await moved())?.rim ?? []) expect(rim).toBeGreaterThan(0.001);
  });

  it('goes on in another page from its link', async () => {
    const { page } = at;
    await page.getByLabel('Keep the volume').check();
    await flowOf('A').selectOption('explicit');
    await flowOf('B').selectOption('conformalised');
    for (let k = 1; k <= 2; k++) {
      await step();
      await shows(page, 'step', k, k);
    }
    const state = await page.evaluate(() => globalThis.polylap.state());
    const areas = [await readout(page, 'area', 'a'), await readout(page, 'area', 'b')] as const;
    const { hash } = await linkOf(state, null);
    const other = await visit(site, {}, site.url + hash);
    await shows(other.page, 'step', 2, 2);
    await shows(other.page, 'area', areas[0], areas[1], 1e-9);
    expect(await other.page.evaluate(() => globalThis.polylap.state().smooth)).toEqual(state.smooth);
    expect(await other.page.getByLabel('Flow of B').inputValue()).toBe('conformalised');
    expect(other.troubles).toEqual([]);
    await other.close();
  });

  it('makes no noise', async () => {
    await settled(at.page);
    expect(at.troubles).toEqual([]);
  });
});
