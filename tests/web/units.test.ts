/** The parts of the page that need no browser. */
import { describe, expect, it, vi } from 'vitest';
import { load } from '../../wasm/src/node.js';
import type { App } from '../../web/src/app.js';
import { boundaryLoops, type Loop } from '../../web/src/boundary-loops.js';
import { boundaryPins, examplePins } from '../../web/src/boundary-pins.js';
import { chosenRange, sharedRange } from '../../web/src/colouring.js';
import { count, exact, real, weight } from '../../web/src/format.js';
import { latest } from '../../web/src/latest.js';
import { drawnPairs } from '../../web/src/layout/weights-panel.js';
import { countFaces, formatOfText } from '../../web/src/mesh-text.js';
import { Meshes } from '../../web/src/meshes.js';
import { describe as describeMesh, explain } from '../../web/src/messages.js';
import { type Mesh, PolylapError } from '../../web/src/polylap.js';
import { freshSide } from '../../web/src/results.js';
import { loneSides } from '../../web/src/scene/lone-sides.js';
import { initialState, withPin } from '../../web/src/state.js';
import { Store } from '../../web/src/store.js';
import { isCancelled, Unwanted, Work } from '../../web/src/work.js';

describe('numbers for people', () => {
  it.each([
    [count(2048), '2\u202f048'],
    [count(1234567), '1\u202f234\u202f567'],
    [count(-12), '−12'],
    [exact(4 / 3), '1.33333'],
    [exact(1), '1'],
    [exact(-0.25), '−0.25'],
    [exact(Number.NaN), 'undefined'],
    [real(0), '0'],
    [real(0.0664213, 3), '0.0664'],
    [real(112530.4, 5), '112\u202f530'],
    [real(14.6032, 5), '14.603'],
    [real(2.5e-9, 3), '2.50e−9'],
    [weight(-0.4444), '−0.444'],
    [weight(-2.1e-4), '−2.1e−4'],
    [weight(-0.0064), '−0.0064'],
    [weight(-1e-9), '−1.0e−9'],
    [weight(0), '0.000'],
    [weight(-0), '0.000'],
    [weight(-1234.6), '−1\u202f235'],
    [weight(-1.23456e12), '−1.23e12'],
    [real(1.5143e-10, 5), '1.51e−10'],
    [real(-1.5143e-10, 5), '−1.5e−10'],
    [real(1.23456e14, 5), '1.235e14'],
    [exact(-1.23456789e-12), '−1.235e−12'],
    [exact(1.23456789e12), '1.23457e12'],
    [exact(-1e-300), '−1e−300'],
    [drawnPairs({ pairs: new Int32Array(6), segmentPairs: Int32Array.of(2, 0, 2) }), '2 of 3'],
    [drawnPairs({ pairs: new Int32Array(4), segmentPairs: Int32Array.of(1, 0, 1) }), '2'],
  ])('%s', (text, expected) => expect(text).toBe(expected));
});

describe('the range of colours', () => {
  const side = (min: number, max: number, fixedMin: number, fixedMax: number) => ({
    ...freshSide(),
    harmonic: { values: new Float64Array(), outside: new Int32Array(), min, max, fixedMin, fixedMax },
  });
  it('is shared', () => {
    const range = sharedRange({ a: side(-0.25, 1, 0, 1), b: side(0, 1.5, 0, 1) });
    expect(range).toEqual({ min: -0.25, max: 1.5, single: null });
  });
  it.each([1, 0.3, 1e-20, -1e20])('knows that rounding is no width: %d', (value) => {
    const range = sharedRange({ a: side(value, value * (1 + 4e-16), value, value), b: freshSide() });
    expect(range?.single).toBe(value);
    expect((range?.min ?? 0) + (range?.max ?? 0)).toBe(2 * value);
  });
  it('has a middle where all is zero', () => {
    expect(sharedRange({ a: side(0, 0, 0, 0), b: freshSide() })).toEqual({ min: -1, max: 1, single: 0 });
  });
  it('can have zero in its middle, or be kept', () => {
    const range = { min: -0.25, max: 1.5, single: null };
    expect(chosenRange(range, { locked: null, symmetric: false })).toEqual(range);
    expect(chosenRange(range, { locked: null, symmetric: true })).toEqual({ min: -1.5, max: 1.5, single: null });
    expect(chosenRange(range, { locked: { min: 0, max: 1 }, symmetric: true })).toEqual({
      min: 0,
      max: 1,
      single: null,
    });
  });
  it('is as narrow as the pins are', () => {
    expect(sharedRange({ a: side(1, 1 + 1e-6, 1, 1 + 1e-6), b: freshSide() })?.single).toBe(null);
  });
});

describe('state', () => {
  it('is plain data', () => {
    const state = initialState();
    expect(JSON.parse(JSON.stringify(state))).toEqual(state);
  });

  it('sets, changes in place and removes pins without touching the old list', () => {
    const first = withPin(withPin([], 3, 1), 5, 0);
    expect(withPin(first, 3, 2)).toEqual([
      { vertex: 3, value: 2 },
      { vertex: 5, value: 0 },
    ]);
    expect(withPin(first, 3, null)).toEqual([{ vertex: 5, value: 0 }]);
    expect(first[0]).toEqual({ vertex: 3, value: 1 });
  });

  it('tells a watcher only what it looks at, until it stops', () => {
    const store = new Store({ a: 1, b: 1 });
    const seen: number[] = [];
    const stop = store.watch(
      ({ a }) => [a],
      (a) => seen.push(a),
    );
    store.set({ b: 2 });
    store.set({ a: 2 });
    stop();
    store.set({ a: 3 });
    expect(seen).toEqual([1, 2]);
  });
});

describe('work', () => {
  it('keeps of many requests the one under way and the newest', async () => {
    const started: number[] = [];
    const finish: (() => void)[] = [];
    const ask = latest((value: number) => {
      started.push(value);
      return new Promise<void>((done) => finish.push(done));
    });
    for (const value of [1, 2, 3, 4]) ask(value);
    expect(started).toEqual([1]);
    finish[0]?.();
    await new Promise((done) => setTimeout(done));
    expect(started).toEqual([1, 4]);
    finish[1]?.();
    await new Promise((done) => setTimeout(done));
    ask(5);
    expect(started).toEqual([1, 4, 5]);
  });

  it('announces what takes long, with its progress, and cancels it', async () => {
    const told: (string | null)[] = [];
    const work = new Work((busy) => told.push(busy && `${busy.label} ${busy.fraction}`));
    await work.run('short', () => Promise.resolve());
    expect(told.filter((line) => line !== null)).toEqual([]);
    const long = work.run('long', ({ signal, onProgress }) => {
      setTimeout(() => onProgress(0.5), 200);
      return new Promise((_, reject) => {
        signal.addEventListener('abort', () => reject(signal.reason));
      });
    });
    await new Promise((done) => setTimeout(done, 300));
    expect(work.idle).toBe(false);
    work.cancel();
    expect(isCancelled(await long.catch((reason) => reason))).toBe(true);
    expect(told.filter((line) => line !== null)).toEqual(['long null', 'long 0.5']);
    expect(told.at(-1)).toBe(null);
    expect(work.idle).toBe(true);
  });
});

describe('work that nobody waits for any more', () => {
  /** Jobs that end when told to, or when cancelled. */
  function jobs(...given: [label: string, side: 'a' | 'b'][]) {
    const work = new Work(() => {});
    const at = given.map(([label, side]) => {
      const job = {
        aborted: false,
        end: () => {},
        onProgress: (_: number) => {},
        outcome: Promise.resolve<unknown>(0),
      };
      const run = work.run(
        label,
        ({ signal, onProgress }) =>
          new Promise<unknown>((done, reject) => {
            signal.addEventListener('abort', () => {
              job.aborted = true;
              reject(signal.reason);
            });
            Object.assign(job, { end: () => done('done'), onProgress });
          }),
        side,
      );
      job.outcome = run.catch((reason) => reason);
      return job;
    });
    return { work, at, aborted: () => at.map((job) => job.aborted) };
  }

  it('is dropped on both sides, but for what is under way', async () => {
    const { work, at, aborted } = jobs(['one', 'a'], ['two', 'a'], ['three', 'b'], ['four', 'b']);
    work.makeWay();
    expect(aborted()).toEqual([false, true, false, true]);
    for (const { end } of at) end();
    const outcomes = await Promise.all(at.map(({ outcome }) => outcome));
    expect(outcomes.map((outcome) => outcome instanceof Unwanted)).toEqual([false, true, false, true]);
    expect(outcomes.every((outcome) => outcome === 'done' || isCancelled(outcome))).toBe(true);
    expect(work.idle).toBe(true);
  });

  it('is dropped where something newer of its name waits', () => {
    const { work, aborted } = jobs(['weights', 'a'], ['harmonic', 'a'], ['weights', 'a']);
    work.supersede('weights');
    expect(aborted()).toEqual([false, false, true]);
  });

  it('is stopped when it would go on for long', () => {
    vi.useFakeTimers();
    try {
      const { work, at, aborted } = jobs(['short', 'a'], ['long', 'b']);
      work.makeWay();
      vi.advanceTimersByTime(400);
      at[0]?.onProgress(0.9);
      at[1]?.onProgress(0.1);
      expect(aborted()).toEqual([false, false]);
      vi.advanceTimersByTime(200);
      expect(aborted()).toEqual([false, true]);
    } finally {
      vi.useRealTimers();
    }
  });
});

it('a lack of memory is told with what can be done', () => {
  expect(explain(new PolylapError('out-of-memory', 'out of memory'))).toMatch(/smaller mesh.*command line/);
  expect(explain(new PolylapError('parse-error', 'no number', -1, 4))).toBe('Line 4: no number.');
});

describe('meshes and matrices', () => {
  const grid = async () => {
    const session = (await load()).make({ shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 });
    return { session, mesh: { ...session.info(), geometry: session.geometry() } as unknown as Mesh };
  };

  it('pins a boundary to x² − y² within [-1, 1]', async () => {
    const { mesh } = await grid();
    const pins = boundaryPins(mesh, boundaryLoops(mesh), 'x2-y2', 7);
    const at = new Map(pins.map(({ vertex, value }) => [vertex, value]));
    expect(pins).toHaveLength(32);
    expect([at.get(0), at.get(4), at.get(36), at.get(1)]).toEqual([0, -1, 1, 0.5625 - 1]);
    const ones = (preset: string) =>
      boundaryPins(mesh, boundaryLoops(mesh), preset, 7).filter(({ value }) => value === 1);
    expect(boundaryPins(mesh, boundaryLoops(mesh), 'value', 7).every(({ value }) => value === 7)).toBe(true);
    expect(ones('corner')).toEqual([{ vertex: 80, value: 1 }]);
    expect(ones('side').map(({ vertex }) => vertex)).toEqual([80, 79, 78, 77, 76, 75, 74, 73, 72]);
  });

  it('finds the loops of a boundary, and their corners', async () => {
    const { mesh } = await grid();
    const [square] = boundaryLoops(mesh);
    expect(square?.vertices).toHaveLength(32);
    expect(square?.corners.map((k) => square.vertices[k]).sort((i, j) => (i ?? 0) - (j ?? 0))).toEqual([0, 8, 72, 80]);
    // A ring of eight quads whose faces disagree on the direction: an outer loop and a shorter inner one, without corners.
    const sides = 24;
    const positions = Array.from({ length: 2 * sides }, (_, k) => {
      const angle = (2 * Math.PI * (k % sides)) / sides;
      const radius = k < sides ? 1 : 2;
      return [radius * Math.cos(angle), radius * Math.sin(angle), 0];
    });
    const faces = Array.from({ length: sides }, (_, k) => {
      const next = (k + 1) % sides;
      const face = [k, next, sides + next, sides + k];
      return k % 3 === 0 ? face.reverse() : face;
    });
    const ring = {
      boundary: Int32Array.from(positions.keys()),
      geometry: {
        positions: Float32Array.from(positions.flat()),
        offsets: Int32Array.from({ length: sides + 1 }, (_, k) => 4 * k),
        corners: Int32Array.from(faces.flat()),
      } as unknown as Mesh['geometry'],
    };
    const [outer, inner, ...rest] = boundaryLoops(ring);
    expect(rest).toEqual([]);
    const sorted = (loop?: readonly number[]) => [...(loop ?? [])].sort((i, j) => i - j);
    expect(sorted(outer?.vertices)).toEqual(Array.from({ length: sides }, (_, k) => sides + k));
    expect(sorted(inner?.vertices)).toEqual(Array.from({ length: sides }, (_, k) => k));
    for (const { vertices } of [outer, inner] as Loop[])
      vertices.forEach((vertex, k) => {
        const step = Math.abs(vertex - (vertices[(k + 1) % sides] as number));
        expect([1, sides - 1]).toContain(step);
      });
    expect(outer?.corners).toEqual([]);
    // A quarter of the way round: six of the 24 edges.
    const side = boundaryPins(ring, [outer as Loop], 'side', 0).filter(({ value }) => value === 1);
    expect(side).toHaveLength(7);
  });

  it('finds two vertices far apart', async () => {
    const { mesh } = await grid();
    expect(examplePins(mesh).map(({ value }) => value)).toEqual([0, 1]);
  });
});

describe('mesh files', () => {
  it.each([
    ['# a mesh\nv 0 0 0\n', 'obj'],
    ['very nice weather', null],
    ['v for victory', null],
    ['OFF\n3 1 0\n', 'off'],
    ['# by hand\nNOFF 3 1 0', 'off'],
    ['ply\nformat ascii 1.0\n', 'ply'],
    ['solid cube\nfacet normal 0 0 1\n', 'stl'],
    ['OFFICE hours', null],
    ['solid advice', null],
  ])('%j is %s', (text, format) => expect(formatOfText(text)).toBe(format));

  it.each([
    ['a.off', 'OFF\n# counts\n8 6 12\n0 0 0\n', 6],
    ['a.off', 'OFF 8 7 12\n', 7],
    ['a.ply', 'ply\nformat ascii 1.0\nelement vertex 8\nelement face 12\nend_header\n', 12],
    ['a.txt', 'f 1 2 3', 0],
  ])('%s counts its faces', async (name, text, faces) => expect(await countFaces(new Blob([text]), name)).toBe(faces));

  it('counts binary ones', async () => {
    const stl = new DataView(new ArrayBuffer(84 + 3 * 50));
    stl.setUint32(80, 3, true);
    expect(await countFaces(new Blob([stl]), 'a.stl')).toBe(3);
    for (const little of [true, false]) {
      const counts = new DataView(new ArrayBuffer(12));
      counts.setInt32(0, 100, little);
      counts.setInt32(4, 98, little);
      expect(await countFaces(new Blob(['OFF BINARY\n', counts]), 'a.off')).toBe(98);
    }
  });
});

describe('large meshes', () => {
  const mesh = (faces: number) => ({ vertices: faces + 2, faces, issues: [] }) as unknown as Mesh;

  it('are taken with a warning from 200 000 faces on', () => {
    expect(describeMesh(mesh(200_000), 'a.obj')).not.toContain('large');
    expect(describeMesh(mesh(200_001), 'a.obj')).toContain('200\u202f001\u00a0faces. A large mesh');
  });

  it.each([
    [201e6, '', /201 MB; this page takes up to 200 MB/],
    [1000, 'OFF 9 1000001 9', /1\u202f000\u202f001\u00a0faces; this page takes up to 1\u202f000\u202f000/],
  ])('are refused beyond what the page takes, unread: %i bytes, %j', async (size, head, why) => {
    const said: object[] = [];
    const app = { results: { set: (patch: object) => said.push(patch) } } as unknown as App;
    const blob = { size, slice: () => new Blob([head]) } as unknown as Blob;
    const refused = await new Meshes(app).open(blob, 'a.off');
    expect(refused?.title).toBe('a.off is too large');
    expect(refused?.text).toMatch(why);
    expect(said).toEqual([{ error: refused, notice: 'a.off is too large' }]);
  });
});

describe('lone sides', () => {
  it('are the polygon edges of one face', () => {
    // Two quads side by side, and a triangle on the edge between them as a third face of it.
    const triangles = Int32Array.of(0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 1, 4, 6);
    const edges = Uint8Array.of(3, 6, 3, 6, 7);
    expect([...loneSides(triangles, edges, 7)]).toEqual([1, 6, 3, 2, 6]);
    // Without it and the second quad, all around.
    expect([...loneSides(triangles.slice(0, 6), edges.slice(0, 2), 5)]).toEqual([3, 6]);
  });
});
