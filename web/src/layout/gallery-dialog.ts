import type { App } from '../app.js';
import { h } from '../dom.js';
import { count } from '../format.js';
import { type Entry, type Facts, groups, stateOf } from '../gallery.js';
import { publicFile, publicUrl } from '../public-file.js';
import styles from '../styles/gallery.css?inline';
import { t, word } from '../words.js';
import { faceCount } from './card.js';
import { button, newId } from './controls.js';

/**
 * Meshes and figures to choose from, with pictures.
 * @throws Error when what was measured of them cannot be loaded
 */
export async function galleryDialog(app: App): Promise<{ element: HTMLDialogElement; styles: string }> {
  const facts = JSON.parse(await (await publicFile('gallery/facts.json')).text()) as Record<string, Facts>;
  const choose = (entry: Entry) => {
    dialog.close();
    void app.history.asOne(entry.figure ? word('the figure') : word('the mesh'), async () => {
      if ((await app.goTo(stateOf(entry, app.state.get()))) && app.state.get().selected === null)
        app.select(app.front());
    });
  };
  const card = (entry: Entry) => {
    const known = facts[entry.id];
    const picture = h('img', {
      alt: '',
      width: 160,
      height: 112,
      loading: 'lazy',
      src: known && publicUrl(known.picture),
    });
    const place = entry.place ? h('span', { class: 'place' }, t(entry.place)) : null;
    return h(
      'li',
      {},
      h(
        'button',
        { type: 'button', class: 'gallery-card', 'data-entry': entry.id, onclick: () => choose(entry) },
        picture,
        h('span', { class: 'card-name' }, h('b', {}, t(entry.label)), ' ', place),
        h('span', { class: 'card-look' }, t(entry.look)),
        known ? h('span', { class: 'card-facts' }, ...factsOf(known)) : null,
      ),
    );
  };
  const dialog = h(
    'dialog',
    { class: 'dialog gallery', 'aria-labelledby': 'gallery-title' },
    h(
      'div',
      { class: 'gallery-head' },
      h('h2', { id: 'gallery-title' }, t('Gallery')),
      button(t('Close'), () => dialog.close()),
    ),
    h(
      'div',
      { class: 'gallery-body' },
      ...groups.map(({ label, entries }) => {
        const heading = h('h3', { id: newId('gallery') }, t(label));
        return h('section', { 'aria-labelledby': heading.id }, heading, h('ul', {}, ...entries.map(card)));
      }),
    ),
  );
  return { element: dialog, styles };
}

function factsOf(facts: Facts): Node[] {
  const [a = '–', b = '–'] = facts.negative.map((negative) => (negative === null ? '–' : count(negative)));
  return [h('span', {}, faceCount(facts)), h('span', {}, t('negative: A '), h('b', {}, a), ', B ', h('b', {}, b))];
}
