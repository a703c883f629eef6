/** The page that the browser benchmark drives: see run.mjs. */
import { type Client, createClient, type Mesh, type Side } from '../../../wasm/src/index.js';

export interface Row {
  name: string;
  n: number;
  unit: string;
  value: number;
}

const sides: readonly Side[] = ['a', 'b'];
const specs = { a: { id: 'alexa-wardetzky' }, b: { id: 'planar' } } as const;

/** One job of a worker of its own, which then has ended: nothing of it is left in memory. */
function ask<T>(worker: Worker, message: unknown): Promise<T> {
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }) => {
      worker.terminate();
      if (typeof data === 'string') reject(new Error(data));
      else resolve(data);
    };
    worker.onerror = (event) => reject(new Error(event.message));
    worker.postMessage(message);
  });
}

const shortest = (times: readonly number[]) => Math.min(...times);
const median = (times: readonly number[]) => [...times].sort((a, b) => a - b)[times.length >> 1] ?? Number.NaN;

async function timed(repeats: number, work: (k: number) => Promise<unknown>): Promise<number[]> {
  const times: number[] = [];
  for (let k = 0; k < repeats; ++k) {
    const start = performance.now();
    await work(k);
    times.push(performance.now() - start);
  }
  return times;
}

/** On both sides at once, as the page asks. */
const both = (work: (side: Side) => Promise<unknown>) => Promise.all(sides.map(work));

async function withMesh<T>(side: number, work: (mesh: Mesh, client: Client) => Promise<T>): Promise<T> {
  const client = await createClient();
  try {
    return await work(await client.make({ shape: 'torus', nu: side, nv: side, noise: 0.1 }), client);
  } finally {
    client.close();
  }
}

const jobs = {
  kernels: (nu: number, nv: number, repeats: number, peer: boolean) =>
    ask<Row[]>(new Worker(new URL('./kernels-worker.js', import.meta.url), { type: 'module' }), {
      nu,
      nv,
      repeats,
      peer,
    }),

  core: (job: string, side: number) =>
    ask<Row[]>(new Worker(new URL('./core-worker.ts', import.meta.url), { type: 'module' }), { job, side }),

  /** From the question to the values of both sides, on the page's side of the workers. */
  pins: (side: number): Promise<Row[]> =>
    withMesh(side, async (mesh) => {
      const n = mesh.vertices;
      const pins = { vertices: [0, n >> 1], values: [0, 1] };
      const values = (of: Side) => mesh.harmonic(specs[of], pins, { side: of });
      const [first = Number.NaN] = await timed(1, () => both(values));
      const added = await timed(9, (k) => {
        pins.vertices.push(Math.floor((n * (k + 1)) / 11) + 7);
        pins.values.push((k % 3) / 2);
        return both(values);
      });
      const dragged = await timed(40, (k) => {
        pins.values[1] = 1 + k / 100;
        return both(values);
      });
      const row = (name: string, value: number): Row => ({ name, n, unit: 'ms', value });
      return [
        row('first pins', first),
        row('new pin', median(added)),
        row('new pin, slowest', Math.max(...added)),
        row('drag', median(dragged)),
        row('drag, slowest', Math.max(...dragged)),
      ];
    }),

  /** A step on both sides, positions included. */
  smoothing: (side: number): Promise<Row[]> =>
    withMesh(side, async (mesh) => {
      const options = { time: 0.1 * mesh.meanSquaredEdge };
      const rows: Row[] = [];
      for (const [name, rebuild] of [
        ['smooth fixed', false],
        ['smooth rebuilt', true],
      ] as const) {
        const step = () => both((of) => mesh.smooth(specs[of], { ...options, rebuild }, { side: of }));
        await timed(5, step);
        const times = await timed(25, step);
        rows.push({ name, n: mesh.vertices, unit: 'ms', value: median(times) });
        rows.push({ name: `${name}, shortest`, n: mesh.vertices, unit: 'ms', value: shortest(times) });
        await mesh.reset();
      }
      return rows;
    }),

  /** From nothing to the first answers of both sides. */
  starting: (side: number): Promise<Row[]> =>
    (async () => {
      const start = performance.now();
      const client = await createClient();
      const ready = performance.now() - start;
      const mesh = await client.make({ shape: 'torus', nu: side, nv: side, noise: 0.1 });
      await both((of) => mesh.weights(specs[of], { side: of }));
      const answered = performance.now() - start;
      client.close();
      const row = (name: string, value: number): Row => ({ name, n: side * side, unit: 'ms', value });
      return [row('start', ready), row('start to weights of both sides', answered)];
    })(),
};

Object.assign(globalThis, { bench: jobs });
