import type { Side } from './polylap.js';
import type { Busy } from './results.js';
import { t } from './words.js';

interface Job {
  label: string;
  side: Side | null;
  controller: AbortController;
  fraction: number | null;
  started: number;
  unwanted: boolean;
}

export interface Run {
  signal: AbortSignal;
  onProgress: (fraction: number) => void;
}

/** Work shorter than this is not announced. */
const patience = 150;
/** What has begun is worth stopping only if it would go on for longer: its worker may have to be started again, and has to be told the mesh. */
const worthStopping = 1500;

/** Everything the workers are doing for the page: announced when it takes long, cancelled together. */
export class Work {
  private readonly jobs = new Set<Job>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private announced = false;
  private waits = false;

  constructor(private readonly announce: (busy: Busy | null) => void) {}

  /** @param side whose worker does it, where it is known */
  async run<T>(label: string, job: (run: Run) => Promise<T>, side: Side | null = null): Promise<T> {
    const entry: Job = {
      label,
      side,
      controller: new AbortController(),
      fraction: null,
      started: performance.now(),
      unwanted: false,
    };
    this.jobs.add(entry);
    this.timer ??= setTimeout(() => {
      this.announced = true;
      this.tell();
    }, patience);
    const onProgress = (fraction: number) => {
      entry.fraction = fraction;
      if (this.announced) this.tell();
    };
    try {
      return await job({ signal: entry.controller.signal, onProgress });
    } catch (reason) {
      throw entry.unwanted && isCancelled(reason) ? new Unwanted() : reason;
    } finally {
      this.jobs.delete(entry);
      if (this.announced || this.jobs.size === 0) this.tell();
    }
  }

  /** Whether what is under way waits for more of the core to come. */
  set loading(loading: boolean) {
    this.waits = loading;
    if (this.announced) this.tell();
  }

  get idle(): boolean {
    return this.jobs.size === 0;
  }

  cancel(): void {
    for (const job of this.jobs) job.controller.abort();
  }

  /** Nobody waits for what is under way any more. */
  makeWay(): void {
    for (const job of [...this.jobs]) this.drop(job);
  }

  /** Somebody waits for a newer answer of that label. */
  supersede(label: string): void {
    for (const job of [...this.jobs]) if (job.label === label) this.drop(job);
  }

  /** A worker takes one request after the other: what is not the first of its side has not begun, and costs nothing to leave. */
  private drop(job: Job): void {
    if (!this.jobs.has(job)) return;
    job.unwanted = true;
    const [first] = [...this.jobs].filter(({ side }) => side === job.side);
    if (job !== first || remaining(job) > worthStopping) job.controller.abort();
    else setTimeout(() => this.drop(job), worthStopping / 3);
  }

  private tell(): void {
    const first = this.jobs.values().next().value;
    if (first) {
      this.announce(
        this.waits
          ? { label: t('Loading what this takes'), fraction: null }
          : { label: first.label, fraction: first.fraction },
      );
      return;
    }
    clearTimeout(this.timer);
    this.timer = undefined;
    this.announced = false;
    this.announce(null);
  }
}

/** In ms: at the pace so far, or as long again. */
function remaining({ started, fraction }: Job): number {
  const passed = performance.now() - started;
  return fraction ? (passed * (1 - fraction)) / fraction : passed;
}

/** What was cancelled for the sake of something newer: not worth a word. */
export class Unwanted extends Error {
  override readonly name = 'AbortError';
}

export function isCancelled(reason: unknown): boolean {
  if (!(reason instanceof Error)) return false;
  return reason.name === 'AbortError' || ('code' in reason && reason.code === 'cancelled');
}
