/** What several figures need. */
import { initialState, type State } from '../src/state.js';

export { choice, rim } from '../src/gallery.js';

/** The state of the full page, but for what a figure changes. */
export const stateWith = (change: (initial: State) => Partial<State>): State => {
  const initial = initialState();
  return { ...initial, ...change(initial) };
};

/** A flat grid of nx × ny rectangles as the source of a state. */
export const gridSource = (nx: number, ny: number, width = nx, height = ny): State['source'] => ({
  kind: 'shape',
  shape: { id: 'grid', parameters: { nx, ny, width, height } },
});

/** What is pinned, as the core takes it. */
export const fixedValues = (pins: State['harmonic']['pins']) => ({
  vertices: pins.map(({ vertex }) => vertex),
  values: pins.map(({ value }) => value),
});

/** The place of a vertex in the plane. @param positions 3V */
export const flat = (positions: ArrayLike<number>, vertex: number): readonly [number, number] => [
  positions[3 * vertex] ?? 0,
  positions[3 * vertex + 1] ?? 0,
];
