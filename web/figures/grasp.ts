/** Handles that are dragged and drawings that are turned: by mouse, finger and keys. */
import type { Control, Handle, Point, Turn } from './figure.js';

interface Grasp {
  setting: (id: string) => Point;
  set: (id: string, point: Point) => void;
  /** Otherwise the arrow keys are somebody else's. */
  takesKeys: boolean;
  signal: AbortSignal;
}

/** Degrees per pixel, and per key. */
const turning = { pixel: 0.5, key: 5 };
/** How much farther a key moves with Shift. */
const farther = 5;

const arrows: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** @param element of the figure, whose drawing comes and goes */
export function grasp(
  element: HTMLElement,
  controls: readonly Control[],
  { setting, set, takesKeys, signal }: Grasp,
): void {
  /** What is held where an event happened, if anything is. */
  const heldAt = (target: EventTarget | null): { control: Handle | Turn; part: HTMLElement | SVGElement } | null => {
    if (!(target instanceof Element)) return null;
    const part = target.closest<HTMLElement | SVGElement>('[data-handle], [data-turn]');
    const id = part?.dataset.handle ?? part?.dataset.turn;
    const control = controls.find((one) => one.id === id);
    return part && (control?.kind === 'handle' || control?.kind === 'turn') ? { control, part } : null;
  };

  element.addEventListener(
    'pointerdown',
    (event) => {
      const held = event.button === 0 ? heldAt(event.target) : null;
      if (!held) return;
      const { control, part } = held;
      const drawing = part.closest('.drawing') as HTMLElement;
      const before = setting(control.id);
      if (control.kind === 'turn') {
        const [x, y] = [event.clientX, event.clientY];
        follow(drawing, event, signal, ({ clientX, clientY }) =>
          set(control.id, [before[0] - turning.pixel * (clientX - x), before[1] + turning.pixel * (clientY - y)]),
        );
        return;
      }
      const picture = [...drawing.querySelectorAll('svg')].findIndex((one) => one.contains(part));
      const start = inPlane(drawing, picture, event);
      if (!start) return;
      event.preventDefault();
      part.focus();
      // Not the handle's middle was taken hold of.
      const offset = [before[0] - start[0], before[1] - start[1]] as const;
      follow(drawing, event, signal, (place) => {
        const now = inPlane(drawing, picture, place);
        if (now) set(control.id, [now[0] + offset[0], now[1] + offset[1]]);
      });
    },
    { signal },
  );

  element.addEventListener(
    'keydown',
    (event) => {
      const held = takesKeys && !event.ctrlKey && !event.metaKey && !event.altKey ? heldAt(event.target) : null;
      const direction = arrows[event.key];
      if (!held || (!direction && event.key !== 'Home')) return;
      event.preventDefault();
      event.stopPropagation();
      const { control } = held;
      const now = setting(control.id);
      const by = (control.kind === 'handle' ? control.step : turning.key) * (event.shiftKey ? farther : 1);
      set(control.id, direction ? [now[0] + by * direction[0], now[1] + by * direction[1]] : control.initial);
    },
    { signal },
  );

  // Where touch-action means nothing to an SVG element.
  const still = (event: TouchEvent) =>
    heldAt(event.target)?.control.kind === 'handle' && event.cancelable && event.preventDefault();
  element.addEventListener('touchstart', still, { signal, passive: false });
}

/** Where a pointer is in the plane of a picture, see svg.ts. */
function inPlane(drawing: HTMLElement, picture: number, { clientX, clientY }: PointerEvent): Point | null {
  const plane = drawing.querySelectorAll('svg')[picture]?.querySelector<SVGGElement>('[data-plane]');
  const matrix = plane?.getScreenCTM()?.inverse();
  if (!matrix) return null;
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(matrix);
  return [x, y];
}

/** Until the pointer is let go of. */
function follow(
  drawing: HTMLElement,
  { pointerId }: PointerEvent,
  gone: AbortSignal,
  move: (event: PointerEvent) => void,
): void {
  const done = new AbortController();
  const signal = AbortSignal.any([done.signal, gone]);
  drawing.setPointerCapture(pointerId);
  const own = (act: (event: PointerEvent) => void) => (event: PointerEvent) =>
    event.pointerId === pointerId && act(event);
  drawing.addEventListener('pointermove', own(move), { signal });
  for (const end of ['pointerup', 'pointercancel'] as const)
    drawing.addEventListener(
      end,
      own(() => done.abort()),
      { signal },
    );
}
