/** The asynchronous API in Node, without workers: the same answers as with them, and as the synchronous one. */
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type Client, createClient, load, type Polylap } from '../../wasm/src/node.js';
import { aw, failure, planar } from './client-help.js';

const shape = { shape: 'torus', nu: 16, nv: 8, noise: 0.2, seed: 3 } as const;
let client: Client;
let polylap: Polylap;
beforeAll(async () => {
  [client, polylap] = await Promise.all([createClient(), load()]);
});
afterAll(() => client.close());

it('answers as the synchronous one does, on both sides at once', async () => {
  const [mesh, session] = [await client.make(shape), polylap.make(shape)];
  const [a, b] = await Promise.all([mesh.weights(aw), mesh.weights(planar, { side: 'b' })]);
  expect(a.negativeOrdered).toBe(session.weights(aw).negativeOrdered);
  expect(b.negativeOrdered).toBe(session.weights(planar).negativeOrdered);
  expect(a.negativeOrdered).toBeGreaterThan(b.negativeOrdered);
  const { coordinates } = await mesh.smooth(aw, { time: 0.01, steps: 2 });
  expect(coordinates).toEqual(session.smooth(aw, { time: 0.01, steps: 2 }).coordinates);
  session.close();
  await mesh.close();
});

it('has the whole core from the start', async () => {
  const mesh = await client.open('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n', 'quad.obj');
  expect((await mesh.check(planar)).kernelDimension).toBe(1);
  await mesh.close();
});

it('says what is wrong, and goes on', async () => {
  const { code } = await failure(client.open('f 1 2 3', 'broken.obj'));
  expect(code).toBe('parse-error');
  const stop = new AbortController();
  const mesh = await client.make(shape);
  const steps = failure(
    mesh.smooth(aw, { time: 1e-9, steps: 1_000_000 }, { signal: stop.signal, onStep: () => stop.abort() }),
  );
  expect((await steps).code).toBe('cancelled');
  expect((await mesh.shape()).area).toBeGreaterThan(0);
  await mesh.close();
});
