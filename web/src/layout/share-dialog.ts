import type { App } from '../app.js';
import { h } from '../dom.js';
import { count } from '../format.js';
import { linkOf } from '../share.js';
import { nameOf } from '../state.js';
import { language, t, word } from '../words.js';
import { button } from './controls.js';

/** The link to what is on screen. */
export function shareDialog(app: App): { element: HTMLDialogElement; open: () => void } {
  const link = h('textarea', { id: 'share-link', readonly: true, rows: 4, spellcheck: 'false', class: 'link' });
  const note = h('p', { class: 'note', 'data-value': 'share-note' });
  const copied = h('p', { class: 'note', role: 'status' });
  const copy = button(
    t('Copy'),
    async () => {
      link.select();
      try {
        await navigator.clipboard.writeText(link.value);
        copied.textContent = t('Copied.');
      } catch {
        copied.textContent = t('The browser does not let the page copy: the link is selected, copy it by hand.');
      }
    },
    { class: 'primary', 'data-action': 'copy-link' },
  );
  const element = h(
    'dialog',
    { class: 'dialog', 'aria-labelledby': 'share-title' },
    h('h2', { id: 'share-title' }, t('Share what is on screen')),
    h(
      'label',
      { for: 'share-link' },
      t('This link opens the page as it is now: mesh, operators, steps, pins and view.'),
    ),
    link,
    note,
    copied,
    h(
      'div',
      { class: 'buttons end' },
      button(t('Close'), () => element.close()),
      copy,
    ),
  );
  const open = async () => {
    const { source } = app.state.get();
    const file = source.kind === 'file' ? (app.meshes.contents(source.file) ?? null) : null;
    const { hash, withoutFile } = await linkOf(app.state.get(), file);
    const address = app.address();
    // Whoever opens it reads it in the language that it was shared in.
    link.value = (address ?? '') + (address !== null && language() !== 'en' ? `?lang=${language()}` : '') + hash;
    const what = withoutFile
      ? t('{name} is too large for a link: whoever opens the link is asked for the file. Nothing is uploaded.', {
          name: nameOf({ ...source, changes: [] }),
        })
      : t(
          file
            ? word('{size} characters, with the mesh in them. Nothing is uploaded.')
            : word('{size} characters. Nothing is uploaded.'),
          { size: count(link.value.length) },
        );
    note.textContent =
      address === null
        ? `${what} ${t('The page has no address of its own here. Put it behind the address of any polylap page.')}`
        : what;
    copied.textContent = '';
    element.showModal();
    link.select();
    link.scrollTop = 0;
  };
  return { element, open: () => void open() };
}
