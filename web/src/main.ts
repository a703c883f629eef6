import { App } from './app.js';
import { bindEdges } from './bind-edges.js';
import { bindPins } from './bind-pins.js';
import { bindInput, bindKeys, bindViewer } from './bind-viewer.js';
import { bindWeights } from './bind-weights.js';
import { h } from './dom.js';
import { page } from './layout/page.js';
import { Viewer } from './scene/viewer.js';
import { sharedClient } from './start-client.js';
import { views as allViews, presets, type View } from './state.js';

const app = new App(sharedClient());
const open = async () => {
  if (!(await app.follow(location.hash)) && !app.results.get().mesh) {
    const { error } = app.results.get();
    await app.meshes.preset(presets[0]?.id ?? '');
    if (error) app.results.set({ error });
  }
};
const ready = open().then(() => app.history.begin());
window.addEventListener('hashchange', () => void app.follow(location.hash));
let viewer: Viewer | null = null;
const { canvas, views, help } = page(app, document.getElementById('app') as HTMLElement, async (view, transparent) => {
  if (!viewer) throw new Error('This browser shows no WebGL, so there are no pictures.');
  return viewer.photograph(view, transparent);
});
bindKeys(app, help);

const overlays = allViews.map((side) => {
  const message = h('p', { class: 'view-message', hidden: true });
  views[side].append(message);
  return message;
});
const tell = (text: string | null) => {
  for (const overlay of overlays) {
    overlay.hidden = text === null;
    overlay.textContent = text ?? '';
  }
  if (text) app.say(text);
};

try {
  viewer = new Viewer(canvas, views, () => {
    if (performance.getEntriesByName('polylap:first-frame').length === 0) performance.mark('polylap:first-frame');
  });
  app.front = () => viewer?.front() ?? 0;
  bindViewer(app, viewer);
  bindInput(app, viewer, views);
  bindPins(app, viewer, views);
  bindWeights(app, viewer);
  bindEdges(app, viewer, views);
} catch {
  void ready.then(() =>
    tell('This browser shows no WebGL, so the meshes cannot be drawn. All numbers are right without it.'),
  );
}
// Something to read from the start: the row of a vertex in front.
app.results.watch(
  (results) => [results.mesh],
  (mesh) => {
    // After all that is asked about a new mesh in any case.
    queueMicrotask(() => {
      const { selected } = app.state.get();
      if (mesh && app.results.get().mesh === mesh && selected === null) app.select(app.front());
    });
  },
);
canvas.addEventListener('webglcontextlost', (event) => {
  event.preventDefault();
  tell('The graphics card took the picture away. It comes back by itself as soon as it can.');
});
canvas.addEventListener('webglcontextrestored', () => {
  tell(null);
  app.say('The picture is back.');
});

/** For the console and for tests: what is on screen, as data. */
const handle = {
  state: () => app.state.get(),
  results: () => app.results.get(),
  idle: () => app.idle,
  /** Where a vertex is on the page, in CSS pixels, and whether nothing hides it. */
  project: (view: View, vertex: number) => viewer?.project(view, vertex) ?? null,
  /** What is held on the graphics card; null without one. */
  held: () => viewer?.held ?? null,
};
Object.assign(globalThis, { polylap: handle });
declare global {
  var polylap: typeof handle;
}
