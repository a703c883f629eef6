/** A press that moves less than this, in pixels, is a click; fingers are less steady. */
const clickReach = { fine: 5, touch: 12 };
/** Two taps within this time, in ms, and distance, in pixels, are a double tap. */
const doubleTap = { span: 300, reach: 32 };

export interface Tap {
  x: number;
  y: number;
  /** By a finger, which means more than the one pixel. */
  touch: boolean;
}

export interface TapListener {
  /** At once. */
  tap: (at: Tap) => void;
  /** As soon as no second tap can follow: what a double tap should not do on its way. */
  single?: () => void;
  /** Two taps of one finger. */
  double?: () => void;
}

/** Tells clicks and taps from turning, pinching and scrolling. */
export function onTap(view: HTMLElement, { tap, single, double }: TapListener): void {
  const down = new Set<number>();
  let pressed: { x: number; y: number } | null = null;
  let last: { at: Tap; time: number } | null = null;
  let waiting: ReturnType<typeof setTimeout> | undefined;
  view.addEventListener('pointerdown', ({ pointerId, button, clientX, clientY }) => {
    down.add(pointerId);
    pressed = button === 0 && down.size === 1 ? { x: clientX, y: clientY } : null;
  });
  view.addEventListener('pointercancel', ({ pointerId }) => {
    down.delete(pointerId);
    pressed = null;
  });
  view.addEventListener('pointerup', ({ pointerId, pointerType, clientX, clientY, timeStamp }) => {
    down.delete(pointerId);
    const at: Tap = { x: clientX, y: clientY, touch: pointerType === 'touch' };
    const reach = at.touch ? clickReach.touch : clickReach.fine;
    const still = pressed !== null && Math.hypot(at.x - pressed.x, at.y - pressed.y) < reach;
    pressed = null;
    if (!still) return;
    if (!at.touch) {
      tap(at);
      single?.();
      return;
    }
    const again =
      last !== null &&
      timeStamp - last.time < doubleTap.span &&
      Math.hypot(at.x - last.at.x, at.y - last.at.y) < doubleTap.reach;
    clearTimeout(waiting);
    last = again ? null : { at, time: timeStamp };
    if (again) {
      double?.();
      return;
    }
    tap(at);
    waiting = setTimeout(() => single?.(), doubleTap.span);
  });
}
