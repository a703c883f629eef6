/**
 * For pages around frames with `data-polylap`: gives each the height that it wants, presses here the keys that it hands over, and turns its messages into
 * promises. Goes into dist/polylap-frame.js; see frame.ts.
 */

type Listener = (detail: unknown) => void;

interface Answer {
  resolve: (result: unknown) => void;
  reject: (error: Error) => void;
}

class FrameHost {
  readonly #frame: HTMLIFrameElement;
  readonly #waiting = new Map<number, Answer>();
  readonly #listeners = new Map<string, Set<Listener>>();
  /** It is known to listen once it has said anything. */
  #unsent: object[] | null = [];
  #next = 0;

  constructor(frame: HTMLIFrameElement) {
    this.#frame = frame;
    window.addEventListener('message', ({ source, data }) => {
      if (source && source === frame.contentWindow && data?.polylap === 1) this.#receive(data);
    });
    // It may have been ready before there was anybody to hear it.
    this.#post({ id: -1, method: 'getState' });
  }

  /** @throws Error with what the frame says */
  call(method: string, ...params: unknown[]): Promise<unknown> {
    return new Promise((resolve, reject) => {
      const id = this.#next++;
      this.#waiting.set(id, { resolve, reject });
      const message = { id, method, params };
      if (this.#unsent) this.#unsent.push(message);
      else this.#post(message);
    });
  }

  /** @returns the way to stop */
  on(event: string, listener: Listener): () => void {
    const all = this.#listeners.get(event) ?? new Set();
    this.#listeners.set(event, all.add(listener));
    return () => all.delete(listener);
  }

  #post(message: object): void {
    this.#frame.contentWindow?.postMessage({ polylap: 1, ...message }, '*');
  }

  /** What fills any frame is content with the one that it has. */
  #resize(height: number): void {
    if (height !== this.#frame.clientHeight) this.#frame.style.height = `${height}px`;
  }

  #receive({ id, result, error, event, detail }: Record<string, unknown>): void {
    const unsent = this.#unsent ?? [];
    this.#unsent = null;
    for (const message of unsent) this.#post(message);
    const answer = this.#waiting.get(id as number);
    this.#waiting.delete(id as number);
    if (error) answer?.reject(new Error((error as Error).message));
    else answer?.resolve(result);
    if (event === 'size') this.#resize((detail as { height: number }).height);
    if (event === 'key') {
      const { type, ...key } = detail as KeyboardEventInit & { type: string };
      document.dispatchEvent(new KeyboardEvent(type, { ...key, bubbles: true, cancelable: true }));
    }
    for (const listener of this.#listeners.get(event as string) ?? []) listener(detail);
  }
}

const hosts = new WeakMap<HTMLIFrameElement, FrameHost>();

/** The frame's methods as promises, and its events. */
function polylapFrame(frame: HTMLIFrameElement): FrameHost {
  const host = hosts.get(frame) ?? new FrameHost(frame);
  hosts.set(frame, host);
  return host;
}

const find = () => {
  for (const frame of document.querySelectorAll<HTMLIFrameElement>('iframe[data-polylap]')) polylapFrame(frame);
};
find();
// Decks make frames when their slide comes.
new MutationObserver(find).observe(document, { subtree: true, childList: true, attributeFilter: ['data-polylap'] });

Object.assign(globalThis, { polylapFrame });
