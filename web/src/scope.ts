/**
 * Whose keys: `capture` takes all that mean something while the focus is inside, `release` leaves those to the host that turn its pages,
 * `none` takes none but those of controls.
 */
export type Keys = 'capture' | 'release' | 'none';

/** What scrolls a page, or turns those of a slide deck. */
const hostKeys = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', ' ', 'PageUp', 'PageDown', 'Home', 'End'];
const controls = 'input, select, textarea, button, summary, a, [role=spinbutton]';
const typed = 'input:not([type=range], [type=checkbox], [type=radio]), textarea, select';

const left = new WeakSet<Event>();
/** Whether a key is left to the host: nothing here acts on it. */
export const isLeft = (event: Event): boolean => left.has(event);

/** Where a mounted page listens: in the whole document, or in its own element, so that several on one page do not hear each other. */
export class Scope {
  private readonly over = new AbortController();
  /** Ends with the page. */
  readonly signal = this.over.signal;

  constructor(
    readonly element: HTMLElement,
    root: ShadowRoot | HTMLElement,
    readonly whole: boolean,
    public keys: Keys,
  ) {
    const { signal } = this;
    const mark = (event: KeyboardEvent) => {
      const { target } = event;
      // A control that has the focus is being used.
      if (this.keys === 'capture' || (target instanceof Element && target.matches(controls))) return;
      if (this.keys === 'none' || hostKeys.includes(event.key)) left.add(event);
    };
    element.addEventListener('keydown', mark, { capture: true, signal });
    // Who has only clicked goes on turning the host's pages.
    const giveBack = ({ target }: Event) => {
      const focused = this.focused;
      if (this.keys !== 'release' || !(focused instanceof HTMLElement) || focused.closest('dialog')) return;
      if (!focused.matches(typed) || target instanceof HTMLSelectElement) focused.blur();
    };
    element.addEventListener('pointerup', giveBack, { signal });
    element.addEventListener('change', giveBack, { signal });
    if (whole) return;
    // After all listeners inside. A key that means something here does nothing else on the host's page.
    const keep = ((event: KeyboardEvent) => {
      const { key, ctrlKey, metaKey, altKey, defaultPrevented } = event;
      const others = (ctrlKey || metaKey || altKey) && !defaultPrevented;
      if (!isLeft(event) && !others && key !== 'Tab' && key !== 'Escape') event.stopPropagation();
    }) as EventListener;
    root.addEventListener('keydown', keep, { signal });
  }

  /** What has the focus, inside. */
  get focused(): Element | null {
    return focusedBy(this.element);
  }

  /** Keys and the clipboard: the document's, or those that come while focus or pointer is in the element. */
  on<K extends 'keydown' | 'paste'>(type: K, listener: (event: HTMLElementEventMap[K]) => void): void {
    const { element, signal } = this;
    const target: EventTarget = this.whole ? document : element;
    target.addEventListener(type, listener as EventListener, { signal });
    if (this.whole) return;
    // What is meant for nobody in particular.
    const pointedAt = (event: Event) => {
      const idle = event.target === document.body || event.target === document.documentElement;
      if (idle && this.keys === 'capture' && element.matches(':hover')) listener(event as HTMLElementEventMap[K]);
    };
    document.addEventListener(type, pointedAt, { signal });
  }

  end(): void {
    this.over.abort();
  }
}

/** What has the focus in the document or the shadow root that an element is in. */
export const focusedBy = (element: Element): Element | null =>
  (element.getRootNode() as Document | ShadowRoot).activeElement ?? null;
