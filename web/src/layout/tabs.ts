import { h } from '../dom.js';
import { newId } from './controls.js';

export interface Tab<T extends string> {
  id: T;
  label: string;
  panel: HTMLElement;
}

/** Tabs as the ARIA practices describe them: one stop for the Tab key, arrows move between them. */
export function tabs<T extends string>(name: string, entries: readonly Tab<T>[], onPick: (id: T) => void) {
  const buttons = entries.map(({ id, label, panel }) => {
    panel.id ||= newId('panel');
    const tab = h(
      'button',
      {
        type: 'button',
        role: 'tab',
        id: newId('tab'),
        'aria-controls': panel.id,
        'data-tab': id,
        onclick: () => onPick(id),
      },
      label,
    );
    panel.setAttribute('role', 'tabpanel');
    panel.setAttribute('aria-labelledby', tab.id);
    return tab;
  });
  const element = h('div', { role: 'tablist', class: 'tabs', 'aria-label': name }, ...buttons);
  element.addEventListener('keydown', (event) => {
    const at = buttons.indexOf(event.target as HTMLButtonElement);
    const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (at < 0 || to === undefined) return;
    event.preventDefault();
    const next = buttons[(to + buttons.length) % buttons.length];
    next?.focus();
    next?.click();
  });
  const show = (picked: T) => {
    entries.forEach(({ id, panel }, k) => {
      const chosen = id === picked;
      buttons[k]?.setAttribute('aria-selected', String(chosen));
      if (buttons[k]) buttons[k].tabIndex = chosen ? 0 : -1;
      panel.hidden = !chosen;
    });
  };
  return { element, show };
}
