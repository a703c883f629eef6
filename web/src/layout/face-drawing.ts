import type { FaceReport } from '../polylap.js';

const size = 132;
/** Room for the numbers of corners. */
const margin = 20;
/** Beyond, numbers would run into each other. */
const mostNumbers = 16;

/** A face seen along its vector area: its outline, dashed the diagonals by which the operator cuts it, and the numbers of its corners. */
export function faceDrawing({ projected, triangles, corners }: FaceReport): SVGSVGElement {
  const n = projected.length / 2;
  const xs = Array.from({ length: n }, (_, k) => projected[2 * k] as number);
  // Down the page is up the plane.
  const ys = Array.from({ length: n }, (_, k) => -(projected[2 * k + 1] as number));
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [wide, high] = [Math.max(...xs) - left, Math.max(...ys) - top];
  const scale = (size - 2 * margin) / Math.max(wide, high, Number.MIN_VALUE);
  const width = size;
  const height = scale * high + 2 * margin;
  const x = xs.map((value) => width / 2 + scale * (value - left - wide / 2));
  const y = ys.map((value) => margin + scale * (value - top));
  const at = (k: number) => `${(x[k] ?? 0).toFixed(1)},${(y[k] ?? 0).toFixed(1)}`;

  const svg = make('svg', {
    viewBox: `0 0 ${width} ${height.toFixed(1)}`,
    class: 'face-drawing',
    'aria-hidden': 'true',
  });
  svg.append(make('polygon', { points: xs.map((_, k) => at(k)).join(' ') }));
  for (const [p, q] of diagonals(triangles, n))
    svg.append(make('polyline', { points: `${at(p)} ${at(q)}`, class: 'diagonal' }));
  const [cx, cy] = [x.reduce((sum, c) => sum + c, 0) / n, y.reduce((sum, c) => sum + c, 0) / n];
  for (let k = 0; k < n; k++) {
    const [px, py] = [x[k] ?? 0, y[k] ?? 0];
    svg.append(make('circle', { cx: px.toFixed(1), cy: py.toFixed(1), r: 2 }));
    if (n > mostNumbers) continue;
    const away = Math.hypot(px - cx, py - cy) || 1;
    const number = make('text', {
      x: (px + (11 * (px - cx)) / away).toFixed(1),
      y: (py + (11 * (py - cy)) / away + 4).toFixed(1),
      'text-anchor': 'middle',
    });
    number.textContent = String(corners[k]);
    svg.append(number);
  }
  return svg as SVGSVGElement;
}

/** The sides of triangles that are none of the outline, each once. */
function diagonals(triangles: Int32Array, n: number): [number, number][] {
  const found: [number, number][] = [];
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; k++) {
      const [p, q] = [triangles[t + k] as number, triangles[t + ((k + 1) % 3)] as number];
      // Each is met from both sides.
      if (p < q && q - p !== 1 && q - p !== n - 1) found.push([p, q]);
    }
  return found;
}

function make(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}
