import type { App } from './app.js';
import { isTyping } from './dom.js';
import type { Geometry, Side } from './polylap.js';
import { sharedRange } from './results.js';
import { Mark } from './scene/markers.js';
import type { Viewer } from './scene/viewer.js';
import { sides } from './state.js';

/** A press that moves less than this, in pixels, is a click. */
const clickReach = 5;

/** Keeps the views in step with what was chosen and computed. */
export function bindViewer(app: App, viewer: Viewer): void {
  app.results.watch(
    (results) => [results.mesh],
    (mesh) => {
      if (!mesh) return;
      viewer.setMesh(mesh.geometry, app.state.get().source.kind === 'preset' || liesFlat(mesh.geometry));
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
      (weights, _mesh) => viewer.setNegative(side, typeof weights === 'string' ? null : weights),
    );
  }

  // Once, when all there is to see is there: drawing and computing would only slow each other down.
  const stop = app.results.watch(
    (results) => [results.a.weights !== null && results.b.weights !== null],
    (complete) => {
      if (!complete) return;
      queueMicrotask(() => stop());
      if (!matchMedia('(prefers-reduced-motion: reduce)').matches) viewer.camera.nudge();
    },
  );
  app.state.watch(
    (state) => [state.negativeShown[state.task]],
    (shown) => viewer.showNegative(shown),
  );

  const showValues = () => {
    const results = app.results.get();
    const range = app.state.get().task === 'harmonic' ? sharedRange(results) : null;
    for (const side of sides) {
      const { harmonic } = results[side];
      viewer.setValues(side, range && harmonic && typeof harmonic !== 'string' ? harmonic.values : null, range);
    }
  };
  app.results.watch((results) => [results.a.harmonic, results.b.harmonic, results.mesh], showValues);
  app.state.watch((state) => [state.task], showValues);

  const showMarks = () => {
    const { task, selected, harmonic } = app.state.get();
    const results = app.results.get();
    const pins = task === 'harmonic' ? harmonic.pins : [];
    for (const side of sides) {
      const own = results[side].harmonic;
      const outside = task === 'harmonic' && own && typeof own !== 'string' ? own.outside : [];
      viewer.setMarks(side, [
        { mark: Mark.hovered, vertices: results.hovered === null ? [] : [results.hovered] },
        { mark: Mark.selected, vertices: selected === null ? [] : [selected] },
        { mark: Mark.outside, vertices: outside },
        { mark: Mark.pin, vertices: pins.map((pin) => pin.vertex) },
      ]);
    }
  };
  app.results.watch((results) => [results.a.harmonic, results.b.harmonic, results.hovered, results.mesh], showMarks);
  app.state.watch((state) => [state.task, state.selected, state.harmonic.pins], showMarks);
  app.state.watch(
    (state) => [state.task, state.harmonic.pins],
    (task, { length }) => viewer.setLabels(task === 'harmonic' && length > 0 ? app.state.get().harmonic.pins : []),
  );

  const recolour = () => viewer.recolour();
  app.state.watch((state) => [state.theme], recolour);
  for (const query of ['(prefers-color-scheme: dark)', '(forced-colors: active)'])
    matchMedia(query).addEventListener('change', recolour);
}

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
export function bindInput(app: App, viewer: Viewer, views: Record<Side, HTMLElement>): void {
  for (const side of sides) {
    const view = views[side];
    let pressed: { x: number; y: number } | null = null;
    let looking = 0;
    view.addEventListener('pointerdown', ({ button, clientX, clientY }) => {
      pressed = button === 0 ? { x: clientX, y: clientY } : null;
    });
    view.addEventListener('pointerup', ({ clientX, clientY }) => {
      const still = pressed && Math.hypot(clientX - pressed.x, clientY - pressed.y) < clickReach;
      pressed = null;
      if (!still) return;
      const vertex = viewer.pick(side, clientX, clientY);
      if (vertex === null) return;
      app.select(vertex);
      if (app.state.get().task === 'harmonic') app.touchPin(vertex);
    });
    view.addEventListener('pointermove', ({ buttons, pointerType, clientX, clientY }) => {
      if (buttons !== 0 || pointerType === 'touch') return;
      cancelAnimationFrame(looking);
      looking = requestAnimationFrame(() => app.hover(viewer.pick(side, clientX, clientY)));
    });
    view.addEventListener('pointerleave', () => {
      cancelAnimationFrame(looking);
      app.hover(null);
    });
    view.addEventListener('keydown', (event) => {
      const { task, selected } = app.state.get();
      if (event.key === 'Enter' && task === 'harmonic' && selected !== null) app.touchPin(selected);
      else if (event.key === ' ' && task === 'smooth') app.results.get().playing ? app.pause() : void app.play();
      else return;
      event.preventDefault();
    });
  }
}

/** Keys that mean the same anywhere on the page, except where one writes. */
export function bindKeys(app: App, help: () => void): void {
  document.addEventListener('keydown', (event) => {
    if (
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      isTyping(event.target) ||
      document.querySelector('dialog[open]')
    )
      return;
    if (event.key === '[') app.walk(-1);
    else if (event.key === ']') app.walk(1);
    else if (event.key === '?') help();
    else return;
    event.preventDefault();
  });
}
