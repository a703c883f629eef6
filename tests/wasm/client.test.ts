/** What the asynchronous client gives. */
import { describe, expect, it } from 'vitest';
import { type OperatorSpec, operators, type Smoothed } from '../../wasm/src/index.js';
import { load } from '../../wasm/src/node.js';
import { aw, big, coordinates, failure, planar, torus, useClients } from './client-help.js';
import { readMesh } from './native.js';

const { start, worker, workers } = useClients();

describe('calls', () => {
  it('gives what the synchronous API gives', async () => {
    const { make, open } = await start().then((c) => ({ make: c.make.bind(c), open: c.open.bind(c) }));
    const polylap = await load();
    const bytes = readMesh('saddle-12x12.obj');
    const session = polylap.open(bytes, 'saddle.obj');
    const mesh = await open(bytes, 'saddle.obj');
    expect(mesh).toMatchObject({ name: 'saddle.obj', ...session.info() });
    expect(mesh.geometry).toEqual(session.geometry());
    expect(await mesh.weights(aw)).toEqual(session.weights(aw));
    expect(await mesh.shape()).toEqual(session.shape());
    expect(await mesh.matrices(planar)).toEqual(session.matrices(planar));
    const fixed = { vertices: [0, 5, 100], values: [0, 1, 2.5] };
    expect(await mesh.harmonic(aw, fixed)).toEqual(session.harmonic(aw, fixed));
    expect(await mesh.check(aw)).toEqual(session.check(aw));
    expect(await mesh.dual({ mu: 0.5 })).toEqual(session.dual({ mu: 0.5 }));
    expect(await mesh.file('ply')).toEqual(session.file('ply'));
    const options = { time: 0.01, steps: 3 };
    expect(await mesh.smooth(aw, options)).toEqual(session.smooth(aw, options));
    expect(await mesh.file('obj')).toEqual(session.file('obj'));
    expect(await mesh.file('obj', { side: 'b' })).toEqual(session.file('obj', { side: 'b' }));
    await mesh.reset();
    session.reset();
    expect(await mesh.file('obj')).toEqual(session.file('obj'));
    expect((await make(torus)).geometry).toEqual(polylap.make(torus).geometry());
  });

  it('opens bytes, buffers, blobs and text', async () => {
    const { open } = await start().then((c) => ({ open: c.open.bind(c) }));
    const text = readMesh('grid-2x2.obj').toString();
    const bytes = new TextEncoder().encode(text);
    for (const input of [bytes, bytes.buffer as ArrayBuffer, new Blob([text]), text]) {
      expect((await open(input, 'a.obj')).vertices).toBe(9);
    }
    expect(bytes.length).toBe(text.length);
  });

  it('opens arrays, and keeps a copy of them', async () => {
    const { open, fromArrays } = await start().then((c) => ({
      open: c.open.bind(c),
      fromArrays: c.fromArrays.bind(c),
    }));
    const { geometry } = await open(readMesh('grid-2x2.obj'), 'grid.obj');
    const coordinates = Float64Array.from(geometry.positions);
    const { offsets, corners } = geometry;
    const [opened] = [fromArrays({ coordinates, offsets, corners }, 'squares'), coordinates.fill(NaN)];
    expect(await opened).toMatchObject({ name: 'squares', vertices: 9, faces: 4 });
    expect((await opened).geometry.corners).toEqual(corners);
    expect((await failure(fromArrays({ coordinates, offsets, corners }, 'nowhere'))).message).toMatch(/vertex 0/);
    const half = { coordinates: Float64Array.of(0, 0), offsets, corners };
    expect((await failure(fromArrays(half, 'half'))).code).toBe('bad-argument');
  });

  it('opens with repair', async () => {
    const { open } = await start().then((c) => ({ open: c.open.bind(c) }));
    const twice = `${readMesh('grid-2x2.obj')}\nf 1 2 5 4\nf 1 1 2\n`;
    expect((await failure(open(twice, 'twice.obj'))).code).toBe('bad-mesh');
    const { faces, repairs } = await open(twice, 'twice.obj', { repair: true });
    expect(faces).toBe(4);
    expect(repairs.changes.map(({ kind }) => kind)).toContain('degenerate-faces');
    expect(repairs.originalFaces).toEqual(Int32Array.of(0, 1, 2, 3));
  });

  it('converts a side to a mesh of its own', async () => {
    const c = await start();
    const polylap = await load();
    const [mesh, session] = [await c.make(torus), polylap.make(torus)];
    await mesh.smooth(aw, { time: 0.01 }, { side: 'b' });
    session.smooth(aw, { time: 0.01 }, { side: 'b' });
    const made = await mesh.convert({ conversion: 'quads' }, { side: 'b' });
    const theirs = session.convert({ conversion: 'quads' }, { side: 'b' });
    expect(made).toMatchObject({ name: 'quads of torus', ...theirs.info(), geometry: theirs.geometry() });
    await mesh.close();
    expect(await made.file('obj')).toEqual(theirs.file('obj'));
    expect((await failure(made.convert({ conversion: 'gold' } as never))).code).toBe('bad-argument');
  });

  it('takes weights of vertices and leaves them to the caller', async () => {
    const mesh = await (await start()).make({ shape: 'ico-sphere' });
    const session = (await load()).make({ shape: 'ico-sphere' });
    for (const { id } of operators.filter(({ takesVertexWeights }) => takesVertexWeights)) {
      const vertexWeights = Float64Array.from({ length: mesh.vertices }, (_, v) => 0.01 * Math.cos(v));
      const spec = { id, vertexWeights } as OperatorSpec;
      const expected = session.matrices(spec);
      const waiting = mesh.matrices(spec);
      expect(vertexWeights.length).toBe(mesh.vertices);
      vertexWeights.fill(7);
      expect(await waiting).toEqual(expected);
      vertexWeights[3] = Number.NaN;
      expect(await failure(mesh.matrices(spec))).toMatchObject({ code: 'bad-argument', element: 3 });
    }
  });

  it('studies convergence', async () => {
    const c = await start();
    const fractions: number[] = [];
    const studies = await c.convergence(planar, { onProgress: (fraction) => fractions.push(fraction) });
    expect(studies).toEqual((await load()).convergence(planar));
    expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
    expect(fractions.length).toBeGreaterThan(0);
    expect(await failure(c.convergence(planar, { signal: AbortSignal.abort() }))).toMatchObject({ code: 'cancelled' });
  });

  it('hands over code, message, element and line, and keeps the meshes', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    const error = await failure(c.open('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n', 'broken.obj'));
    expect(error).toMatchObject({ code: 'parse-error', element: 0, line: 4 });
    expect(error.message).toContain('4');
    expect((await mesh.weights(aw)).negativeOrdered).toBe(2048);
    expect(workers().length).toBe(1);
  });

  it('refuses arguments that cannot be sent, and goes on', async () => {
    const mesh = await (await start()).make(torus);
    const error = await failure(mesh.weights({ id: 'planar', rule: (() => 1) as never }));
    expect(error.code).toBe('bad-argument');
    expect((await mesh.weights(planar)).negativeOrdered).toBe(0);
  });

  it('keeps two meshes and two sides apart', async () => {
    const c = await start();
    const [one, two] = await Promise.all([c.make(torus), c.make({ shape: 'saddle', n: 6 })]);
    const before = await Promise.all([coordinates(one, 'b'), coordinates(two)]);
    const smoothed = await one.smooth(aw, { time: 0.01 });
    expect(smoothed.step).toBe(1);
    expect(await Promise.all([coordinates(one, 'b'), coordinates(two)])).toEqual(before);
    expect((await one.smooth(planar, { time: 0.01 }, { side: 'b' })).step).toBe(1);
    await one.reset('a');
    expect((await one.smooth(aw, { time: 0.01 })).coordinates).toEqual(smoothed.coordinates);
    expect((await one.smooth(planar, { time: 0.01 }, { side: 'b' })).step).toBe(2);
  });

  it('answers nothing for a closed mesh, nor after closing the client', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    await mesh.close();
    expect((await failure(mesh.shape())).code).toBe('bad-argument');
    const other = await c.make(torus);
    const waiting = [failure(other.shape()), failure(other.file('obj'))];
    c.close();
    for (const error of await Promise.all(waiting)) expect(error.code).toBe('cancelled');
    expect((await failure(c.make(torus))).code).toBe('cancelled');
    expect(worker().terminated).toBe(true);
  });
});

describe('order, progress and steps', () => {
  it('runs one request after the other, in the order of the calls', async () => {
    const mesh = await (await start()).make(torus);
    const order: string[] = [];
    const note = (name: string) => (value: unknown) => {
      order.push(name);
      return value;
    };
    const results = await Promise.all([
      mesh.smooth(aw, { time: 0.01, steps: 5 }).then(note('smooth')),
      mesh.shape().then(note('shape')),
      mesh.reset().then(note('reset')),
      mesh.shape().then(note('shape again')),
    ]);
    expect(order).toEqual(['smooth', 'shape', 'reset', 'shape again']);
    expect((results[1] as { area: number }).area).not.toBe((results[3] as { area: number }).area);
  });

  it('shows each step', async () => {
    const mesh = await (await start()).make(torus);
    const steps: Smoothed[] = [];
    const final = await mesh.smooth(aw, { time: 0.01, steps: 4 }, { onStep: (smoothed) => steps.push(smoothed) });
    expect(steps.map(({ step }) => step)).toEqual([1, 2, 3, 4]);
    expect(steps[3]).toBe(final);
    const areas = steps.map(({ stats }) => stats.area);
    expect(areas).toEqual([...areas].sort((a, b) => b - a));
  });

  it('reports progress of long calls, rising in [0, 1]', async () => {
    const mesh = await (await start()).make({ ...big, nx: 200, ny: 200 });
    const smoothing: number[] = [];
    await mesh.smooth(aw, { time: 1e-5, steps: 4 }, { onProgress: (fraction) => smoothing.push(fraction) });
    expect(smoothing.length).toBeGreaterThan(3);
    const weighing: number[] = [];
    await mesh.weights({ id: 'alexa-wardetzky', lambda: 2 }, { onProgress: (fraction) => weighing.push(fraction) });
    expect(weighing.length).toBeGreaterThan(0);
    for (const fractions of [smoothing, weighing]) {
      expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
      expect(Math.min(...fractions)).toBeGreaterThanOrEqual(0);
      expect(Math.max(...fractions)).toBeLessThanOrEqual(1);
    }
  });
});
