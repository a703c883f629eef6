import type { App } from '../app.js';
import { h, isTyping } from '../dom.js';
import { formatOf, formatOfText, formats } from '../mesh-text.js';
import type { Scope } from '../scope.js';
import { t, word } from '../words.js';

/** Meshes come in by file picker, by drop anywhere, and by paste. Returns the way to the picker. */
export function intake(app: App, page: HTMLElement, scope: Scope): { element: HTMLInputElement; pick: () => void } {
  const element = h('input', {
    type: 'file',
    class: 'unseen',
    tabindex: -1,
    'aria-label': t('Mesh file'),
    accept: formats.map((format) => `.${format},model/${format}`).join(','),
    onchange: () => {
      const file = element.files?.[0];
      if (file) void app.meshes.open(file, file.name);
      // So that choosing the same file again counts as a change.
      element.value = '';
    },
  });
  const target = h('div', { class: 'drop', hidden: true }, h('p', {}, t('Drop the mesh to open it')));
  page.append(target);
  const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  const carriesText = (event: DragEvent) =>
    !isTyping(event.target) && (event.dataTransfer?.types.includes('text/plain') ?? false);
  const show = (event: DragEvent) => {
    if (!carriesFile(event) && !carriesText(event)) return;
    event.preventDefault();
    target.hidden = false;
  };
  const ground: GlobalEventHandlers = scope.whole ? document : scope.element;
  const { signal } = scope;
  ground.addEventListener('dragenter', show, { signal });
  ground.addEventListener('dragover', show, { signal });
  ground.addEventListener(
    'dragleave',
    ({ relatedTarget: to }) => {
      if (!(to instanceof Node && scope.element.contains(to)) && !(scope.whole && to !== null)) target.hidden = true;
    },
    { signal },
  );
  ground.addEventListener(
    'drop',
    (event) => {
      target.hidden = true;
      if (!carriesFile(event) && !carriesText(event)) return;
      event.preventDefault();
      take(event.dataTransfer, 'dropped');
    },
    { signal },
  );
  scope.on('paste', (event) => {
    if (!isTyping(event.target)) take(event.clipboardData, 'pasted');
  });

  function take(data: DataTransfer | null, how: 'dropped' | 'pasted'): void {
    const text = data?.getData('text/plain') ?? '';
    const format = formatOfText(text);
    if (data && data.files.length > 0) void openOne(app, [...data.files]);
    else if (format) void app.meshes.open(new Blob([text]), `${how}.${format}`);
    else if (text)
      app.say(
        t(
          how === 'dropped'
            ? word('The dropped text is no mesh: no OBJ text (no line starts with v and a number), OFF, PLY or STL.')
            : word('The pasted text is no mesh: no OBJ text (no line starts with v and a number), OFF, PLY or STL.'),
        ),
      );
  }
  return { element, pick: () => element.click() };
}

/** Opens the first mesh among files, and says what it left. */
async function openOne(app: App, files: readonly File[]): Promise<void> {
  const chosen = files.find(({ name }) => formatOf(name)) ?? files[0];
  if (!chosen) return;
  await app.meshes.open(chosen, chosen.name);
  const left = files.filter((file) => file !== chosen).map(({ name }) => name);
  const { source } = app.state.get();
  if (left.length === 0 || source.kind !== 'file' || source.name !== chosen.name) return;
  const named =
    left.length > 4
      ? t('{names} and {some} more', { names: left.slice(0, 3).join(', '), some: left.length - 3 })
      : left.join(', ');
  app.say(`${app.results.get().notice} ${t('One mesh at a time: left out {names}.', { names: named })}`);
}
