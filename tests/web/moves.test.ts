/** Steps as data, the surfaces on the way, and the links that carry a state. */
import { describe, expect, it } from 'vitest';
import { after, common, type Move, moveOf, stepsOf, upTo, withStep } from '../../web/src/moves.js';
import type { Smoothed } from '../../web/src/polylap.js';
import { readState } from '../../web/src/read-state.js';
import { linkOf, readLink } from '../../web/src/share.js';
import { initialChoice, initialState, type State } from '../../web/src/state.js';
import { Trail } from '../../web/src/trail.js';

const one = moveOf(initialState());
const other: Move = { ...one, timeH2: 0.5 };
const times = (move: Move, steps: number): Move => ({ ...move, steps });

describe('moves', () => {
  const moves = [times(one, 3), times(other, 2)];
  it('joins alike steps only', () => {
    expect(withStep([times(one, 3)], one)).toEqual([times(one, 4)]);
    expect(withStep([times(one, 3)], other)).toEqual([times(one, 3), other]);
    expect(withStep([], one)).toEqual([one]);
    expect(stepsOf(moves)).toBe(5);
  });
  it.each([
    [0, [], [3, 2]],
    [2, [2], [1, 2]],
    [3, [3], [2]],
    [4, [3, 1], [1]],
    [5, [3, 2], []],
  ])('parts after %i steps', (steps, first, rest) => {
    expect(upTo(moves, steps).map((move) => move.steps)).toEqual(first);
    expect(after(moves, steps).map((move) => move.steps)).toEqual(rest);
    expect(common(moves, upTo(moves, steps))).toBe(steps);
  });
  it('knows how far two lists go together', () => {
    expect(common(moves, [times(one, 2), times(other, 2)])).toBe(2);
    expect(common(moves, [times(one, 3), times(other, 1), one])).toBe(4);
    expect(common(moves, [other])).toBe(0);
  });
});

describe('the trail', () => {
  const surface = (step: number): Smoothed => ({
    step,
    positions: new Float32Array(3),
    coordinates: new Float64Array(3),
    stats: { area: step, volume: null, noVolume: '', meanNonPlanarity: 0, meanSquaredEdge: 1 },
    solve: null,
  });
  const filled = (steps: number, most: number) => {
    const trail = new Trail(most);
    for (let step = 1; step <= steps; step++) trail.add(step, { a: surface(step), b: surface(step) });
    return trail;
  };
  // A step takes 2 × 36 bytes.
  it('keeps all while there is room', () => {
    const trail = filled(10, 720);
    for (let step = 1; step <= 10; step++) expect(trail.at(step)?.a.step).toBe(step);
    expect(trail.lastUpTo(7)).toBe(7);
  });
  it('thins out evenly, keeps the newest and all figures', () => {
    const trail = filled(9, 720 / 2);
    const kept = Array.from({ length: 9 }, (_, k) => k + 1).filter((step) => trail.at(step));
    expect(kept).toEqual([2, 4, 6, 8, 9]);
    expect(trail.marks(1)?.a.area).toBe(1);
    expect(trail.lastUpTo(3)).toBe(2);
  });
  it('forgets what comes after a cut', () => {
    const trail = filled(5, 1e6);
    trail.cut(3);
    expect([trail.at(3)?.a.step, trail.at(4), trail.marks(4), trail.lastUpTo(9)]).toEqual([3, undefined, undefined, 3]);
    trail.clear();
    expect(trail.lastUpTo(9)).toBe(0);
  });
});

describe('links', () => {
  const changed = (): State => ({
    ...initialState(),
    task: 'harmonic',
    source: {
      kind: 'shape',
      shape: { id: 'grid', parameters: { nx: 3, ny: 4 } },
      changes: [{ id: 'dual', parameters: {}, side: 'b', moves: [times(one, 2)] }],
    },
    sides: { a: initialChoice('cotan'), b: { ...initialChoice('alexa-wardetzky'), parameters: { lambda: 0.25 } } },
    vertexWeights: { a: { 3: 0.5 }, b: {} },
    moves: [times(one, 3)],
    step: 2,
    harmonic: { pins: [{ vertex: 4, value: -1.5 }], value: 2 },
    camera: { position: [1, 2, 3], target: [0, 0.5, 0] },
    selected: 7,
    colours: { map: 'cividis', isolines: true, symmetric: true, locked: { min: -2, max: 0.5 } },
    delta: { open: true, gain: 10, swipe: 0.25 },
    theme: 'dark',
  });
  const plain = (state: State) => JSON.parse(JSON.stringify(state));

  it.each([
    ['the first state', initialState()],
    ['a changed one', changed()],
  ])('carry %s', async (_, state) => {
    const { hash, withoutFile } = await linkOf(state, null);
    const read = await readLink(hash);
    expect(withoutFile).toBe(false);
    expect(read?.file).toBeNull();
    const { parameters } = plain(read?.state as State).source.shape ?? {};
    if (parameters) expect(parameters).toMatchObject({ nx: 3, ny: 4 });
    expect({ ...plain(read?.state as State), source: 0 }).toEqual({ ...plain(state), source: 0 });
  });
  it('carry a small file, byte by byte, and not its number', async () => {
    const state: State = { ...initialState(), source: { kind: 'file', name: 'a.obj', file: 12 } };
    const bytes = Uint8Array.from({ length: 3000 }, (_, k) => (k * k) % 251);
    const { hash, withoutFile } = await linkOf(state, new Blob([bytes]));
    const read = await readLink(hash);
    expect(withoutFile).toBe(false);
    expect(new Uint8Array((await read?.file?.arrayBuffer()) ?? [])).toEqual(bytes);
    expect(read?.state.source).toEqual({ kind: 'file', name: 'a.obj', file: -1 });
  });
  it('leave a large file out, and say so', async () => {
    const state: State = { ...initialState(), source: { kind: 'file', name: 'a.obj', file: 0 } };
    let seed = 1;
    const noise = Uint8Array.from({ length: 60_000 }, () => {
      seed = (seed * 48271) % 2147483647;
      return seed & 255;
    });
    const { hash, withoutFile } = await linkOf(state, new Blob([noise]));
    expect(withoutFile).toBe(true);
    expect(hash.length).toBeLessThan(2000);
    expect((await readLink(hash))?.file).toBeNull();
  });
  it.each(['', '#', '#top', '#v=3', '#s=abc'])('are not taken for links: %s', async (hash) => {
    expect(await readLink(hash)).toBeNull();
  });
  it('that were cut off are refused', async () => {
    const { hash } = await linkOf(changed(), null);
    await expect(readLink(hash.slice(0, -30))).rejects.toThrow('a part of it is missing');
    await expect(readLink('#v=3&s=!!!')).rejects.toThrow('a part of it is missing');
  });

  const edited = (edit: (state: ReturnType<typeof plain>) => unknown) => {
    const state = plain(changed());
    edit(state);
    return () => readState(state);
  };
  it.each([
    ['another version', edited((s) => Object.assign(s, { version: 1 })), /version 3, not 1/],
    ['no state', () => readState(null), /the state is missing/],
    ['an unknown operator', edited((s) => Object.assign(s.sides.a, { operator: 'magic' })), /there is no "magic"/],
    [
      'a parameter out of range',
      edited((s) => Object.assign(s.sides.b.parameters, { lambda: -1 })),
      /lambda .* cannot be -1/,
    ],
    ['an unknown parameter', edited((s) => Object.assign(s.sides.b.parameters, { mu: 1 })), /no parameter "mu"/],
    ['a pin that is none', edited((s) => Object.assign(s.harmonic.pins[0], { vertex: 1.5 })), /vertex of pin 0/],
    ['a step that was not taken', edited((s) => Object.assign(s, { step: 4 })), /the step shown cannot be 4/],
    ['endless steps', edited((s) => Object.assign(s.moves[0], { steps: 1e9 })), /steps cannot be 1000000000/],
    [
      'an empty range',
      edited((s) => Object.assign(s.colours, { locked: { min: 1, max: 1 } })),
      /range cannot be 1 to 1/,
    ],
    ['an unknown task', edited((s) => Object.assign(s, { task: 'fly' })), /the task cannot be "fly"/],
    ['an unknown shape', edited((s) => Object.assign(s.source.shape, { id: 'cow' })), /there is no "cow"/],
    [
      'a change without a side',
      edited((s) => Object.assign(s.source.changes[0], { side: 'c' })),
      /the side of change 1/,
    ],
    ['no time', edited((s) => Object.assign(s.smooth, { timeH2: 0 })), /time step must be above 0/],
    ['a time that is none', edited((s) => Object.assign(s.smooth, { timeH2: null })), /time step must be a number/],
  ])('with %s are refused', (_, read, message) => expect(read).toThrow(message));
});
