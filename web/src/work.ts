import type { Busy } from './results.js';

interface Job {
  label: string;
  controller: AbortController;
  fraction: number | null;
}

export interface Run {
  signal: AbortSignal;
  onProgress: (fraction: number) => void;
}

/** Work shorter than this is not announced. */
const patience = 150;

/** Everything the worker is doing for the page: announced when it takes long, cancelled together. */
export class Work {
  private readonly jobs = new Set<Job>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private announced = false;

  constructor(private readonly announce: (busy: Busy | null) => void) {}

  async run<T>(label: string, job: (run: Run) => Promise<T>): Promise<T> {
    const entry: Job = { label, controller: new AbortController(), fraction: null };
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
    } finally {
      this.jobs.delete(entry);
      if (this.announced || this.jobs.size === 0) this.tell();
    }
  }

  get idle(): boolean {
    return this.jobs.size === 0;
  }

  cancel(): void {
    for (const job of this.jobs) job.controller.abort();
  }

  /** Cancels what the worker has not begun: it takes one request after the other. */
  cancelWaiting(): void {
    for (const job of [...this.jobs].slice(1)) job.controller.abort();
  }

  private tell(): void {
    const first = this.jobs.values().next().value;
    if (first) {
      this.announce({ label: first.label, fraction: first.fraction });
      return;
    }
    clearTimeout(this.timer);
    this.timer = undefined;
    this.announced = false;
    this.announce(null);
  }
}

export function isCancelled(reason: unknown): boolean {
  if (!(reason instanceof Error)) return false;
  return reason.name === 'AbortError' || ('code' in reason && reason.code === 'cancelled');
}
