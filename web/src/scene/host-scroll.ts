import { h } from '../dom.js';
import { t } from '../words.js';

/** What the wheel, or one finger up and down, does on a view. `auto`: `scroll` inside another page, and the wheel also on one that scrolls. */
export type Gesture = 'auto' | 'mesh' | 'scroll';

/** Of a mounted page; may change while it is there. */
export interface Gestures {
  wheel: Gesture;
  touch: Gesture;
}

/** Inside another page, which may scroll whatever this one knows. */
const embedded = () => window.top !== window;

const canScroll = () => {
  const { scrollHeight, clientHeight } = document.documentElement;
  return scrollHeight > clientHeight;
};

/** How long the hint stays, in ms. */
const hintSpan = 4000;

/**
 * Leaves to the page what scrolls it: the wheel, unless a key says that it means the mesh (a trackpad's pinch comes as one),
 * and one finger up or down where the page is part of another.
 *
 * @param view whose other listeners take what is left
 * @param gestures what the wheel and a finger are for
 * @param hint called when somebody may have meant the mesh
 * @returns to be called when the gestures have changed
 */
export function leaveScrolling(view: HTMLElement, gestures: Gestures, hint: () => void): () => void {
  const touchScrolls = () => gestures.touch === 'scroll' || (gestures.touch === 'auto' && embedded());
  const wheelScrolls = () => gestures.wheel === 'scroll' || (gestures.wheel === 'auto' && (embedded() || canScroll()));
  const settle = () => {
    view.style.touchAction = touchScrolls() ? 'pan-y' : 'none';
  };
  settle();
  // Two fingers are for the mesh, also where `pan-y` would scroll by two.
  view.addEventListener('touchmove', (event) => touchScrolls() && event.touches.length > 1 && event.preventDefault(), {
    passive: false,
  });
  view.addEventListener(
    'wheel',
    (event) => {
      if (event.ctrlKey || event.metaKey || !wheelScrolls()) return;
      event.stopImmediatePropagation();
      hint();
    },
    { capture: true, passive: true },
  );
  return settle;
}

/** What the wheel does instead: said once, on the view where it was turned. */
export function wheelHint(say: (text: string) => void): (view: HTMLElement) => void {
  const key = /mac/i.test(navigator.platform) ? '⌘' : 'Ctrl';
  let said = false;
  return (view) => {
    if (said) return;
    said = true;
    const text = t('{key} + wheel zooms.', { key });
    const note = h('p', { class: 'view-hint', 'aria-hidden': 'true' }, text);
    view.append(note);
    say(text);
    const leave = () => note.remove();
    view.addEventListener('pointerleave', leave, { once: true });
    setTimeout(leave, hintSpan);
  };
}
