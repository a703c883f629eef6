/**
 * What a page in a frame and the page around it say to each other, with postMessage:
 *   in   {polylap: 1, id, method, params}
 *   out  {polylap: 1, id, result}  or  {polylap: 1, id, error: {message}},  and  {polylap: 1, event, detail}
 * Only the page around it is heard, whatever its origin is: whoever shows a page in a frame may use it. Nothing that it could learn is secret.
 */

export type FrameEvent = 'ready' | 'state-change' | 'pick' | 'step' | 'error' | 'size' | 'key';

export interface Embedded {
  /** By name; called with what `params` lists. What they return, or resolve to, is cloned. */
  readonly methods: Readonly<Record<string, (...params: never[]) => unknown>>;
  /** Whether the keys that turn the pages of a deck are handed to the page around. */
  readonly releasesKeys: () => boolean;
}

export interface Frame {
  tell: (event: FrameEvent, detail?: unknown) => void;
}

interface Call {
  id: string | number;
  method: string;
  params: unknown[];
}

/** @returns null where the document is in no frame */
export function serveFrame(embedded: Embedded): Frame | null {
  const { parent } = window;
  if (parent === window) return null;
  // To whoever it is: its origin is only known once it has said something.
  const post = (message: object, origin = '*') => parent.postMessage({ polylap: 1, ...message }, origin);
  const tell = (event: FrameEvent, detail: unknown = null) => post({ event, detail });
  window.addEventListener('message', ({ source, origin, data }) => {
    const call = source === parent && readCall(data);
    // An opaque origin has no name to send to.
    if (call) void answer(embedded, call, (message) => post(message, origin === 'null' ? '*' : origin));
  });
  tellSize((size) => tell('size', size));
  handKeysOver(embedded.releasesKeys, (key) => tell('key', key));
  return { tell };
}

/** @returns null where it is none: other scripts send messages, too */
function readCall(data: unknown): Call | null {
  if (typeof data !== 'object' || data === null) return null;
  const { polylap, id, method, params = [] } = data as Record<string, unknown>;
  if (polylap !== 1 || (typeof id !== 'string' && typeof id !== 'number') || typeof method !== 'string') return null;
  return { id, method, params: Array.isArray(params) ? params : [params] };
}

async function answer({ methods }: Embedded, { id, method, params }: Call, post: (message: object) => void) {
  try {
    const work = Object.hasOwn(methods, method) ? methods[method] : undefined;
    if (!work) throw new Error(`there is no method ${method}: there are ${Object.keys(methods).join(', ')}`);
    // Null says that it is done: of a result that is undefined nothing would be left in JSON.
    post({ id, result: (await work(...(params as never[]))) ?? null });
  } catch (reason) {
    post({ id, error: { message: reason instanceof Error ? reason.message : String(reason) } });
  }
}

/** The height that the content wants: that of the frame, where it fills what it gets. */
function tellSize(tell: (size: { width: number; height: number }) => void): void {
  const { documentElement } = document;
  let told = '';
  new ResizeObserver(() => {
    const { width, height } = documentElement.getBoundingClientRect();
    const size = { width: Math.ceil(width), height: Math.ceil(height) };
    // There is nothing in it yet.
    if (size.height === 0 || JSON.stringify(size) === told) return;
    told = JSON.stringify(size);
    tell(size);
  }).observe(documentElement);
}

/** What turns the pages of a deck, or scrolls. */
const deckKeys = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', ' ', 'PageUp', 'PageDown', 'Home', 'End'];

/** Before anything else here hears of them. Who is in a control by keys, uses it. */
function handKeysOver(releases: () => boolean, tell: (key: object) => void): void {
  const onKey = (event: KeyboardEvent) => {
    const { key, code, keyCode, shiftKey, ctrlKey, altKey, metaKey, type, repeat } = event;
    if (!releases() || !deckKeys.includes(key) || uses(event.composedPath()[0], key)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    tell({ type, key, code, keyCode, shiftKey, ctrlKey, altKey, metaKey, repeat });
  };
  for (const type of ['keydown', 'keyup'] as const) window.addEventListener(type, onKey, { capture: true });
  // Who has clicked on a control goes on turning pages.
  const leave = () => {
    const focused = deepFocus();
    if (releases() && focused instanceof HTMLElement && !focused.matches(typed) && !focused.closest('dialog'))
      focused.blur();
  };
  window.addEventListener('pointerup', leave);
}

const typed = 'input:not([type=range], [type=checkbox], [type=radio]), textarea, select, [contenteditable]';
const pressed = 'button, summary, input[type=checkbox], input[type=radio]';
const moved = 'input[type=range], input[type=radio], [role=slider], [role=spinbutton], [role=tab], [data-handle]';

function uses(target: EventTarget | undefined, key: string): boolean {
  if (!(target instanceof Element)) return false;
  if (target.matches(typed) || target.closest('dialog')) return true;
  return target.matches(key === ' ' ? pressed : moved);
}

/** What has the focus, in shadow roots too. */
function deepFocus(): Element | null {
  let focused = document.activeElement;
  while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
  return focused;
}
