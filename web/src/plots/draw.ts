/** Small plots as SVG: colours and type come from the style sheet. */
import { exact } from '../format.js';
import { type Bin, ticks } from './scale.js';

const [width, height] = [280, 96];
const frame = { left: 4, right: 4, top: 6, bottom: 18 };

export interface Line {
  name: string;
  points: readonly (readonly [number, number])[];
  dashed: boolean;
}

/** Bars above an axis. Those below 0 are told by their place, not by colour alone. */
export function bars(bins: readonly Bin[]): SVGSVGElement {
  const [first, last] = [bins[0], bins.at(-1)];
  const svg = canvas();
  if (!first || !last) return svg;
  const x = linear(first.from, last.to, frame.left, width - frame.right);
  const most = Math.max(...bins.map(({ count }) => count), 1);
  const y = linear(0, most, height - frame.bottom, frame.top);
  for (const { from, to, count } of bins) {
    if (count === 0) continue;
    const [left, right] = [x(from), x(to)];
    const top = Math.min(y(count), height - frame.bottom - 1);
    const side = to <= 0 ? 'bar minus' : 'bar';
    svg.append(
      shape('rect', {
        x: left,
        y: top,
        width: Math.max(0.5, right - left - 0.5),
        height: height - frame.bottom - top,
        class: side,
      }),
    );
  }
  if (first.from < 0 && last.to > 0) svg.append(shape('line', { ...vertical(x(0)), class: 'zero' }));
  axis(svg, x, first.from, last.to);
  return svg;
}

/** Lines over whole numbers; with a mark at the place that is shown. */
export function lines(given: readonly Line[], at: number | null): SVGSVGElement {
  return overNumbers(given, (svg, { name, points, dashed }, x, y) => {
    const path = points.map(([px, py]) => `${x(px).toFixed(1)},${y(py).toFixed(1)}`).join(' ');
    svg.append(shape('polyline', { points: path, class: dashed ? 'series dashed' : 'series' }));
    const end = points.find(([px]) => px === at) ?? points.at(-1);
    if (end)
      svg.append(shape('circle', { cx: x(end[0]), cy: y(end[1]), r: 2.5, class: 'series-end', 'data-name': name }));
  });
}

/** Dots over whole numbers: full ones, and hollow ones for what lines would dash. */
export function dots(given: readonly Line[]): SVGSVGElement {
  return overNumbers(given, (svg, { points, dashed }, x, y) => {
    for (const [px, py] of points)
      svg.append(shape('circle', { cx: x(px), cy: y(py), r: dashed ? 3.5 : 2, class: dashed ? 'dot hollow' : 'dot' }));
  });
}

function overNumbers(
  given: readonly Line[],
  draw: (svg: SVGSVGElement, line: Line, x: Scale, y: Scale) => void,
): SVGSVGElement {
  const svg = canvas();
  const all = given.flatMap(({ points }) => points);
  if (all.length === 0) return svg;
  const xs = all.map(([x]) => x);
  const ys = all.map(([, y]) => y);
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  const room = high > low ? 0 : Math.abs(high) || 1;
  const left = 52;
  const x = linear(0, Math.max(...xs, 1), left, width - frame.right - 4);
  const y = linear(low - room, high + room, height - frame.bottom - 4, frame.top + 4);
  for (const tick of ticks(low - room, high + room, 2)) {
    svg.append(shape('line', { x1: left, x2: width - frame.right, y1: y(tick), y2: y(tick), class: 'grid' }));
    svg.append(label(exact(tick), left - 4, y(tick) + 4, 'end'));
  }
  for (const line of given) draw(svg, line, x, y);
  axis(svg, x, 0, Math.max(...xs, 1), (tick) => Number.isInteger(tick));
  return svg;
}

/** Where a matrix has entries: a square for each block that has any. */
export function spy(blocks: ReadonlyMap<number, boolean>, across: number): SVGSVGElement {
  const size = 132;
  const svg = canvas(size, size);
  svg.append(shape('rect', { x: 0.5, y: 0.5, width: size - 1, height: size - 1, class: 'spy-frame' }));
  const unit = (size - 4) / across;
  for (const negative of [false, true]) {
    const path: string[] = [];
    for (const [key, has] of blocks) {
      if (has !== negative) continue;
      const [row, column] = [Math.floor(key / across), key % across];
      path.push(
        `M${(2 + column * unit).toFixed(2)},${(2 + row * unit).toFixed(2)}h${unit.toFixed(2)}v${unit.toFixed(2)}h-${unit.toFixed(2)}z`,
      );
    }
    if (path.length > 0) svg.append(shape('path', { d: path.join(''), class: negative ? 'entry minus' : 'entry' }));
  }
  return svg;
}

type Scale = (value: number) => number;

const linear = (from: number, to: number, first: number, last: number): Scale => {
  const span = to - from || 1;
  return (value) => first + ((value - from) / span) * (last - first);
};

const vertical = (x: number) => ({ x1: x, x2: x, y1: frame.top, y2: height - frame.bottom });

function axis(svg: SVGSVGElement, x: Scale, min: number, max: number, wanted: (tick: number) => boolean = () => true) {
  svg.append(
    shape('line', { x1: x(min), x2: x(max), y1: height - frame.bottom, y2: height - frame.bottom, class: 'axis' }),
  );
  for (const tick of ticks(min, max, 4).filter(wanted)) {
    const at = x(tick);
    const anchor = at < 16 ? 'start' : at > width - 16 ? 'end' : 'middle';
    svg.append(label(exact(tick), at, height - 4, anchor));
  }
}

function canvas(wide = width, high = height): SVGSVGElement {
  return shape('svg', { viewBox: `0 0 ${wide} ${high}`, class: 'chart' }) as SVGSVGElement;
}

function label(text: string, x: number, y: number, anchor: string): SVGElement {
  const element = shape('text', { x, y, 'text-anchor': anchor });
  element.textContent = text;
  return element;
}

function shape(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes))
    element.setAttribute(name, typeof value === 'number' ? String(Number(value.toFixed(2))) : value);
  return element;
}
