/** The worker's side of protocol.ts, on any port. */
import { fields, messageOf, wholeNumber } from './check.js';
import { CoreStopped, PolylapError } from './error.js';
import type { OperatorSpec } from './generated.js';
import type { CallName, FromWorker, Gives, Opened, Request, RequestOf, Source, Takes, ToWorker } from './protocol.js';
import type { Polylap, Session } from './session.js';
import type { Smoothed } from './types.js';

export interface Port {
  postMessage(message: FromWorker, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

/** Progress is for people: no more often than this, in ms. */
const progressInterval = 30;
/** How long nothing must have been asked before the solver is warmed up, in ms. */
const idleBeforeWarmUp = 50;

/** Loads the core when it is told to, says so, and answers from then on. */
export function serve(
  port: Port,
  load: (options: { module: WebAssembly.Module | undefined; whole: boolean }) => Promise<Polylap>,
): void {
  port.onmessage = ({ data }) => {
    if (data.kind !== 'start') return;
    load({ module: data.module, whole: data.whole }).then(
      (polylap) => new Server(port, polylap, data.warmUp).start(),
      (error) => fail(port, error),
    );
  };
}

function fail(port: Port, error: unknown): void {
  port.postMessage({ kind: 'failed', message: messageOf(error) }, []);
}

class Server {
  readonly #port: Port;
  readonly #polylap: Polylap;
  readonly #sessions = new Map<number, Session>();
  readonly #cold: OperatorSpec[];
  #idle: ReturnType<typeof setTimeout> | undefined;
  #asked = 0;
  #cancelled = -1;
  #lastProgress = 0;

  constructor(port: Port, polylap: Polylap, warmUp: boolean) {
    this.#port = port;
    this.#polylap = polylap;
    this.#cold = (warmUp ? polylap.operatorIds() : []).map((id) => ({ id }) as OperatorSpec);
  }

  start(): void {
    this.#port.onmessage = ({ data }) => {
      if (data.kind === 'cancel') this.#cancelled = data.id;
      else if (data.kind === 'request') void this.#handle(data.id, data.request);
    };
    this.#port.postMessage({ kind: 'ready' }, []);
    this.#warmUpWhenIdle();
  }

  async #handle(id: number, request: Request): Promise<void> {
    clearTimeout(this.#idle);
    this.#asked += 1;
    this.#lastProgress = 0;
    try {
      const value = await this.#perform(id, request);
      this.#port.postMessage({ kind: 'done', id, value }, buffersOf(value));
      this.#warmUpWhenIdle();
    } catch (error) {
      if (error instanceof CoreStopped) {
        fail(this.#port, error);
        return;
      }
      const known = error instanceof PolylapError ? error : new PolylapError('internal', messageOf(error));
      const { code, message, element, line } = known;
      this.#port.postMessage({ kind: 'error', id, error: { code, message, element, line } }, []);
      this.#warmUpWhenIdle();
    }
  }

  #perform(id: number, request: Request): Gives<CallName> | Promise<Smoothed> {
    const onProgress = (fraction: number) => this.#progress(id, fraction);
    switch (request.call) {
      case 'open':
        return this.#open(request.takes, onProgress);
      case 'adopt':
        return this.#adopt(request.takes, onProgress);
      case 'close':
        return this.#close(request.takes.mesh);
      case 'convergence':
        return this.#polylap.convergence(request.takes.spec, { onProgress });
      default:
        return this.#performOn(this.#session(request.takes.mesh), id, request, onProgress);
    }
  }

  #performOn(
    session: Session,
    id: number,
    request: RequestOf<Exclude<CallName, 'open' | 'adopt' | 'close' | 'convergence'>>,
    onProgress: (fraction: number) => undefined,
  ): Gives<CallName> | Promise<Smoothed> {
    const { call, takes } = request;
    const options = { onProgress, side: takes.side };
    switch (call) {
      case 'weights':
        return session.weights(takes.spec, options);
      case 'row':
        return session.row(takes.spec, takes.vertex, options);
      case 'face':
        return session.face(takes.spec, takes.face, options);
      case 'shape':
        return session.shape(options);
      case 'smooth':
        return this.#smooth(id, session, takes);
      case 'stability':
        return session.stability(takes.spec, takes.options, options);
      case 'harmonic':
        return session.harmonic(takes.spec, takes.fixed, options);
      case 'matrices':
        return session.matrices(takes.spec, options);
      case 'check':
        return session.check(takes.spec, options);
      case 'spectrum':
        return session.spectrum(takes.spec, takes.count, options);
      case 'energy':
        return session.energy(takes.spec, options);
      case 'dual':
        return session.dual(takes.options, options);
      case 'file':
        return session.file(takes.format, options);
      case 'convert':
        return this.#keep(takes.made, session.convert(takes.conversion, options));
      case 'reset':
        session.reset(takes.side);
        return undefined;
      case 'restore':
        session.restore(takes.saved, options);
        return undefined;
    }
  }

  #session(mesh: number): Session {
    const session = this.#sessions.get(mesh);
    if (!session) throw new PolylapError('bad-argument', 'this mesh has been closed');
    return session;
  }

  #open({ mesh, source }: Takes<'open'>, onProgress: (fraction: number) => undefined): Opened {
    return this.#keep(mesh, this.#made(source, onProgress));
  }

  #made(source: Source, onProgress: (fraction: number) => undefined): Session {
    if ('bytes' in source) return this.#polylap.open(source.bytes, source.name, { ...source.options, onProgress });
    if ('arrays' in source) return this.#polylap.fromArrays(source.arrays, { onProgress });
    return this.#polylap.make(source.spec);
  }

  #adopt({ mesh, arrays }: Takes<'adopt'>, onProgress: (fraction: number) => undefined): undefined {
    this.#close(mesh);
    this.#sessions.set(mesh, this.#polylap.fromArrays(arrays, { onProgress }));
  }

  #close(mesh: number): undefined {
    this.#sessions.get(mesh)?.close();
    this.#sessions.delete(mesh);
  }

  /** Keeps a new session once all that is to be told of it has been had. */
  #keep(mesh: number, session: Session): Opened {
    try {
      const told = { info: session.info(), geometry: session.geometry(), coordinates: session.coordinates() };
      this.#sessions.set(mesh, session);
      return told;
    } catch (error) {
      session.close();
      throw error;
    }
  }

  /** One step a call, so that a cancellation gets in between; all steps or none. */
  async #smooth(id: number, session: Session, { side, spec, options, showSteps }: Takes<'smooth'>): Promise<Smoothed> {
    const steps = wholeNumber(fields(options, 'smoothing options').steps ?? 1, 'steps', 1);
    // One step alone leaves the surface as it was if it fails.
    const before = steps > 1 ? session.surface({ side }) : undefined;
    try {
      for (let k = 0; ; ++k) {
        const onProgress = (fraction: number) => this.#progress(id, (k + fraction) / steps);
        const smoothed = session.smooth(spec, { ...options, steps: 1 }, { side, onProgress });
        this.#progress(id, (k + 1) / steps);
        if (k + 1 === steps) return smoothed;
        if (showSteps) this.#port.postMessage({ kind: 'step', id, smoothed }, buffersOf(smoothed));
        await turn();
        if (this.#cancelled === id) throw new PolylapError('cancelled', 'smoothing was cancelled');
      }
    } catch (error) {
      if (before && !(error instanceof CoreStopped)) session.restore(before, { side });
      throw error;
    }
  }

  #progress(id: number, fraction: number): undefined {
    const now = performance.now();
    if (now - this.#lastProgress < progressInterval) return;
    this.#lastProgress = now;
    this.#port.postMessage({ kind: 'progress', id, fraction }, []);
  }

  #warmUpWhenIdle(): void {
    if (this.#cold.length === 0) return;
    const warmUp = () =>
      this.#warmUp().catch((error) => {
        if (error instanceof CoreStopped) fail(this.#port, error);
      });
    this.#idle = setTimeout(warmUp, idleBeforeWarmUp);
  }

  /** The first long call of a function runs unoptimised, several times slower; better now than under someone's cursor. */
  async #warmUp(): Promise<void> {
    const asked = this.#asked;
    for (let spec = this.#cold.shift(); spec; spec = this.#cold.shift()) {
      const session = this.#polylap.make({ shape: 'grid', nx: 30, ny: 30 });
      try {
        session.smooth(spec, { time: session.info().meanSquaredEdge });
        session.harmonic(spec, { vertices: [0, 30], values: [0, 1] });
      } catch (error) {
        // Anything less than a trap will be told to whoever asks for the same.
        if (error instanceof CoreStopped) throw error;
      }
      session.close();
      await turn();
      if (this.#asked !== asked) return;
    }
  }
}

/** Lets waiting messages in. A timer would cost 4 ms each time. */
function turn(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** The memory of all arrays in a value, to hand over instead of copying. */
function buffersOf(value: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  if (typeof value !== 'object' || value === null) return [];
  return Object.values(value).flatMap(buffersOf);
}
