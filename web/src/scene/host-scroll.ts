import { h } from '../dom.js';

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
 * @param hint called when somebody may have meant the mesh
 */
export function leaveScrolling(view: HTMLElement, hint: () => void): void {
  if (embedded()) {
    view.style.touchAction = 'pan-y';
    // Two fingers are for the mesh, also where `pan-y` would scroll by two.
    view.addEventListener('touchmove', (event) => event.touches.length > 1 && event.preventDefault(), {
      passive: false,
    });
  }
  view.addEventListener(
    'wheel',
    (event) => {
      if (event.ctrlKey || event.metaKey || !(embedded() || canScroll())) return;
      event.stopImmediatePropagation();
      hint();
    },
    { capture: true, passive: true },
  );
}

/** What the wheel does instead: said once, on the view where it was turned. */
export function wheelHint(say: (text: string) => void): (view: HTMLElement) => void {
  const key = /mac/i.test(navigator.platform) ? '⌘' : 'Ctrl';
  let said = false;
  return (view) => {
    if (said) return;
    said = true;
    const text = `${key} + wheel zooms.`;
    const note = h('p', { class: 'view-hint', 'aria-hidden': 'true' }, text);
    view.append(note);
    say(text);
    const leave = () => note.remove();
    view.addEventListener('pointerleave', leave, { once: true });
    setTimeout(leave, hintSpan);
  };
}
