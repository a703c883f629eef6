import type { App } from '../app.js';
import { h, isTyping } from '../dom.js';

/** OBJ text has a line that defines a vertex. */
export const looksLikeObj = (text: string) => /^\s*v\s+[-+.\d]/m.test(text);

/** Meshes come in by file picker, by drop anywhere, and by paste. Returns the way to the picker. */
export function intake(app: App, page: HTMLElement): { element: HTMLInputElement; pick: () => void } {
  const element = h('input', {
    type: 'file',
    class: 'unseen',
    tabindex: -1,
    'aria-label': 'Mesh file',
    accept: '.obj,model/obj,text/plain',
    onchange: () => {
      const file = element.files?.[0];
      if (file) void app.open(file, file.name);
      // So that choosing the same file again counts as a change.
      element.value = '';
    },
  });
  const target = h('div', { class: 'drop', hidden: true }, h('p', {}, 'Drop the mesh to open it'));
  page.append(target);
  const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  const show = (event: DragEvent) => {
    if (!carriesFile(event)) return;
    event.preventDefault();
    target.hidden = false;
  };
  document.addEventListener('dragenter', show);
  document.addEventListener('dragover', show);
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) target.hidden = true;
  });
  document.addEventListener('drop', (event) => {
    target.hidden = true;
    if (!carriesFile(event)) return;
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) void app.open(file, file.name);
  });
  document.addEventListener('paste', (event) => {
    if (isTyping(event.target)) return;
    const file = event.clipboardData?.files[0];
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (file) void app.open(file, file.name);
    else if (looksLikeObj(text)) void app.open(new Blob([text]), 'pasted.obj');
    else if (text) app.say('The clipboard holds no OBJ text: no line starts with v and a number.');
  });
  return { element, pick: () => element.click() };
}
