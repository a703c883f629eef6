import type { App } from './app.js';
import { bindSelection } from './bind-selection.js';
import { colouring, Outside, outsideOf } from './colouring.js';
import { isTyping } from './dom.js';
import type { Geometry, Side } from './polylap.js';
import { known } from './results.js';
import { wheelHint } from './scene/host-scroll.js';
import { chain, dualLayers, negativeLines } from './scene/layers.js';
import { Mark } from './scene/markers.js';
import { onTap, type Tap } from './scene/taps.js';
import type { Viewer } from './scene/viewer.js';
import { isLeft, type Scope } from './scope.js';
import { presets, type Source, sides, type View, views } from './state.js';

/** Isolines divide the range of colours into so many. */
const isolineSpaces = 20;

/** Keeps the views in step with what was chosen and computed. */
export function bindViewer(app: App, viewer: Viewer): void {
  viewer.camera.onRest = (camera) => app.state.set({ camera });
  app.state.watch(
    (state) => [state.camera],
    (camera) => viewer.camera.put(camera),
  );
  app.results.watch(
    (results) => [results.mesh],
    (mesh) => {
      if (!mesh) return;
      viewer.setMesh(mesh.geometry, isMade(app.state.get().source) || liesFlat(mesh.geometry));
      viewer.camera.put(app.state.get().camera);
    },
  );
  for (const side of sides) {
    app.results.watch(
      (results) => [results[side].positions, results.mesh],
      (positions, mesh) => {
        if (mesh) viewer.move(side, positions);
      },
    );
    app.results.watch(
      (results) => [results[side].weights, results.mesh],
      (answer, _mesh) => {
        const weights = known(answer);
        viewer.setLayer(side, 'negative', weights && weights.segmentStarts.length > 0 ? negativeLines(weights) : null);
      },
    );
    bindDual(app, viewer, side);
  }

  app.results.watch(
    (results) => [results.difference, results.mesh],
    (difference, _mesh) => {
      if (difference) viewer.move('delta', difference.positions);
      viewer.setValues('delta', difference?.values ?? null, difference?.range ?? null, difference?.map ?? 'viridis');
    },
  );
  app.state.watch(
    (state) => [state.delta.swipe],
    (swipe) => viewer.setSwipe(swipe),
  );

  // Once, when all there is to see is there: drawing and computing would only slow each other down.
  const stop = app.results.watch(
    (results) => [results.a.weights !== null && results.b.weights !== null],
    (complete) => {
      if (!complete) return;
      queueMicrotask(() => stop());
      if (viewer.awake && !matchMedia('(prefers-reduced-motion: reduce)').matches) viewer.camera.nudge();
    },
  );
  app.state.watch(
    (state) => [state.negativeShown[state.task]],
    (shown) => viewer.showLayer('negative', shown),
  );

  const showValues = () => {
    const shown = colouring(app.state.get(), app.results.get());
    for (const side of sides)
      viewer.setValues(
        side,
        shown?.values[side] ?? null,
        shown?.range ?? null,
        shown?.map ?? 'viridis',
        shown?.left[side],
      );
  };
  app.results.watch(({ a, b, mesh }) => [a.harmonic, b.harmonic, a.check, b.check, mesh], showValues);
  app.state.watch((state) => [state.task, state.mode, state.colours], showValues);
  const showIsolines = () => viewer.setIsolines(app.state.get().colours.isolines ? isolineSpaces : 0);
  app.state.watch((state) => [state.colours.isolines], showIsolines);
  app.results.watch((results) => [results.mesh], showIsolines);

  const showDual = () => {
    const { task, dual } = app.state.get();
    const inDual = task === 'dual';
    viewer.fade(inDual ? 0.45 : 0, inDual ? (dual.primal ? 0.4 : 0) : 1);
    viewer.showLayer('dualEdges', inDual && dual.edges);
    viewer.showLayer('dualVertices', inDual && dual.edges);
    viewer.showLayer('edgePoints', inDual && dual.points);
  };
  app.state.watch((state) => [state.task, state.dual], showDual);
  app.results.watch((results) => [results.mesh], showDual);

  app.results.watch(
    (results) => [results.place, results.mesh],
    (place, _mesh) => {
      for (const side of sides) {
        const own = place?.side === side ? place.vertices : [];
        const { positions } = app.results.get()[side];
        // Of a face, all around.
        const round = own.length > 2 ? [...own, ...own.slice(0, 1)] : own;
        viewer.setLayer(side, 'place', chain(positions, round, 0.3 * viewer.meanEdge));
      }
      const [vertex] = place?.vertices ?? [];
      // After the card has come into view where there is room for one.
      if (place && vertex !== undefined) requestAnimationFrame(() => viewer.flyTo(place.side, vertex));
    },
  );

  const showMarks = () => {
    const { task, selected, harmonic } = app.state.get();
    const results = app.results.get();
    const pins = task === 'harmonic' ? harmonic.pins : [];
    for (const side of views) {
      const own = side === 'delta' ? null : known(results[side].harmonic);
      const outside = task === 'harmonic' && own ? outsideOf(own) : [];
      const beyond = (where: Outside) => outside.flatMap(([vertex, side]) => (side === where ? [vertex] : []));
      viewer.setMarks(side, [
        {
          mark: Mark.selected,
          vertices: results.place?.side === side ? results.place.vertices : selected === null ? [] : [selected],
        },
        { mark: Mark.below, vertices: beyond(Outside.below) },
        { mark: Mark.above, vertices: beyond(Outside.above) },
        { mark: Mark.pin, vertices: pins.map((pin) => pin.vertex) },
      ]);
    }
  };
  app.results.watch(({ a, b, place, mesh }) => [a.harmonic, b.harmonic, place, mesh], showMarks);
  app.state.watch((state) => [state.task, state.harmonic.pins], showMarks);
  app.results.watch(
    (results) => [results.hovered, results.mesh],
    (hovered, _mesh) => viewer.hover(hovered),
  );
  bindSelection(app, viewer, showMarks);
}

function bindDual(app: App, viewer: Viewer, side: Side): void {
  app.results.watch(
    (results) => [results[side].dual, results.mesh],
    (answer, _mesh) => {
      const dual = known(answer);
      const layers = dual ? dualLayers(dual, viewer.meanEdge) : {};
      for (const name of ['dualEdges', 'dualVertices', 'edgePoints'] as const)
        viewer.setLayer(side, name, layers[name] ?? null);
    },
  );
}

/** Whether a mesh is of the table of shapes. */
const isMade = (source: Source) =>
  source.kind === 'shape' ||
  (source.kind === 'preset' && presets.some((preset) => preset.id === source.id && 'shape' in preset));

/** Shapes made here stand on the plane z = 0; in files y is mostly up, except where the mesh is a relief over x and y. */
function liesFlat({ positions }: Geometry): boolean {
  const extent = [0, 0, 0];
  positions.forEach((coordinate, k) => {
    extent[k % 3] = Math.max(extent[k % 3] ?? 0, Math.abs(coordinate));
  });
  const [x = 0, y = 0, z = 0] = extent;
  return z < 0.5 * Math.min(x, y);
}

/** Pointer and keys on the views. */
export function bindInput(app: App, viewer: Viewer, places: Record<View, HTMLElement>): void {
  viewer.camera.onHostWheel = wheelHint((text) => app.say(text));
  for (const side of views) {
    const view = places[side];
    let looking = 0;
    const meant = ({ x, y, touch }: Tap) => viewer.meant(side, x, y, touch);
    let toPin: number | null = null;
    onTap(view, {
      tap: (at) => {
        const { vertex, face } = meant(at);
        const { task } = app.state.get();
        toPin = task === 'harmonic' ? vertex : null;
        if (face !== null && task === 'weights') app.selectFace(face);
        else if (vertex !== null) app.select(vertex);
      },
      single: () => {
        // The task may be another one by now.
        if (toPin !== null && app.state.get().task === 'harmonic') app.touchPin(toPin);
      },
      double: () => viewer.camera.reset(),
    });
    view.addEventListener('pointermove', ({ buttons, pointerType, clientX, clientY }) => {
      if (buttons !== 0 || pointerType === 'touch') return;
      cancelAnimationFrame(looking);
      looking = requestAnimationFrame(() => {
        const { vertex, face } = viewer.meant(side, clientX, clientY);
        if (face !== null && app.state.get().task === 'weights') app.hover(null, face);
        else app.hover(vertex);
      });
    });
    view.addEventListener('pointerdown', () => app.hover(null));
    view.addEventListener('pointerleave', () => {
      cancelAnimationFrame(looking);
      app.hover(null);
    });
    view.addEventListener('keydown', (event) => {
      const { task, selected } = app.state.get();
      if (isLeft(event)) return;
      if (event.key === 'Enter' && task === 'harmonic' && selected !== null) app.touchPin(selected);
      else if (event.key === ' ' && task === 'smooth') app.smoothing.toggle();
      else return;
      event.preventDefault();
    });
  }
}

/** Keys that mean the same anywhere on the page, except where one writes. */
export function bindKeys(app: App, scope: Scope, help: () => void): void {
  scope.on('keydown', (event) => {
    const { target } = event;
    if (isLeft(event) || event.altKey || scope.element.querySelector('dialog[open]')) return;
    if (event.ctrlKey || event.metaKey) {
      // Text has an undo of its own.
      if (isTyping(target) && !(target instanceof HTMLSelectElement)) return;
      const key = event.key.toLowerCase();
      if (key === 'y' || (key === 'z' && event.shiftKey)) void app.history.redo();
      else if (key === 'z') void app.history.undo();
      else return;
    } else if (isTyping(target)) return;
    else if (event.key === '[') app.walk(-1);
    else if (event.key === ']') app.walk(1);
    else if (event.key === '{') app.walkFaces(-1);
    else if (event.key === '}') app.walkFaces(1);
    else if (event.key === '?') help();
    else return;
    event.preventDefault();
  });
}
