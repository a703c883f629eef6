import type { Mesh, Shape, Side, SmoothOptions } from './polylap.js';
import type { Choice, Smooth, State, VertexWeights } from './state.js';

/** Smoothing steps of one kind, as data: taken again on the same mesh, they lead to the same surfaces. */
export interface Move extends Smooth {
  sides: Readonly<Record<Side, Choice>>;
  vertexWeights: Readonly<Record<Side, VertexWeights>>;
  steps: number;
}

/** One step of what is chosen now. */
export const moveOf = ({ sides, vertexWeights, smooth }: State): Move => ({
  sides,
  vertexWeights,
  ...smooth,
  steps: 1,
});

/** A move without what the mesh has none of: a choice may outlive the mesh it was made for. */
export const possible = (move: Move, mesh: Mesh, shape: Shape | null): Move => ({
  ...move,
  keepVolume: move.keepVolume && shape?.volume !== null,
  fixBoundary: move.fixBoundary && mesh.boundary.length > 0,
});

/** What a side's core is told to do. */
export const optionsOf = (move: Move, side: Side, mesh: Mesh): Required<SmoothOptions> => ({
  time: move.timeH2 * mesh.meanSquaredEdge,
  steps: move.steps,
  flow: move.flow[side],
  rebuild: move.rebuild,
  keepVolume: move.keepVolume,
  fixBoundary: move.fixBoundary,
});

export const stepsOf = (moves: readonly Move[]): number => moves.reduce((sum, { steps }) => sum + steps, 0);

const kind = ({ steps: _, ...rest }: Move) => JSON.stringify(rest);

/** Whether both lead to the same surfaces. */
export const sameMoves = (one: readonly Move[], other: readonly Move[]): boolean =>
  one === other || JSON.stringify(one) === JSON.stringify(other);

/** The moves and one step more; alike steps are one move. */
export function withStep(moves: readonly Move[], step: Move): readonly Move[] {
  const last = moves.at(-1);
  if (!last || kind(last) !== kind(step)) return [...moves, step];
  return [...moves.slice(0, -1), { ...last, steps: last.steps + step.steps }];
}

/** The first so many steps. */
export function upTo(moves: readonly Move[], steps: number): readonly Move[] {
  const kept: Move[] = [];
  let left = steps;
  for (const move of moves) {
    if (left <= 0) break;
    kept.push(move.steps <= left ? move : { ...move, steps: left });
    left -= move.steps;
  }
  return left === 0 && kept.length === moves.length ? moves : kept;
}

/** The steps after the first so many. */
export function after(moves: readonly Move[], steps: number): readonly Move[] {
  const rest: Move[] = [];
  let past = steps;
  for (const move of moves) {
    if (move.steps > past) rest.push(past > 0 ? { ...move, steps: move.steps - past } : move);
    past = Math.max(0, past - move.steps);
  }
  return rest;
}

/** How many steps two lists begin with in common. */
export function common(one: readonly Move[], other: readonly Move[]): number {
  let shared = 0;
  for (const [k, move] of one.entries()) {
    const there = other[k];
    if (!there || kind(move) !== kind(there)) break;
    shared += Math.min(move.steps, there.steps);
    if (move.steps !== there.steps) break;
  }
  return shared;
}
