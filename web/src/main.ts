import { mount } from './mount.js';
import { sharedClient } from './start-client.js';
import { presets, type View } from './state.js';

/** The page as a document of its own: it follows the address, and its theme is the document's. */
const { app, viewer } = mount(document.getElementById('app') as HTMLElement, {
  client: sharedClient(),
  whole: true,
  start: async (app) => {
    if ((await app.follow(location.hash)) || app.results.get().mesh) return;
    const { error } = app.results.get();
    await app.meshes.preset(presets[0]?.id ?? '');
    if (error) app.results.set({ error });
  },
  onFrame: () => {
    if (performance.getEntriesByName('polylap:first-frame').length === 0) performance.mark('polylap:first-frame');
  },
});
window.addEventListener('hashchange', () => void app.follow(location.hash));
app.state.watch(
  (state) => [state.theme],
  (theme) => {
    document.documentElement.dataset.theme = theme;
  },
);

/** For the console and for tests: what is on screen, as data. */
const handle = {
  state: () => app.state.get(),
  results: () => app.results.get(),
  idle: () => app.idle,
  /** Where a vertex is on the page, in CSS pixels, and whether nothing hides it. */
  project: (view: View, vertex: number) => viewer.project(view, vertex),
  /** What is held on the graphics card; null without one. */
  held: () => (viewer.awake ? viewer.held : null),
};
Object.assign(globalThis, { polylap: handle });
declare global {
  var polylap: typeof handle;
}
