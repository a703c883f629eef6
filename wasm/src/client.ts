/**
 * The asynchronous API: two workers, one for each side, and what it takes to have a mesh in either.
 *
 * Of large meshes too: one with a million vertices takes 0.2 GB in each worker, and what a side computes on it up to 1.1 GB more; the memory of a worker
 * ends at 4 GB.
 */
import {
  badArgument,
  conversionParts,
  oneOf,
  openOptions,
  ownArrays,
  ownBytes,
  ownCopy,
  ownOperator,
  runOf,
  shapeParts,
  text,
} from './check.js';
import type { ConversionSpec, OperatorSpec, ShapeSpec } from './generated.js';
import type { CallName, OnSide, Opened, Request, Saved, Source, Takes } from './protocol.js';
import { type Hooks, type Subject, type WorkerLike, WorkerQueue } from './queue.js';
import type {
  Client,
  ConvergenceStudy,
  Mesh,
  MeshArrays,
  OpenOptions,
  RunOptions,
  Side,
  Smoothed,
  SmoothRunOptions,
} from './types.js';

export type { WorkerLike } from './queue.js';

export interface ClientOptions {
  /** Makes the worker that runs worker.ts for a side; called again after a restart. */
  worker: (side: Side) => WorkerLike;
  /** polylap-core.wasm, or the whole polylap.wasm, compiled, for all workers; without it each gets the whole by itself. */
  module?: (whole: boolean) => Promise<WebAssembly.Module>;
  /** Whether to begin with the whole; as a rule only without `module`. */
  whole?: boolean;
}

/** @throws PolylapError `worker-failed` when the worker cannot be started */
export async function startClient(options: ClientOptions): Promise<Client> {
  const client = new WorkerClient(options);
  try {
    await client.started;
  } catch (error) {
    client.close();
    throw error;
  }
  return client;
}

const sides: readonly Side[] = ['a', 'b'];

type OnSideCall = { [K in CallName]: Takes<K> extends OnSide ? K : never }[CallName];
type Run = Omit<RunOptions, 'side'>;

/** What it takes to make a mesh again in a worker: side a lives in one, side b in the other. */
class MeshState {
  arrays: MeshArrays | undefined;
  closed = false;
  readonly saved = new Map<Side, Saved>();
  /** What it is to each worker. */
  readonly on: Readonly<Record<Side, Subject>> = {
    a: { bring: () => this.#bring('a') },
    b: { bring: () => this.#bring('b') },
  };

  constructor(readonly id: number) {}

  /** The arrays of a reply are the caller's, who may change them; but for the coordinates, which only the client sees. */
  take({ geometry, coordinates }: Opened): void {
    this.arrays = { coordinates, offsets: geometry.offsets.slice(), corners: geometry.corners.slice() };
  }

  #bring(side: Side): Request[] {
    if (!this.arrays) throw new Error('this mesh has not been opened');
    const adopt: Request = { call: 'adopt', takes: { mesh: this.id, arrays: this.arrays } };
    return this.saved.has(side) ? [adopt, this.backTo(side)] : [adopt];
  }

  /** The request that puts a side where the client remembers it. */
  backTo(side: Side): Request {
    const saved = this.saved.get(side);
    return saved
      ? { call: 'restore', takes: { mesh: this.id, side, saved } }
      : { call: 'reset', takes: { mesh: this.id, side } };
  }
}

class WorkerClient implements Client {
  onRestart?: (reason: string, side: Side) => unknown;
  onLoading?: (loading: boolean) => unknown;
  readonly #queues: Readonly<Record<Side, WorkerQueue>>;
  readonly #modules = new Map<boolean, Promise<WebAssembly.Module>>();
  #nextMesh = 0;

  constructor({ worker, module: compile, whole: fromTheStart = !compile }: ClientOptions) {
    const module = async (whole: boolean) => {
      if (!compile) return undefined;
      const made = this.#modules.get(whole) ?? compile(whole);
      this.#modules.set(whole, made);
      // What went wrong may go right for the next worker.
      made.catch(() => this.#modules.get(whole) === made && this.#modules.delete(whole));
      return made;
    };
    const queue = (side: Side) =>
      new WorkerQueue({
        worker: () => worker(side),
        module,
        whole: fromTheStart,
        // Of one module, machine code is optimised for all its instances.
        warmUp: side === 'a' || !compile,
        onRestart: (reason) => this.onRestart?.(reason, side),
        onLoading: (loading) => this.onLoading?.(loading),
      });
    this.#queues = { a: queue('a'), b: queue('b') };
  }

  get started(): Promise<void> {
    return this.#queues.a.started;
  }

  async open(
    bytes: Uint8Array | ArrayBuffer | Blob | string,
    name: string,
    given: Run & OpenOptions = {},
  ): Promise<Mesh> {
    const [file, run] = [text(name, 'the name of a mesh'), runOf(given)];
    const options = openOptions(run);
    const own = await ownBytes(bytes);
    return this.#open({ bytes: own, name: file, options }, file, run, [own.buffer]);
  }

  async make(shape: ShapeSpec, run: Run = {}): Promise<Mesh> {
    const { id, settings, noise } = shapeParts(shape);
    return this.#open({ spec: { shape: id, ...settings, noise } as ShapeSpec }, id, runOf(run));
  }

  async fromArrays(arrays: MeshArrays, name: string, run: Run = {}): Promise<Mesh> {
    return this.#open({ arrays: ownCopy(ownArrays(arrays)) }, text(name, 'the name of a mesh'), runOf(run));
  }

  async convergence(spec: OperatorSpec, run: Run = {}): Promise<ConvergenceStudy[]> {
    return this.#queues[this.#freeSide()].call(
      'convergence',
      { spec: ownOperator(spec) },
      { run: runOf(run), needsWhole: true },
    );
  }

  close(): void {
    for (const queue of Object.values(this.#queues)) queue.close();
  }

  /** Where there is nothing to wait for, if anywhere. */
  #freeSide(): Side {
    return this.#queues.b.idle && !this.#queues.a.idle ? 'b' : 'a';
  }

  async #open(source: Source, name: string, run: Run, transfer: Transferable[] = []): Promise<Mesh> {
    const state = new MeshState(this.#nextMesh++);
    const side = this.#freeSide();
    const takes = { mesh: state.id, source };
    const opened = await this.#queues[side].call('open', takes, {
      run,
      transfer,
      needsWhole: 'bytes' in source,
      ...this.#keeping(state, side),
    });
    return this.#mesh(state, name, opened);
  }

  /** What to do when a new mesh is there, and when nobody wants it any more. */
  #keeping(state: MeshState, side: Side) {
    return {
      commit: (opened: Opened) => {
        state.take(opened);
        this.#queues[side].has(state.on[side]);
      },
      undo: (): Request => ({ call: 'close', takes: { mesh: state.id } }),
    };
  }

  /** A request that is void in a worker without the mesh, in both. */
  async #everywhere(state: MeshState, sides: readonly Side[], call: 'reset' | 'close'): Promise<undefined> {
    const one = (side: Side) =>
      this.#queues[side].call(
        call,
        { mesh: state.id, side },
        {
          subject: state.on[side],
          onlyIfThere: true,
          commit: () => {
            state.saved.delete(side);
            if (call === 'close') this.#queues[side].forget(state.on[side]);
          },
        },
      );
    await Promise.all(sides.map(one));
  }

  #mesh(state: MeshState, name: string, { info, geometry }: Opened): Mesh {
    const ask = async <K extends OnSideCall>(
      call: K,
      takes: Omit<Takes<K>, keyof OnSide>,
      run: SmoothRunOptions,
      hooks: Pick<Hooks<K>, 'commit' | 'undo' | 'needsWhole' | 'urgent'> = {},
    ) => {
      if (state.closed) throw badArgument('this mesh has been closed');
      const { side = 'a' } = run;
      const all = { mesh: state.id, side, ...takes } as unknown as Takes<K>;
      return this.#queues[side].call(call, all, { subject: state.on[side], run, ...hooks });
    };
    // All are async for what they throw to become a rejection.
    return {
      ...info,
      name,
      geometry,
      weights: async (spec, run = {}) => ask('weights', { spec: ownOperator(spec) }, runOf(run)),
      row: async (spec, vertex, run = {}) =>
        ask('row', { spec: ownOperator(spec), vertex }, runOf(run), { urgent: true }),
      face: async (spec, face, run = {}) =>
        ask('face', { spec: ownOperator(spec), face }, runOf(run), { urgent: true }),
      shape: async (run = {}) => ask('shape', {}, runOf(run)),
      smooth: async (spec, options, given = {}) => {
        const run = runOf(given);
        const { side = 'a', onStep } = run;
        const commit = (smoothed: Smoothed) => {
          const { coordinates, step } = smoothed;
          const saved = { coordinates: coordinates.slice(), step };
          // The worker tells of all steps but the last, which is the value. If its callback throws, the step has not been.
          onStep?.(smoothed);
          state.saved.set(side, saved);
        };
        const takes = { spec: ownOperator(spec), options, showSteps: typeof onStep === 'function' };
        return ask('smooth', takes, run, { commit, undo: () => state.backTo(side) });
      },
      stability: async (spec, options = {}, run = {}) =>
        ask('stability', { spec: ownOperator(spec), options }, runOf(run)),
      harmonic: async (spec, fixed, run = {}) => ask('harmonic', { spec: ownOperator(spec), fixed }, runOf(run)),
      matrices: async (spec, run = {}) => ask('matrices', { spec: ownOperator(spec) }, runOf(run)),
      check: async (spec, run = {}) => ask('check', { spec: ownOperator(spec) }, runOf(run), { needsWhole: true }),
      spectrum: async (spec, count, run = {}) =>
        ask('spectrum', { spec: ownOperator(spec), count }, runOf(run), { needsWhole: true }),
      energy: async (spec, run = {}) => ask('energy', { spec: ownOperator(spec) }, runOf(run)),
      dual: async (options = {}, run = {}) => ask('dual', { options }, runOf(run), { needsWhole: true }),
      file: async (format, run = {}) => ask('file', { format }, runOf(run), { needsWhole: true }),
      convert: async (conversion, given = {}) => {
        const { id, settings } = conversionParts(conversion);
        const run = runOf(given);
        const own = { conversion: id, ...settings } as ConversionSpec;
        const made = new MeshState(this.#nextMesh++);
        const hooks = { ...this.#keeping(made, run.side ?? 'a'), needsWhole: true };
        const opened = await ask('convert', { conversion: own, made: made.id }, run, hooks);
        return this.#mesh(made, `${id} of ${name}`, opened);
      },
      restore: async (given, run = {}) => {
        const { coordinates, step } = given;
        const saved = { coordinates: Float64Array.from(coordinates), step };
        const { side = 'a' } = run;
        const hooks = { commit: () => state.saved.set(side, saved), undo: () => state.backTo(side) };
        await ask('restore', { saved }, runOf(run), hooks);
      },
      reset: async (side) =>
        this.#everywhere(state, side === undefined ? sides : [oneOf(side, sides, 'the side')], 'reset'),
      close: async () => {
        state.closed = true;
        return this.#everywhere(state, sides, 'close');
      },
    };
  }
}
