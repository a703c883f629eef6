import { adopt } from '../adopt.js';
import type { App } from '../app.js';
import { explain } from '../messages.js';
import { t } from '../words.js';

interface Opened {
  element: HTMLDialogElement;
  /** Of its own. */
  styles?: string;
  open?: () => void;
}

/** A dialog whose code is loaded when it is first wanted. @returns opens it */
export function later(app: App, root: HTMLElement, name: string, make: () => Promise<Opened | HTMLDialogElement>) {
  let made: Promise<Opened> | null = null;
  const load = async () => {
    const dialog = await make();
    const opened = dialog instanceof HTMLDialogElement ? { element: dialog } : dialog;
    if (opened.styles) adopt(root, opened.styles);
    root.append(opened.element);
    return opened;
  };
  return async () => {
    try {
      made ??= load();
      const { element, open } = await made;
      if (element.open) return;
      if (open) open();
      else element.showModal();
    } catch (reason) {
      made = null;
      app.results.set({ error: { title: t('{name} cannot be shown', { name }), text: explain(reason) } });
    }
  };
}
