/**
 * The client's queue of requests, and the life of its worker.
 *
 * The queue lives here and one request is under way at a time, so that a request which has not started can be dropped, and a new worker can go on
 * where the old one ended: from what the client remembers.
 */
import { messageOf, ownCopy } from './check.js';
import { PolylapError } from './error.js';
import type { CallName, FromWorker, Gives, Request, Takes, ToWorker } from './protocol.js';
import type { SmoothRunOptions } from './types.js';

/** What the client needs of a Worker; it sets the handlers. */
export interface WorkerLike {
  postMessage(message: unknown): void;
  terminate(): void;
  onmessage: ((event: never) => void) | null;
  onerror: ((event: never) => void) | null;
  onmessageerror: ((event: never) => void) | null;
}

/** How long a running request may take to stop before the worker is ended, in ms. */
const cancelGrace = 300;
/** A worker that fails so often in a row without having been asked for anything is given up. */
const startAttempts = 3;

/** What requests work on: a mesh, or nothing that could be lost. */
export interface Subject {
  /** Why it could not be taken over by another worker. */
  lost?: PolylapError;
}

interface Hooks<K extends CallName> {
  run?: SmoothRunOptions;
  /** Takes the value into the client's memory before the caller sees it. */
  commit?: (value: Gives<K>) => unknown;
  undo?: () => void;
}

export interface QueueOptions {
  /** Makes the worker that runs worker.ts; called again after a restart. */
  worker: () => WorkerLike;
  /** What brings a new worker to where the last one was. */
  remembered: () => Iterable<[Subject, Request[]]>;
  onRestart: (reason: string) => void;
}

/** A request on its way through the queue. */
interface Job {
  id: number;
  request: Request;
  subject: Subject;
  run: SmoothRunOptions;
  /** A request of the client's own, to bring a worker into the state that the client remembers. */
  internal: boolean;
  /** Set when it was cancelled, or when a callback threw: with what to reject it. */
  stopped?: { error: unknown };
  /** Takes the value in before the caller sees it; nobody can cancel any more. */
  commit: (value: never) => void;
  resolve: (value: never) => void;
  reject: (error: unknown) => void;
  /** Makes the worker forget what a request did that was cancelled too late. */
  undo?: () => void;
}

const cancelled = () => new PolylapError('cancelled', 'cancelled');
const closed = () => new PolylapError('cancelled', 'the client has been closed');

export class WorkerQueue {
  readonly started: Promise<void>;

  readonly #makeWorker: QueueOptions['worker'];
  readonly #remembered: QueueOptions['remembered'];
  readonly #onRestart: QueueOptions['onRestart'];
  #worker: WorkerLike | undefined;
  #ready = false;
  #started: { resolve: () => void; reject: (error: PolylapError) => void } | undefined;
  /** Set for good once the queue is closed or given up. */
  #ended: (() => PolylapError) | undefined;
  #restartReason: string | undefined;
  #failures = 0;
  #queue: Job[] = [];
  #current: Job | undefined;
  #grace: ReturnType<typeof setTimeout> | undefined;
  #nextId = 0;

  constructor({ worker, remembered, onRestart }: QueueOptions) {
    this.#makeWorker = worker;
    this.#remembered = remembered;
    this.#onRestart = onRestart;
    this.started = new Promise((resolve, reject) => {
      this.#started = { resolve, reject };
    });
    this.#start();
  }

  close(): void {
    this.#end(closed);
  }

  async call<K extends CallName>(
    call: K,
    takes: Takes<K>,
    subject: Subject,
    { run = {}, commit, undo }: Hooks<K> = {},
  ): Promise<Gives<K>> {
    // The caller may change the arguments while the request waits. A source is the client's own already, and may be large.
    const request = { call, takes: 'source' in takes ? takes : ownCopy(takes) } as Request;
    return new Promise((resolve, reject) => {
      if (this.#ended) return reject(this.#ended());
      if (run.signal?.aborted) return reject(cancelled());
      const onAbort = () => this.#cancel(job, cancelled());
      run.signal?.addEventListener('abort', onAbort, { once: true });
      const forget = () => run.signal?.removeEventListener('abort', onAbort);
      const job: Job = {
        id: this.#nextId++,
        request,
        subject,
        run,
        internal: false,
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
      this.#queue.push(job);
      this.#sendNext();
    });
  }

  /** Puts requests of the client's own at the head of the queue. A mesh that it fails on is lost. */
  putFirst(subject: Subject, ...requests: Request[]): void {
    const jobs = requests.map((request): Job => {
      const reject = (error: unknown) => {
        subject.lost ??= error as PolylapError;
      };
      const nothing = () => {};
      return {
        id: this.#nextId++,
        request,
        subject,
        run: {},
        internal: true,
        commit: nothing,
        resolve: nothing,
        reject,
      };
    });
    this.#queue.unshift(...jobs);
  }

  #sendNext(): void {
    while (this.#ready && !this.#current) {
      const job = this.#queue.shift();
      if (!job?.internal) this.#tellRestart();
      if (!job) return;
      if (job.subject.lost && job.request.call !== 'close') {
        job.reject(job.subject.lost);
        continue;
      }
      this.#current = job;
      try {
        this.#send({ kind: 'request', id: job.id, request: job.request });
      } catch (error) {
        this.#current = undefined;
        // They could be copied once; what is missing is room for another copy.
        job.reject(new PolylapError('out-of-memory', `the arguments cannot be sent: ${messageOf(error)}`));
      }
    }
  }

  #send(message: ToWorker): void {
    this.#worker?.postMessage(message);
  }

  #cancel(job: Job, error: unknown): void {
    if (job !== this.#current) {
      this.#queue = this.#queue.filter((other) => other !== job);
      job.reject(error);
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
    if (job?.id !== id || job.stopped) return;
    try {
      callback(job.run);
    } catch (error) {
      if (job === this.#current) this.#cancel(job, error);
    }
  }

  #settle(reply: Extract<FromWorker, { kind: 'done' | 'error' }>): void {
    const job = this.#current;
    if (job?.id !== reply.id) return;
    if (!job.internal) this.#failures = 0;
    if (reply.kind === 'done' && !job.stopped) {
      // The job stays the current one meanwhile: nothing may be sent before it is known whether it must be undone.
      try {
        job.commit(reply.value as never);
      } catch (error) {
        job.stopped = { error };
      }
      if (job !== this.#current) return;
    }
    this.#current = undefined;
    clearTimeout(this.#grace);
    if (job.stopped) {
      if (reply.kind === 'done') job.undo?.();
      job.reject(job.stopped.error);
    } else if (reply.kind === 'done') {
      job.resolve(reply.value as never);
    } else {
      const { code, message, element, line } = reply.error;
      job.reject(new PolylapError(code as PolylapError['code'], message, element, line));
    }
  }

  // ---- The worker's life ----

  #start(): void {
    this.#ready = false;
    try {
      const worker = this.#makeWorker();
      const ifCurrent = (work: () => void) => worker === this.#worker && work();
      this.#worker = worker;
      worker.onmessage = ({ data }: { data: FromWorker }) => ifCurrent(() => this.#receive(data));
      worker.onerror = (event: { message?: string }) =>
        ifCurrent(() => this.#onDeath(event.message || 'it could not be loaded or ended'));
      worker.onmessageerror = () => ifCurrent(() => this.#onDeath('a message could not be read'));
    } catch (error) {
      queueMicrotask(() => this.#onDeath(messageOf(error)));
    }
  }

  /** A fresh worker: bring it to where the last one was, then go on with the queue. */
  #onReady(): void {
    this.#ready = true;
    this.#started?.resolve();
    this.#started = undefined;
    for (const [subject, requests] of this.#remembered()) if (!subject.lost) this.putFirst(subject, ...requests);
    this.#sendNext();
  }

  /** Called when a worker has nothing left of the client's own to do: it is up again. */
  #tellRestart(): void {
    const reason = this.#restartReason;
    this.#restartReason = undefined;
    if (reason !== undefined) queueMicrotask(() => this.#onRestart(reason));
  }

  #onDeath(why: string): void {
    if (this.#ended) return;
    const failure = () => new PolylapError('worker-failed', `the worker failed: ${why}`);
    // Whose fault is it? A user's request is not tried again; without one, the worker itself does not work.
    if (!this.#current || this.#current.internal) this.#failures += 1;
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
    this.#queue = this.#queue.filter(({ internal }) => !internal);
    this.#start();
    if (job && !job.internal) job.reject(job.stopped ? job.stopped.error : error);
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
    for (const job of jobs) if (!job.internal) job.reject(error());
  }

  #dropWorker(): void {
    this.#ready = false;
    this.#worker?.terminate();
    this.#worker = undefined;
  }
}
