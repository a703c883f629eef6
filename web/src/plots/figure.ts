import { h } from '../dom.js';
import { typed } from '../format.js';
import { csv } from '../numbers-text.js';
import { save, standalone } from '../saving.js';
import { t } from '../words.js';

type Cell = string | number | null;

/** A plot, its numbers behind a click, and both to take away. */
export function figure(title: string, name: string) {
  const drawing = h('div', { class: 'drawing' });
  const table = h('table', { class: 'readouts' });
  let numbers: { head: readonly string[]; rows: readonly (readonly Cell[])[] } = { head: [], rows: [] };
  const writer = (kind: 'csv' | 'svg', contents: () => string) =>
    h(
      'button',
      {
        type: 'button',
        class: 'quiet',
        'data-action': `${kind}-${name}`,
        onclick: () => save({ name: `${name}.${kind}`, contents: new Blob([contents()]) }),
      },
      kind.toUpperCase(),
    );
  const writeNumbers = writer('csv', () => csv(numbers.head, numbers.rows));
  const writePicture = writer('svg', () => {
    const svg = drawing.querySelector('svg');
    return svg ? standalone(svg) : '';
  });
  const details = h('details', {}, h('summary', {}, t('Numbers')), table, writeNumbers, writePicture);
  // Long tables are built only for those who look at them.
  details.addEventListener('toggle', () => fill());
  const fill = () => {
    if (!details.open) return;
    const shown = numbers.rows.slice(0, mostRows);
    table.replaceChildren(
      h('thead', {}, h('tr', {}, ...numbers.head.map((cell) => h('th', { scope: 'col' }, t(cell))))),
      h('tbody', {}, ...shown.map((row) => h('tr', {}, ...row.map((cell) => h('td', {}, text(cell)))))),
    );
    if (numbers.rows.length > mostRows)
      table.append(h('caption', {}, t('The first {some} of {all}', { some: mostRows, all: numbers.rows.length })));
  };
  const element = h('figure', { class: 'plot', 'data-plot': name }, h('figcaption', {}, title), drawing, details);
  return {
    element,
    /** @param description what one sees, for those who do not */
    show(svg: SVGSVGElement | null, description: string, head: readonly string[], rows: readonly (readonly Cell[])[]) {
      element.hidden = svg === null;
      if (!svg) return;
      svg.setAttribute('role', 'img');
      svg.setAttribute('aria-label', description);
      drawing.replaceChildren(svg);
      numbers = { head, rows };
      fill();
    },
  };
}

const mostRows = 100;

const text = (cell: Cell) => (typeof cell === 'number' ? typed(Number(cell.toPrecision(6))) : (cell ?? ''));
