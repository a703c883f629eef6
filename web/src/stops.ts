import { PolylapError, type Side } from './polylap.js';
import type { Message } from './results.js';
import { t, word } from './words.js';

/** Why a side smooths no further. */
export interface Stop {
  side: Side;
  step: number;
  /** Whether the surface itself has shrunk or folded away. */
  collapsed: boolean;
  /** A sentence. */
  reason: string;
}

/** Share of the loaded area from which on a failure is the surface's own end. */
export const littleLeft = 0.01;
/** Share of the loaded area from which on there is no surface to smooth. */
export const nothingLeft = 1e-6;

/** Whether the core refused a face: after a first step, one that was fine on the loaded mesh. */
export function isFaceRefused(reason: unknown): boolean {
  return reason instanceof PolylapError && reason.code === 'degenerate-face';
}

/** One message for one side or both; each side keeps its own reason. */
export function stopped(stops: readonly Stop[]): Message {
  const name = ({ side }: Stop) => side.toUpperCase();
  const one = (stop: Stop) =>
    t(
      stop.collapsed
        ? word('Side {side} stopped at step {step}: the surface has collapsed there')
        : word('Side {side} stopped at step {step}'),
      { side: name(stop), step: stop.step },
    );
  const [first, second] = stops;
  if (!first) throw new Error('nothing stopped');
  if (!second) return { title: one(first), text: first.reason };
  const { step, collapsed } = first;
  const title =
    step === second.step && collapsed === second.collapsed
      ? t(
          collapsed
            ? word('Both sides stopped at step {step}: the surface has collapsed there')
            : word('Both sides stopped at step {step}'),
          { step },
        )
      : stops.map(one).join('; ');
  const text =
    first.reason === second.reason ? first.reason : stops.map((stop) => `${name(stop)}: ${stop.reason}`).join(' ');
  return { title, text };
}
