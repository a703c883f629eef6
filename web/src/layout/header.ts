import type { App } from '../app.js';
import { h } from '../dom.js';
import { shapes } from '../polylap.js';
import { initialParameters, nameOf, presets, type Source, type Theme } from '../state.js';
import { type Language, language, t, word } from '../words.js';
import { button, menu } from './controls.js';

const themes: readonly (readonly [Theme, string])[] = [
  ['auto', word('Auto')],
  ['light', word('Light')],
  ['dark', word('Dark')],
];

/** The entry for what is in neither list: a file, a shape with other parameters, a mesh made of a mesh. */
const other = 'other';
const shapePrefix = 'shape:';

const menuValue = (source: Source) => (source.kind === 'preset' && !source.changes ? source.id : other);

/** In its own words, for those who would not find it in others. */
function languageButton(speak: (language: Language) => void): HTMLElement {
  const [other, name] = language() === 'en' ? (['de', 'Deutsch'] as const) : (['en', 'English'] as const);
  return button(other.toUpperCase(), () => speak(other), {
    lang: other,
    'aria-label': name,
    title: name,
    class: 'key',
    'data-action': 'language',
  });
}

export function header(
  app: App,
  actions: Record<'gallery' | 'open' | 'paste' | 'make' | 'share' | 'save' | 'help', () => void> & {
    speak: ((language: Language) => void) | undefined;
  },
): HTMLElement {
  const group = (label: string, entries: readonly (readonly [string, string])[]) =>
    h('optgroup', { label }, ...entries.map(([value, text]) => h('option', { value }, text)));
  const pick = (value: string) => {
    const shape = shapes.find(({ id }) => value === shapePrefix + id);
    if (shape) void app.meshes.make({ id: shape.id, parameters: initialParameters(shape) });
    else void app.meshes.preset(value);
  };
  const meshes = menu(t('Mesh'), [], pick, { class: 'mesh-menu' });
  meshes.append(
    group(
      t('Examples'),
      presets.map(({ id, label }) => [id, t(label)] as const),
    ),
    group(
      t('Shapes'),
      shapes.map(({ id, label }) => [shapePrefix + id, t(label)] as const),
    ),
  );
  const theme = menu(
    t('Colours'),
    themes.map(([id, name]) => [id, t(name)] as const),
    (value) => app.state.set({ theme: value as Theme }),
    { class: 'theme-menu' },
  );
  const show = () => {
    const { source } = app.state.get();
    const value = menuValue(source);
    meshes.querySelector(`[value=${other}]`)?.remove();
    if (value === other) meshes.prepend(h('option', { value }, nameOf(source)));
    meshes.title = value === other ? nameOf(source) : '';
    meshes.value = value;
  };
  app.state.watch((state) => [state.source], show);
  // A mesh that could not be made leaves the menu as it was.
  app.results.watch((results) => [results.error], show);
  app.state.watch(
    (state) => [state.theme],
    (value) => {
      theme.value = value;
    },
  );
  const undo = button(t('Undo'), () => void app.history.undo(), { 'data-action': 'undo' });
  const redo = button(t('Redo'), () => void app.history.redo(), { 'data-action': 'redo' });
  app.results.watch(
    (results) => [results.undoes, results.redoes],
    (undoes, redoes) => {
      undo.disabled = undoes === null;
      redo.disabled = redoes === null;
      undo.title = undoes === null ? t('Nothing to undo') : t('Undo: {what} (Ctrl Z)', { what: t(undoes) });
      redo.title = redoes === null ? t('Nothing to redo') : t('Redo: {what} (Ctrl Shift Z)', { what: t(redoes) });
    },
  );
  // Where there is no room for them in the line, they open below it.
  const more = h(
    'div',
    { class: 'actions', id: 'actions', popover: 'auto' },
    button(t('Make…'), actions.make, {
      'data-action': 'make',
      title: t('Shapes with parameters, and changes to the mesh'),
    }),
    button(t('Open…'), actions.open, { 'data-action': 'open' }),
    button(t('Paste…'), actions.paste, { 'data-action': 'paste' }),
    button(t('Share…'), actions.share, { 'data-action': 'share' }),
    button(t('Save…'), actions.save, { 'data-action': 'save' }),
    theme,
    actions.speak && languageButton(actions.speak),
    button('?', actions.help, { 'aria-label': t('Help'), title: t('Help (?)'), class: 'key', 'data-action': 'help' }),
  );
  // Before the dialog opens, so that closing it leads back to the menu's button.
  const close = (event: Event) => {
    if (event.target instanceof HTMLButtonElement && more.matches(':popover-open')) more.hidePopover();
  };
  more.addEventListener('click', close, { capture: true });
  const opener = h('button', { type: 'button', class: 'more', popovertarget: 'actions' }, t('Menu'));
  // In the top layer, which knows nothing of the line that it opens from.
  more.addEventListener('beforetoggle', () => {
    const { bottom, right } = opener.getBoundingClientRect();
    more.style.setProperty('--below', `${Math.round(bottom + 8)}px`);
    more.style.setProperty('--beside', `${Math.round(document.documentElement.clientWidth - right)}px`);
  });
  return h(
    'header',
    { class: 'masthead' },
    h('h1', {}, 'polylap'),
    h('p', { class: 'tagline' }, t('Laplacians on polygon meshes, side by side')),
    meshes,
    button(t('Gallery…'), actions.gallery, { 'data-action': 'gallery', title: t('Meshes and figures, with pictures') }),
    h('span', { class: 'spring' }),
    undo,
    redo,
    opener,
    more,
  );
}
