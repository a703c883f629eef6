/** Rows of vertices and reports of faces: the same as in the matrices, and answered before what waits. */
import { describe, expect, it } from 'vitest';
import { load, type OperatorSpec, operators } from '../../wasm/src/node.js';
import { aw, planar, requests, sending, torus, useClients } from './client-help.js';

const polylap = await load();

describe('a row', () => {
  it.each(operators.map(({ id }) => id))('is that of the matrix: %s', (id) => {
    const session = polylap.make({ shape: 'torus', nu: 12, nv: 8, noise: 0.2, seed: 5 });
    const spec = { id } as OperatorSpec;
    const { stiffness, mass } = session.matrices(spec);
    const entries = (matrix: typeof stiffness, i: number) => {
      const found: [number, number][] = [];
      for (let j = 0; j < matrix.cols; j++)
        for (let at = matrix.colStarts[j] as number; at < (matrix.colStarts[j + 1] as number); at++)
          if (matrix.rowIndices[at] === i) found.push([j, matrix.values[at] as number]);
      return found;
    };
    for (const vertex of [0, 41, 95]) {
      const row = session.row(spec, vertex);
      expect([...row.columns].map((j, k) => [j, row.values[k]])).toEqual(entries(stiffness, vertex));
      expect(row.mass).toBe(new Map(entries(mass, vertex)).get(vertex));
      expect(row.segments.length).toBe(6 * row.segmentStarts.length);
      // A line to each of the others.
      expect([...new Set(row.segmentPairs)].map((k) => row.columns[k]).sort((p = 0, q = 0) => p - q)).toEqual(
        [...row.columns].filter((j) => j !== vertex),
      );
    }
  });

  it('goes before what waits, and sees the surface as it stands', async () => {
    const { start, worker } = clients;
    const mesh = await (await start()).make(torus);
    const before = await mesh.row(aw, 7);
    const begun = sending(worker(), 'weights');
    const waiting = [mesh.weights(aw), mesh.smooth(aw, { time: 0.05 }), mesh.shape()];
    await begun;
    const meanwhile = await mesh.row(aw, 7);
    await Promise.all(waiting);
    expect(meanwhile).toEqual(before);
    expect(requests(worker()).slice(-4)).toEqual(['weights', 'row', 'smooth', 'shape']);
    expect((await mesh.row(aw, 7)).values).not.toEqual(before.values);
  });
});

const clients = useClients();

describe('a face', () => {
  it('has the matrix of the unit square, row by row', () => {
    const session = polylap.make({ shape: 'grid', nx: 1, ny: 1, width: 1, height: 1 });
    const face = session.face({ ...aw, lambda: 1 } as OperatorSpec, 0);
    expect([...face.corners].sort()).toEqual([0, 1, 2, 3]);
    expect(face.vectorArea.map((c) => c + 0)).toEqual([0, 0, 1]);
    expect(face.normal.map((c) => c + 0)).toEqual([0, 0, 1]);
    expect(face.nonPlanarity).toBe(0);
    expect(face.projected.length).toBe(8);
    expect(face.triangles.length).toBe(0);
    expect([...(face.stiffness ?? [])].map((s) => Number(s.toFixed(12)))).toEqual([
      1.5, -1, 0.5, -1, -1, 1.5, -1, 0.5, 0.5, -1, 1.5, -1, -1, 0.5, -1, 1.5,
    ]);
    expect(session.face(planar, 0).triangles.length).toBe(6);
    const none = session.face({ id: 'tutte' }, 0);
    expect(none.stiffness).toBeNull();
    expect(none.noStiffness).toMatch(/no sum over faces/);
  });

  it('keeps the order of a matrix that is not symmetric', () => {
    const session = polylap.make({ shape: 'grid', nx: 1, ny: 1, width: 1, height: 1 });
    const spec: OperatorSpec = { id: 'alexa-wardetzky-weighted', vertexWeights: [0.3, 0, 0, 0] };
    const { stiffness: whole } = session.matrices(spec);
    const { corners, stiffness } = session.face(spec, 0);
    const n = corners.length;
    const dense = (i: number, j: number) => {
      for (let at = whole.colStarts[j] as number; at < (whole.colStarts[j + 1] as number); at++)
        if (whole.rowIndices[at] === i) return whole.values[at];
      return 0;
    };
    expect(dense(0, 1)).not.toBe(dense(1, 0));
    for (let p = 0; p < n; p++)
      for (let q = 0; q < n; q++)
        expect(stiffness?.[p * n + q]).toBe(dense(corners[p] as number, corners[q] as number));
  });

  it('is told through the worker too', async () => {
    const mesh = await (await clients.start()).make(torus);
    const session = polylap.make(torus);
    expect(await mesh.face(planar, 12, { side: 'b' })).toEqual(session.face(planar, 12));
  });
});

describe('spectrum and energy', () => {
  it('are those of the sphere and of the plane', async () => {
    const flat = polylap.make({ shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 });
    expect(flat.energy({ id: 'planar' })).toBeCloseTo(128, 9);
    const values = flat.spectrum({ id: 'planar' }, 4);
    expect(values).toHaveLength(4);
    expect(values[0]).toBeCloseTo(0, 10);
    // The second one twice: a square has no favourite direction.
    expect(values[1]).toBeCloseTo(values[2] as number, 9);
    expect(values[3]).toBeGreaterThan(values[2] as number);
    expect(() => flat.spectrum({ id: 'tutte' }, 4)).toThrow(/not symmetric/);
    expect(() => flat.spectrum({ id: 'planar' }, 0)).toThrow(expect.objectContaining({ code: 'bad-argument' }));
    const mesh = await (await clients.start()).make({ shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 });
    expect(await mesh.spectrum({ id: 'planar' }, 4, { side: 'b' })).toEqual(values);
    expect(await mesh.energy({ id: 'planar' })).toBe(flat.energy({ id: 'planar' }));
  });
});

it.each([
  ['row', -1],
  ['row', 512],
  ['row', 1.5],
  ['face', 512],
  ['face', Number.NaN],
] as const)('there is no %s %s', (what, number) => {
  const session = polylap.make(torus);
  expect(() => session[what](aw, number)).toThrow(expect.objectContaining({ code: 'bad-argument' }));
});
