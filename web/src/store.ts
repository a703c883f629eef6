/** A value that views watch. Updates are shallow copies: what has not changed keeps its identity. */
export class Store<T extends object> {
  private readonly watchers = new Set<() => void>();

  constructor(private value: T) {}

  get(): T {
    return this.value;
  }

  set(patch: Partial<T>): void {
    this.value = { ...this.value, ...patch };
    for (const watcher of [...this.watchers]) watcher();
  }

  /** Calls `show` now and whenever one of the picked parts is another one. Returns the way to stop. */
  watch<P extends [unknown, ...unknown[]]>(pick: (value: T) => P, show: (...parts: NoInfer<P>) => void): () => void {
    let shown: readonly unknown[] | undefined;
    const look = () => {
      const parts = pick(this.value);
      if (shown && parts.every((part, k) => Object.is(part, shown?.[k]))) return;
      shown = parts;
      show(...(parts as NoInfer<P>));
    };
    this.watchers.add(look);
    look();
    return () => this.watchers.delete(look);
  }

  /** @returns stops all that came to watch since */
  mark(): () => void {
    const before = new Set(this.watchers);
    return () => {
      for (const watcher of this.watchers) if (!before.has(watcher)) this.watchers.delete(watcher);
    };
  }
}
