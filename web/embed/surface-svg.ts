/** A view as a drawing: its polygons one over the other, the farthest first (Newell, Newell & Sancha 1972, without splitting any). */
import { Vector3 } from 'three';
import type { App } from '../src/app.js';
import { type ColourMap, colourMap } from '../src/colour-maps.js';
import { colouring } from '../src/colouring.js';
import { known } from '../src/results.js';
import { type Colours, type Interval, lightFrom } from '../src/scene/surface.js';
import type { Viewer } from '../src/scene/viewer.js';
import type { View } from '../src/state.js';

/** More would be a picture that few programs open. */
const mostFaces = 100_000;
/** So much nearer, in mean edge lengths, lines count than the faces that they lie on. */
const lift = 0.5;

interface Piece {
  depth: number;
  text: string;
}

const shorten = (length: number) => String(Math.round(100 * length) / 100);
const hex = (colour: Vector3) =>
  `#${colour
    .toArray()
    .map((part) =>
      Math.round(255 * Math.min(1, Math.max(0, part)))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;

/**
 * What is seen of the surface and its negative weights, without labels; a face has one colour.
 * @throws Error, a sentence, where there is nothing to draw, or too much
 */
export function surfaceSvg(app: App, viewer: Viewer, view: View): string {
  const results = app.results.get();
  const state = app.state.get();
  const seen = viewer.seen(view);
  if (!results.mesh || !seen) throw new Error('That view is not on screen.');
  const { faces, geometry } = results.mesh;
  if (faces > mostFaces) throw new Error(`There are ${faces} faces; a drawing takes up to ${mostFaces}.`);
  const { width, height, points, normals, colours, at } = seen;
  const fillOf = fillFor(view);

  const pieces: Piece[] = [];
  for (let f = 0; f < faces; f++) {
    const corners = geometry.corners.subarray(geometry.offsets[f], geometry.offsets[f + 1]);
    const places = [...corners].map((vertex) => at(vector(points, vertex)));
    const depth = places.reduce((sum, place) => sum + place.depth, 0) / places.length;
    if (places.some((place) => !place.before)) continue;
    const d = places.map(({ x, y }) => `${shorten(x)} ${shorten(y)}`).join('L');
    const lit = lightOn(seen.toEye(vector(normals, f)), places[0]?.eye ?? new Vector3());
    pieces.push({ depth, text: `<path fill="${hex(fillOf(corners, lit))}" d="M${d}Z"/>` });
  }
  const weights = view === 'delta' ? null : known(results[view].weights);
  if (weights && state.negativeShown[state.task]) {
    const nearer = lift * viewer.meanEdge;
    for (let k = 0; k < weights.segmentStarts.length; k++) {
      const [one, other] = [at(vector(weights.segments, 2 * k)), at(vector(weights.segments, 2 * k + 1))];
      if (!one.before || !other.before) continue;
      const [x1, y1, x2, y2] = [one.x, one.y, other.x, other.y].map(shorten);
      const depth = (one.depth + other.depth) / 2 - nearer;
      pieces.push({ depth, text: `<path class="n" d="M${x1} ${y1}L${x2} ${y2}"/>` });
    }
  }
  pieces.sort((one, other) => other.depth - one.depth);
  // Attributes and not classes: a style sheet in a drawing is one of the page that it is put into.
  const dashed = `fill="none" stroke="${hex(colours.negative)}" stroke-width="1.4" stroke-dasharray="5 3.5"`;
  const body = pieces.map(({ text }) => text.replace('class="n"', dashed)).join('\n');
  const [w, h] = [width, height].map(Math.round);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${w}" height="${h}" viewBox="0 0 ${w} ${h}">
<g stroke="${hex(colours.edge)}" stroke-width="0.7" stroke-linejoin="round">
${body}
</g>
</svg>
`;

  function fillFor(of: View): (corners: Int32Array, light: number) => Vector3 {
    const coloured = colouring(state, results);
    const shown: { values: Float64Array | null; range: Interval; map: ColourMap } | null =
      of === 'delta' ? results.difference : coloured && { ...coloured, values: coloured.values[of] };
    if (!shown?.values) return (_, light) => plain(colours, light);
    const { values, range } = shown;
    const table = colourMap(shown.map);
    return (corners, light) => {
      const mean = corners.reduce((sum, vertex) => sum + (values[vertex] ?? Number.NaN), 0) / corners.length;
      if (!Number.isFinite(mean)) return plain(colours, light);
      const t = Math.min(1, Math.max(0, (mean - range.min) / (range.max - range.min || 1)));
      const from = 4 * Math.round(255 * t);
      return new Vector3(table[from], table[from + 1], table[from + 2]).multiplyScalar((0.78 + 0.22 * light) / 255);
    };
  }
}

const light = new Vector3(...lightFrom).normalize();
/** As in surface.ts: from whichever side a face is seen. */
function lightOn(normal: Vector3, eye: Vector3): number {
  return 0.5 + 0.5 * (normal.dot(eye) > 0 ? -1 : 1) * normal.dot(light);
}

const vector = (coordinates: Float32Array, k: number) => new Vector3().fromArray(coordinates, 3 * k);
const plain = ({ shade, lit }: Colours, light: number) => shade.clone().lerp(lit, light * light);
