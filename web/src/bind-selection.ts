import type { App } from './app.js';
import type { Mesh } from './polylap.js';
import { known } from './results.js';
import { largestWeight, rowsOf, weightsOf } from './rows.js';
import { chain } from './scene/layers.js';
import { spokes } from './scene/spokes.js';
import type { Viewer } from './scene/viewer.js';
import { sides } from './state.js';

/** So long, in ms, the marks wait for the numbers: those are there at once, while a frame of a large mesh can take a second. */
const patience = 100;

/** None where a state is of another mesh than the one on screen. */
function cornersOf({ faces, geometry: { offsets, corners } }: Mesh, face: number): number[] {
  return face < faces ? [...corners.subarray(offsets[face], offsets[face + 1])] : [];
}

/** What is selected, on the meshes: the vertex, its row as spokes, and the face. @param showMarks draws the marks of vertices */
export function bindSelection(app: App, viewer: Viewer, showMarks: () => void): void {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  const show = () => {
    clearTimeout(waiting);
    waiting = undefined;
    showMarks();
    const { task, selected, selectedFace } = app.state.get();
    const results = app.results.get();
    const rows = task === 'weights' && selected !== null ? rowsOf(results, selected) : null;
    const largest = rows && selected !== null ? largestWeight(rows, selected) : 1;
    for (const side of sides) {
      const row = known(results[side].row);
      const drawn =
        rows && row && selected !== null
          ? spokes(row, weightsOf(rows[side], selected), largest, viewer.meanEdge)
          : { spokes: null, minusSpokes: null, minuses: null };
      for (const name of ['spokes', 'minusSpokes', 'minuses'] as const) viewer.setLayer(side, name, drawn[name]);
      const face =
        results.mesh && task === 'weights' && selectedFace !== null ? cornersOf(results.mesh, selectedFace) : [];
      viewer.setLayer(
        side,
        'face',
        chain(results[side].positions, [...face, ...face.slice(0, 1)], 0.12 * viewer.meanEdge),
      );
    }
  };
  /** After the numbers have been painted: drawing would hold them up. */
  const showAfterPaint = () => requestAnimationFrame(() => setTimeout(show));
  /** Whether numbers of what is selected are still to come. */
  const awaited = () => {
    const { task, selected, selectedFace } = app.state.get();
    if (task !== 'weights') return false;
    return sides.some((side) => {
      const { row, face } = app.results.get()[side];
      const rowLacks = selected !== null && typeof row !== 'string' && row?.vertex !== selected;
      return rowLacks || (selectedFace !== null && typeof face !== 'string' && face?.face !== selectedFace);
    });
  };
  app.state.watch(
    (state) => [state.task, state.selected, state.selectedFace],
    () => {
      clearTimeout(waiting);
      waiting = setTimeout(showAfterPaint, awaited() ? patience : 0);
    },
  );
  app.results.watch(
    ({ a, b, mesh }) => [a.row, b.row, a.face, b.face, a.positions, b.positions, mesh],
    () => {
      if (waiting === undefined) show();
      else if (!awaited()) {
        clearTimeout(waiting);
        waiting = setTimeout(showAfterPaint);
      }
    },
  );
}
