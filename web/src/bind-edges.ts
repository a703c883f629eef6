/** Edge points of the dual: pointed at or tapped, they are read. */
import type { App } from './app.js';
import type { Side } from './polylap.js';
import { known } from './results.js';
import { edgePoint } from './scene/layers.js';
import { onTap } from './scene/taps.js';
import type { Viewer } from './scene/viewer.js';
import { sides, type View } from './state.js';

export function bindEdges(app: App, viewer: Viewer, places: Record<View, HTMLElement>): void {
  for (const side of sides) {
    const view = places[side];
    let looking = 0;
    const read = (x: number, y: number, touch: boolean) => {
      const { task, dual: shown } = app.state.get();
      const dual = known(app.results.get()[side].dual);
      if (task !== 'dual' || !shown.points || !dual) return;
      const edge = viewer.pickPoint(side, x, y, dual.edgePoints, touch);
      if (edge !== null) app.readEdge(edge);
    };
    view.addEventListener('pointermove', ({ buttons, pointerType, clientX, clientY }) => {
      if (buttons !== 0 || pointerType === 'touch') return;
      cancelAnimationFrame(looking);
      looking = requestAnimationFrame(() => read(clientX, clientY, false));
    });
    onTap(view, { tap: ({ x, y, touch }) => read(x, y, touch) });
    mark(app, viewer, side);
  }
}

/** The point that is read, on both sides. */
function mark(app: App, viewer: Viewer, side: Side): void {
  const show = () => {
    const { edge, [side]: own } = app.results.get();
    const dual = app.state.get().task === 'dual' ? known(own.dual) : null;
    viewer.setLayer(side, 'edgeRead', dual && edge !== null ? edgePoint(dual, edge, viewer.meanEdge) : null);
  };
  app.results.watch((results) => [results.edge, results[side].dual, results.mesh], show);
  app.state.watch((state) => [state.task], show);
}
