import { PolylapError, type Side } from './polylap.js';
import type { Message } from './results.js';

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
  const what = ({ step, collapsed }: Stop) =>
    `stopped at step ${step}${collapsed ? ': the surface has collapsed there' : ''}`;
  const [first, second] = stops;
  if (!first) throw new Error('nothing stopped');
  if (!second) return { title: `Side ${name(first)} ${what(first)}`, text: first.reason };
  const alike = what(first) === what(second);
  const title = alike
    ? `Both sides ${what(first)}`
    : stops.map((stop) => `Side ${name(stop)} ${what(stop)}`).join('; ');
  const text =
    first.reason === second.reason ? first.reason : stops.map((stop) => `${name(stop)}: ${stop.reason}`).join(' ');
  return { title, text };
}
