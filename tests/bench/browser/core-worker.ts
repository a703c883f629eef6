/** The core in a worker of its own, timed from inside: what a call takes there, and the memory that it leaves behind. */
import { load } from '../../../wasm/src/load.js';
import type { Polylap, Session } from '../../../wasm/src/session.js';
import type { Row } from './page.js';

const spec = { id: 'alexa-wardetzky' } as const;

class Recorder {
  readonly rows: Row[] = [];
  constructor(
    readonly n: number,
    readonly polylap: Polylap,
  ) {}

  add(name: string, value: number, unit = 'ms'): void {
    this.rows.push({ name, n: this.n, unit, value });
  }

  time<T>(name: string, work: () => T): T {
    const start = performance.now();
    const value = work();
    this.add(name, performance.now() - start);
    return value;
  }

  /** It never shrinks: the largest so far. */
  heap(name: string): void {
    this.add(name, this.polylap.memory() / 1e6, 'MB');
  }
}

/** What the worker does with the bytes of a file, until a mesh can be shown. */
function open(polylap: Polylap, bytes: Uint8Array): Session {
  const session = polylap.open(bytes, 'torus.obj');
  session.info();
  session.geometry();
  session.coordinates();
  return session;
}

const jobs = {
  /** OBJ bytes to what a viewer needs, first and again. */
  async loading(side: number): Promise<Row[]> {
    const writer = await load();
    const bytes = writer.make({ shape: 'torus', nu: side, nv: side }).file('obj');
    // The writer has optimised nothing of the reader; another instance is as cold as the page's.
    const polylap = await load();
    const record = new Recorder(side * side, polylap);
    const corners = 4 * side * side;
    for (const name of ['OBJ, first', 'OBJ']) {
      const start = performance.now();
      open(polylap, bytes).close();
      record.add(name, performance.now() - start);
      record.add(`${name}, per corner`, ((performance.now() - start) * 1000) / corners, 'µs');
    }
    record.heap('OBJ heap');
    return record.rows;
  },

  /** A mesh as large as it gets: everything that the page asks of a side, then a step and a harmonic function. */
  async largest(side: number): Promise<Row[]> {
    const polylap = await load();
    for (let k = 0; k < 3; ++k) {
      const warm = polylap.make({ shape: 'torus', nu: 60, nv: 60 });
      warm.smooth(spec, { time: 1e-3, steps: 3 });
      warm.close();
    }
    const record = new Recorder(side * side, polylap);
    const session = record.time('make', () => polylap.make({ shape: 'torus', nu: side, nv: side, noise: 0.1 }));
    record.time('geometry', () => [session.info(), session.geometry(), session.coordinates()]);
    record.heap('heap, opened');
    record.time('area and volume', () => session.shape());
    record.time('weights', () => session.weights(spec));
    record.heap('heap, weights');
    const { meanSquaredEdge } = session.info();
    // So long that it takes a factor.
    const time = 1e4 * meanSquaredEdge;
    record.time('smoothing step, first', () => session.smooth(spec, { time }));
    record.heap('heap');
    record.time('smoothing step', () => session.smooth(spec, { time }));
    record.time('small smoothing step', () => session.smooth(spec, { time: meanSquaredEdge }));
    record.heap('heap, three steps');
    const pins = { vertices: [0, (side * side) >> 1], values: [0, 1] };
    record.time('harmonic', () => session.harmonic(spec, pins));
    record.heap('heap, harmonic as well');
    return record.rows;
  },
};

addEventListener('message', async ({ data: { job, side } }: MessageEvent<{ job: keyof typeof jobs; side: number }>) => {
  try {
    postMessage(await jobs[job](side));
  } catch (error) {
    postMessage(String(error));
  }
});
