import type { App } from '../app.js';
import { h } from '../dom.js';
import { t } from '../words.js';
import { button } from './controls.js';

/** More lines are behind a click. */
const listed = 3;

/**
 * What went wrong, or what was done to a file; stays until it is dismissed or something succeeds.
 * @param leave puts the focus elsewhere when the button that had it goes
 */
export function messageLine(app: App, kind: 'error' | 'report', leave: () => void): HTMLElement {
  const dismiss = () => {
    app.results.set({ [kind]: null });
    leave();
  };
  const title = h('strong', {});
  const text = h('span', {});
  const list = h('div', { class: 'message-list' });
  const offer = button('', () => app.results.get()[kind]?.offer?.act(), { 'data-action': 'offer', class: 'primary' });
  const element = h(
    'div',
    { class: kind, role: kind === 'error' ? 'alert' : 'status' },
    h('div', { class: 'message-text' }, h('p', {}, title, ' ', text), list),
    offer,
    button(t('Dismiss'), dismiss, { 'data-action': `dismiss-${kind}` }),
  );
  app.results.watch(
    (results) => [results[kind]],
    (message) => {
      element.hidden = message === null;
      title.textContent = message ? `${message.title}.` : '';
      text.textContent = message?.text ?? '';
      offer.hidden = !message?.offer;
      offer.textContent = message?.offer?.label ?? '';
      const lines = (message?.list ?? []).map((line) => h('li', {}, line));
      list.replaceChildren(
        ...(lines.length > 0 ? [h('ul', {}, ...lines.slice(0, listed))] : []),
        ...(lines.length > listed
          ? [
              h(
                'details',
                {},
                h('summary', {}, t('{some} more', { some: lines.length - listed })),
                h('ul', {}, ...lines.slice(listed)),
              ),
            ]
          : []),
      );
    },
  );
  return element;
}
