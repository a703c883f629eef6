/** A press that moves less than this, in pixels, is a click. */
const reach = 4;

export interface Drag {
  /** From where it was pressed. */
  begin: (x: number, y: number) => void;
  /** At most once a frame. @param touch whether a finger does it */
  move: (x: number, y: number, touch: boolean) => void;
  end: () => void;
  /** By Escape, or because the pointer was taken away. */
  cancel: () => void;
}

/** What is dragged by a handle; the view below does not turn. */
export function onDrag(handle: HTMLElement, { begin, move, end, cancel }: Drag): void {
  handle.addEventListener('pointerdown', (event) => {
    event.stopPropagation();
    if (event.button !== 0 || !event.isPrimary) return;
    const { pointerId, pointerType, clientX, clientY } = event;
    const over = new AbortController();
    const { signal } = over;
    let begun = false;
    let frame = 0;
    let at = { x: clientX, y: clientY };
    const follow = () => {
      cancelAnimationFrame(frame);
      frame = 0;
      move(at.x, at.y, pointerType === 'touch');
    };
    const stop = (done: () => void) => {
      over.abort();
      cancelAnimationFrame(frame);
      if (begun) done();
    };
    handle.setPointerCapture(pointerId);
    handle.addEventListener(
      'pointermove',
      (next) => {
        if (next.pointerId !== pointerId) return;
        at = { x: next.clientX, y: next.clientY };
        if (!begun && Math.hypot(at.x - clientX, at.y - clientY) < reach) return;
        if (!begun) begin(clientX, clientY);
        begun = true;
        frame ||= requestAnimationFrame(follow);
      },
      { signal },
    );
    handle.addEventListener(
      'pointerup',
      (next) => {
        if (next.pointerId !== pointerId) return;
        if (begun) {
          follow();
          // The click that may follow is none.
          const quiet = new AbortController();
          const swallow = (click: Event) => click.stopImmediatePropagation();
          handle.addEventListener('click', swallow, { signal: quiet.signal, capture: true });
          setTimeout(() => quiet.abort());
        }
        stop(end);
      },
      { signal },
    );
    handle.addEventListener('pointercancel', () => stop(cancel), { signal });
    document.addEventListener(
      'keydown',
      (key) => {
        if (key.key !== 'Escape' || !begun) return;
        key.preventDefault();
        key.stopPropagation();
        stop(cancel);
      },
      { signal, capture: true },
    );
  });
}
