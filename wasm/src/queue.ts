/**
 * The client's queue of requests to one of its workers, and that worker's life.
 *
 * The queue lives here and one request is under way at a time, so that a request which has not started can be dropped, and a new worker can go on
 * where the old one ended: meshes come into a worker when something is first asked about them there.
 */
import { messageOf, ownCopy } from './check.js';
import { PolylapError } from './error.js';
import type { CallName, FromWorker, Gives, Request, Takes, ToWorker } from './protocol.js';
import type { SmoothRunOptions } from './types.js';

/** What the client needs of a Worker; it sets the handlers. */
export interface WorkerLike {
  postMessage(message: unknown, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: never) => void) | null;
  onerror: ((event: never) => void) | null;
  onmessageerror: ((event: never) => void) | null;
}

/** How long a running request may take to stop before the worker is ended, in ms. */
const cancelGrace = 300;
/** A worker that fails so often in a row without having been asked for anything is given up. */
const startAttempts = 3;

/** What requests work on, and what brings it into a worker that does not have it. */
export interface Subject {
  bring(): Request[];
}

export interface Hooks<K extends CallName> {
  /** None: the request needs nothing in the worker. */
  subject?: Subject;
  /** The request is void where the subject is not in the worker. */
  onlyIfThere?: boolean;
  /** Only the whole core can do it. What else turns out to need it is asked again there. */
  needsWhole?: boolean;
  /** Somebody looks at where the answer will be: it goes before what has not been sent yet. */
  urgent?: boolean;
  run?: SmoothRunOptions;
  /** Memory in the arguments that the client gives up. */
  transfer?: Transferable[];
  /** Takes the value into the client's memory before the caller sees it. */
  commit?: (value: Gives<K>) => unknown;
  /** What makes the worker forget what a request did that was cancelled too late. */
  undo?: () => Request;
}

export interface QueueOptions {
  /** Makes the worker that runs worker.ts; called again after a restart. */
  worker: () => WorkerLike;
  /** The core, compiled once for all workers; undefined: the worker is to get it by itself. */
  module: (whole: boolean) => Promise<WebAssembly.Module | undefined>;
  /** Whether to begin with the whole core. */
  whole: boolean;
  /** Whether the worker is to warm the solver up. */
  warmUp: boolean;
  onRestart: (reason: string) => void;
  /** The whole core is being fetched, or no longer. */
  onLoading: (loading: boolean) => void;
}

/** A request on its way through the queue. */
interface Job {
  id: number;
  request: Request;
  /** What is to be sent before it. */
  first: Request[];
  sent: boolean;
  subject?: Subject;
  onlyIfThere: boolean;
  needsWhole: boolean;
  transfer: Transferable[];
  run: SmoothRunOptions;
  /** Set when it was cancelled, or when a callback threw: with what to reject it. */
  stopped?: { error: unknown };
  /** Takes the value in before the caller sees it; nobody can cancel any more. */
  commit: (value: never) => void;
  resolve: (value: never) => void;
  reject: (error: unknown) => void;
  undo?: () => Request;
}

const cancelled = () => new PolylapError('cancelled', 'cancelled');
const closed = () => new PolylapError('cancelled', 'the client has been closed');

export class WorkerQueue {
  readonly started: Promise<void>;

  readonly #options: QueueOptions;
  #worker: WorkerLike | undefined;
  #ready = false;
  #whole: boolean;
  #started: { resolve: () => void; reject: (error: PolylapError) => void } | undefined;
  /** Set for good once the queue is closed or given up. */
  #ended: (() => PolylapError) | undefined;
  #restartReason: string | undefined;
  #failures = 0;
  /** What the worker has. */
  readonly #there = new Set<Subject>();
  #queue: Job[] = [];
  #current: Job | undefined;
  #grace: ReturnType<typeof setTimeout> | undefined;
  #nextId = 0;

  constructor(options: QueueOptions) {
    this.#options = options;
    this.#whole = options.whole;
    this.started = new Promise((resolve, reject) => {
      this.#started = { resolve, reject };
    });
    // Whoever asks for something will be told.
    this.started.catch(() => {});
    this.#start();
  }

  /** Whether a request would be sent at once. */
  get idle(): boolean {
    return this.#ready && !this.#current;
  }

  close(): void {
    this.#end(closed);
  }

  /** Says that the worker has something now. */
  has(subject: Subject): void {
    this.#there.add(subject);
  }

  forget(subject: Subject): void {
    this.#there.delete(subject);
  }

  async call<K extends CallName>(
    call: K,
    takes: Takes<K>,
    {
      subject,
      onlyIfThere = false,
      needsWhole = false,
      urgent = false,
      run = {},
      transfer = [],
      commit,
      undo,
    }: Hooks<K> = {},
  ): Promise<Gives<K>> {
    // The caller may change the arguments while the request waits. A source is the client's own already, and may be large.
    const request = { call, takes: 'source' in takes ? takes : ownCopy(takes) } as Request;
    return new Promise((resolve, reject) => {
      if (this.#ended) return reject(this.#ended());
      if (run.signal?.aborted) return reject(cancelled());
      const isVoid = onlyIfThere && subject && !this.#there.has(subject);
      if (isVoid && !this.#current && this.#queue.length === 0) {
        commit?.(undefined as Gives<K>);
        return resolve(undefined as Gives<K>);
      }
      const onAbort = () => this.#cancel(job, cancelled());
      run.signal?.addEventListener('abort', onAbort, { once: true });
      const forget = () => run.signal?.removeEventListener('abort', onAbort);
      const job: Job = {
        id: this.#nextId++,
        request,
        first: [],
        sent: false,
        ...(subject && { subject }),
        onlyIfThere,
        needsWhole,
        transfer,
        run,
        commit: (value: Gives<K>) => {
          forget();
          commit?.(value);
        },
        resolve,
        reject: (error) => {
          forget();
          reject(error);
        },
        ...(undo && { undo }),
      };
      if (urgent) this.#queue.unshift(job);
      else this.#queue.push(job);
      this.#sendNext();
    });
  }

  #sendNext(): void {
    while (this.#ready && !this.#current) {
      const job = this.#queue.shift();
      if (!job) return;
      this.#current = job;
      const there = !job.subject || this.#there.has(job.subject);
      if (job.needsWhole && !this.#whole) void this.#getWhole(job);
      else if (there) this.#sendPart(job);
      else if (job.onlyIfThere) this.#settle({ kind: 'done', id: job.id, value: undefined });
      else {
        job.first = job.subject?.bring() ?? [];
        this.#sendPart(job);
      }
    }
  }

  /** Sends what is next of a job: what its subject needs to be there, or the request itself. */
  #sendPart(job: Job): void {
    const [request = job.request] = job.first;
    job.sent = true;
    try {
      this.#send({ kind: 'request', id: job.id, request }, request === job.request ? job.transfer : []);
    } catch (error) {
      this.#current = undefined;
      // They could be copied once; what is missing is room for another copy.
      job.reject(new PolylapError('out-of-memory', `the arguments cannot be sent: ${messageOf(error)}`));
    }
  }

  #send(message: ToWorker, transfer: Transferable[] = []): void {
    this.#worker?.postMessage(message, transfer);
  }

  #cancel(job: Job, error: unknown): void {
    if (job !== this.#current || !job.sent) {
      this.#queue = this.#queue.filter((other) => other !== job);
      if (job === this.#current) this.#current = undefined;
      job.reject(error);
      this.#sendNext();
      return;
    }
    if (job.stopped) return;
    job.stopped = { error };
    this.#send({ kind: 'cancel', id: job.id });
    this.#grace = setTimeout(() => this.#restart('cancelled', cancelled()), cancelGrace);
  }

  #receive(message: FromWorker): void {
    switch (message.kind) {
      case 'ready':
        this.#onReady();
        break;
      case 'failed':
        this.#onDeath(message.message);
        break;
      case 'progress':
        this.#tell(message.id, (run) => run.onProgress?.(message.fraction));
        break;
      case 'step':
        this.#tell(message.id, (run) => run.onStep?.(message.smoothed));
        break;
      default:
        this.#settle(message);
        this.#sendNext();
    }
  }

  /** Tells the caller how the request gets on; it ends with what the callback throws. */
  #tell(id: number, callback: (run: SmoothRunOptions) => void): void {
    const job = this.#current;
    if (job?.id !== id || job.stopped || job.first.length > 0) return;
    try {
      callback(job.run);
    } catch (error) {
      if (job === this.#current) this.#cancel(job, error);
    }
  }

  #settle(reply: Extract<FromWorker, { kind: 'done' | 'error' }>): void {
    const job = this.#current;
    if (job?.id !== reply.id) {
      // Something could not be undone: nothing there is known to be as it should.
      if (reply.kind === 'error') this.#there.clear();
      return;
    }
    this.#failures = 0;
    const bringing = job.first.length > 0;
    if (bringing && reply.kind === 'done' && !job.stopped) {
      job.first.shift();
      if (job.first.length === 0 && job.subject) this.#there.add(job.subject);
      this.#sendPart(job);
      return;
    }
    if (reply.kind === 'done' && !job.stopped) {
      // The job stays the current one meanwhile: nothing may be sent before it is known whether it must be undone.
      try {
        job.commit(reply.value as never);
      } catch (error) {
        job.stopped = { error };
      }
      if (job !== this.#current) return;
    }
    if (reply.kind === 'error' && reply.error.code === 'not-included' && !this.#whole && !job.stopped) {
      job.sent = false;
      void this.#getWhole(job);
      return;
    }
    this.#current = undefined;
    clearTimeout(this.#grace);
    if (job.stopped) {
      if (reply.kind === 'done' && !bringing && job.undo) this.#undo(job.undo());
      job.reject(job.stopped.error);
    } else if (reply.kind === 'done') {
      job.resolve(reply.value as never);
    } else {
      const { code, message, element, line } = reply.error;
      // The memory of a core never shrinks: what it took in vain only goes with it.
      if (code === 'out-of-memory') this.#renew();
      job.reject(new PolylapError(code as PolylapError['code'], message, element, line));
    }
  }

  /** Nobody waits for the answer: the worker takes one message after the other. */
  #undo(request: Request): void {
    try {
      this.#send({ kind: 'request', id: this.#nextId++, request });
    } catch {
      this.#there.clear();
    }
  }

  // ---- The worker's life ----

  #start(): void {
    this.#ready = false;
    this.#there.clear();
    const { worker: make, module, warmUp } = this.#options;
    const whole = this.#whole;
    try {
      const worker = make();
      const ifCurrent = (work: () => void) => worker === this.#worker && work();
      this.#worker = worker;
      worker.onmessage = ({ data }: { data: FromWorker }) => ifCurrent(() => this.#receive(data));
      worker.onerror = (event: { message?: string }) =>
        ifCurrent(() => this.#onDeath(event.message || 'it could not be loaded or ended'));
      worker.onmessageerror = () => ifCurrent(() => this.#onDeath('a message could not be read'));
      module(whole).then(
        (compiled) => ifCurrent(() => this.#send({ kind: 'start', module: compiled, whole, warmUp })),
        (error) => ifCurrent(() => this.#onDeath(messageOf(error))),
      );
    } catch (error) {
      queueMicrotask(() => this.#onDeath(messageOf(error)));
    }
  }

  /** The worker goes on until there is something to start another one with. */
  async #getWhole(job: Job): Promise<void> {
    this.#options.onLoading(true);
    try {
      await this.#options.module(true);
    } catch (error) {
      if (job !== this.#current) return;
      this.#current = undefined;
      job.reject(new PolylapError('worker-failed', `a part of the core could not be loaded: ${messageOf(error)}`));
      this.#sendNext();
      return;
    } finally {
      this.#options.onLoading(false);
    }
    if (job !== this.#current) return;
    this.#current = undefined;
    this.#whole = true;
    this.#queue.unshift(job);
    this.#renew();
  }

  #renew(): void {
    this.#dropWorker();
    this.#start();
  }

  #onReady(): void {
    this.#ready = true;
    this.#started?.resolve();
    this.#started = undefined;
    const reason = this.#restartReason;
    this.#restartReason = undefined;
    if (reason !== undefined) queueMicrotask(() => this.#options.onRestart(reason));
    this.#sendNext();
  }

  #onDeath(why: string): void {
    if (this.#ended) return;
    const failure = () => new PolylapError('worker-failed', `the worker failed: ${why}`);
    // Whose fault is it? A user's request is not tried again; without one, the worker itself does not work.
    if (!this.#current) this.#failures += 1;
    if (this.#failures >= startAttempts) this.#end(failure);
    else this.#restart(failure().message, failure());
  }

  /** Ends the worker and starts another. @param error for the request under way; the others stay in the queue */
  #restart(reason: string, error: PolylapError): void {
    clearTimeout(this.#grace);
    this.#dropWorker();
    this.#restartReason ??= reason;
    const job = this.#current;
    this.#current = undefined;
    this.#start();
    if (!job) return;
    if (job.onlyIfThere && !job.stopped) {
      // What it was about went with the worker.
      job.commit(undefined as never);
      job.resolve(undefined as never);
    } else job.reject(job.stopped ? job.stopped.error : error);
  }

  #end(error: () => PolylapError): void {
    if (this.#ended) return;
    this.#ended = error;
    clearTimeout(this.#grace);
    this.#dropWorker();
    this.#started?.reject(error());
    this.#started = undefined;
    const jobs = this.#current ? [this.#current, ...this.#queue] : this.#queue;
    this.#current = undefined;
    this.#queue = [];
    for (const job of jobs) job.reject(error());
  }

  #dropWorker(): void {
    this.#ready = false;
    this.#worker?.terminate();
    this.#worker = undefined;
  }
}
