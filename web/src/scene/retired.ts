interface Disposable {
  dispose(): void;
}

/** More than that is not kept for the next frame: a page that is not seen draws none. */
const most = 64;

/**
 * What is drawn no more. It goes after the next frame: what comes in its place uses the same programs, which need not be compiled again.
 */
export class Retired {
  private gone: Disposable[] = [];

  add(...gone: Disposable[]): void {
    this.gone.push(...gone);
    if (this.gone.length > most) this.dispose();
  }

  dispose(): void {
    for (const each of this.gone.splice(0)) each.dispose();
  }
}
