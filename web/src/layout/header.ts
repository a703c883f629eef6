import type { App } from '../app.js';
import { h } from '../dom.js';
import { presets, type Theme } from '../state.js';
import { button, menu } from './controls.js';

const themes: readonly (readonly [Theme, string])[] = [
  ['auto', 'Auto'],
  ['light', 'Light'],
  ['dark', 'Dark'],
];

const opened = 'opened';

export function header(app: App, actions: { open: () => void; paste: () => void; help: () => void }): HTMLElement {
  const meshes = menu(
    'Mesh',
    presets.map(({ id, label }) => [id, label] as const),
    (id) => void app.makePreset(id),
    { class: 'mesh-menu' },
  );
  const theme = menu('Colours', themes, (value) => app.state.set({ theme: value as Theme }), { class: 'theme-menu' });
  // The opened file is in the menu as long as it is on screen.
  app.state.watch(
    (state) => [state.source],
    (source) => {
      meshes.querySelector(`[value=${opened}]`)?.remove();
      if (source.kind === 'file') meshes.prepend(h('option', { value: opened }, source.name));
      meshes.title = source.kind === 'file' ? source.name : '';
      meshes.value = source.kind === 'file' ? opened : source.id;
    },
  );
  // A mesh that could not be made leaves the menu as it was.
  app.results.watch(
    (results) => [results.error],
    () => {
      const { source } = app.state.get();
      meshes.value = source.kind === 'file' ? opened : source.id;
    },
  );
  app.state.watch(
    (state) => [state.theme],
    (value) => {
      theme.value = value;
      if (value === 'auto') delete document.documentElement.dataset.theme;
      else document.documentElement.dataset.theme = value;
    },
  );
  return h(
    'header',
    { class: 'masthead' },
    h('h1', {}, 'polylap'),
    h('p', { class: 'tagline' }, 'Laplacians on polygon meshes, side by side'),
    meshes,
    h('span', { class: 'spring' }),
    button('Open…', actions.open, { 'data-action': 'open' }),
    button('Paste…', actions.paste, { 'data-action': 'paste' }),
    theme,
    button('?', actions.help, { 'aria-label': 'Help', title: 'Help (?)', class: 'key', 'data-action': 'help' }),
  );
}
