/** The asynchronous API: the meshes that live in the worker, and what it takes to make them again in another one. */
import { conversionParts, openOptions, ownBytes, ownOperator, runOf, shapeParts, text } from './check.js';
import type { ConversionSpec, OperatorSpec, ShapeSpec } from './generated.js';
import type { CallName, Gives, OnSide, Opened, Request, Saved, Source, Takes } from './protocol.js';
import { type Subject, type WorkerLike, WorkerQueue } from './queue.js';
import type {
  Client,
  ConvergenceStudy,
  Mesh,
  OpenOptions,
  RunOptions,
  Side,
  Smoothed,
  SmoothRunOptions,
} from './types.js';

export type { WorkerLike } from './queue.js';

export interface ClientOptions {
  /** Makes the worker that runs worker.ts; called again after a restart. */
  worker: () => WorkerLike;
}

/** @throws PolylapError `worker-failed` when the worker cannot be started */
export async function startClient(options: ClientOptions): Promise<Client> {
  const client = new WorkerClient(options);
  await client.started;
  return client;
}

/** What it takes to make a mesh again in another worker. */
interface MeshState extends Subject {
  id: number;
  source: Source;
  sides: Map<Side, Saved>;
}

type OnSideCall = { [K in CallName]: Takes<K> extends OnSide ? K : never }[CallName];
type Run = Omit<RunOptions, 'side'>;

class WorkerClient implements Client {
  onRestart?: (reason: string) => void;
  readonly #queue: WorkerQueue;
  readonly #meshes = new Map<number, MeshState>();
  #nextMesh = 0;

  constructor({ worker }: ClientOptions) {
    this.#queue = new WorkerQueue({
      worker,
      remembered: () => [...this.#meshes.values()].map((state) => [state, requestsFor(state)]),
      onRestart: (reason) => this.onRestart?.(reason),
    });
  }

  get started(): Promise<void> {
    return this.#queue.started;
  }

  async open(
    bytes: Uint8Array | ArrayBuffer | Blob | string,
    name: string,
    given: Run & OpenOptions = {},
  ): Promise<Mesh> {
    const [file, run] = [text(name, 'the name of a mesh'), runOf(given)];
    const options = openOptions(run);
    return this.#open({ bytes: await ownBytes(bytes), name: file, options }, file, run);
  }

  async make(shape: ShapeSpec, run: Run = {}): Promise<Mesh> {
    const { id, settings, noise } = shapeParts(shape);
    return this.#open({ spec: { shape: id, ...settings, noise } as ShapeSpec }, id, runOf(run));
  }

  async convergence(spec: OperatorSpec, run: Run = {}): Promise<ConvergenceStudy[]> {
    return this.#queue.call('convergence', { spec: ownOperator(spec) }, {}, { run: runOf(run) });
  }

  close(): void {
    this.#queue.close();
    this.#meshes.clear();
  }

  async #open(source: Source, name: string, run: Run): Promise<Mesh> {
    const state = this.#newState(source);
    const opened = await this.#queue.call('open', { mesh: state.id, source }, state, { run, ...this.#keeping(state) });
    return this.#mesh(state, name, opened);
  }

  #newState(source: Source): MeshState {
    return { id: this.#nextMesh++, source, sides: new Map() };
  }

  /** What to do when a new mesh is there, and when nobody wants it any more. */
  #keeping(state: MeshState) {
    return {
      commit: () => this.#meshes.set(state.id, state),
      undo: () => this.#queue.putFirst(state, { call: 'close', takes: { mesh: state.id } }),
    };
  }

  #mesh(state: MeshState, name: string, { info, geometry }: Opened): Mesh {
    const ask = <K extends OnSideCall>(
      call: K,
      takes: Omit<Takes<K>, keyof OnSide>,
      run: SmoothRunOptions,
      hooks: { commit?: (value: Gives<K>) => unknown; undo?: () => void } = {},
    ) => {
      const { side = 'a' } = run;
      const all = { mesh: state.id, side, ...takes } as unknown as Takes<K>;
      return this.#queue.call(call, all, state, { run, ...hooks });
    };
    // All are async for what they throw to become a rejection.
    return {
      ...info,
      name,
      geometry,
      weights: async (spec, run = {}) => ask('weights', { spec: ownOperator(spec) }, runOf(run)),
      shape: async (run = {}) => ask('shape', {}, runOf(run)),
      smooth: async (spec, options, given = {}) => {
        const run = runOf(given);
        const { side = 'a', onStep } = run;
        const commit = (smoothed: Smoothed) => {
          const { coordinates, step } = smoothed;
          const saved = { coordinates: coordinates.slice(), step };
          // The worker tells of all steps but the last, which is the value. If its callback throws, the step has not been.
          onStep?.(smoothed);
          state.sides.set(side, saved);
        };
        const undo = () => this.#queue.putFirst(state, backTo(state, side));
        const takes = { spec: ownOperator(spec), options, showSteps: typeof onStep === 'function' };
        return ask('smooth', takes, run, { commit, undo });
      },
      harmonic: async (spec, fixed, run = {}) => ask('harmonic', { spec: ownOperator(spec), fixed }, runOf(run)),
      matrices: async (spec, run = {}) => ask('matrices', { spec: ownOperator(spec) }, runOf(run)),
      check: async (spec, run = {}) => ask('check', { spec: ownOperator(spec) }, runOf(run)),
      dual: async (options = {}, run = {}) => ask('dual', { options }, runOf(run)),
      file: async (format, run = {}) => ask('file', { format }, runOf(run)),
      convert: async (conversion, run = {}) => {
        const { id, settings } = conversionParts(conversion);
        const own = { conversion: id, ...settings } as ConversionSpec;
        // Its source is the file that comes with it: all 17 digits, so that it can be made again as it was.
        const made = this.#newState({ bytes: new Uint8Array(), name: 'converted.obj', options: {} });
        const { commit: keep, undo } = this.#keeping(made);
        const commit = ({ file }: Gives<'convert'>) => {
          made.source = { bytes: file, name: 'converted.obj', options: {} };
          keep();
        };
        const opened = await ask('convert', { conversion: own, made: made.id }, runOf(run), { commit, undo });
        return this.#mesh(made, `${id} of ${name}`, opened);
      },
      reset: async (side) => {
        const commit = () => (side === undefined ? state.sides.clear() : state.sides.delete(side));
        return this.#queue.call('reset', { mesh: state.id, side }, state, { commit });
      },
      close: async () =>
        this.#queue.call('close', { mesh: state.id }, state, { commit: () => this.#meshes.delete(state.id) }),
    };
  }
}

/** The requests that bring a mesh into a new worker, in the order in which they are to run. */
function requestsFor(state: MeshState): Request[] {
  const open: Request = { call: 'open', takes: { mesh: state.id, source: state.source } };
  return [open, ...[...state.sides.keys()].map((side) => backTo(state, side))];
}

/** The request that puts a side where the client remembers it. */
function backTo({ id, sides }: MeshState, side: Side): Request {
  const saved = sides.get(side);
  return saved ? { call: 'restore', takes: { mesh: id, side, saved } } : { call: 'reset', takes: { mesh: id, side } };
}
