// Small pictures for the gallery: a mesh as SVG, far faces first, flat shading in tones that stand on light and dark paper alike.
/** Whole numbers are a tenth of a pixel where it is shown. */
const [width, height, margin] = [1600, 1120, 50];
/** From the darkest to the lightest. */
const tones = ['#8b8983', '#9a9892', '#a9a7a1', '#b8b6b0', '#c7c5bf', '#d6d4ce', '#e5e3dd', '#f1efe9'];
const edge = '#4d4d52';

const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const dot = ([a, b, c], [d, e, f]) => a * d + b * e + c * f;
const unit = (v) => v.map((c) => c / (Math.hypot(...v) || 1));

/**
 * @param positions 3V coordinates
 * @param offsets F+1
 * @param corners one vertex per corner of a face
 * @param yUp whether y is up, as in most files, and not z
 */
export function thumbnail({ positions, offsets, corners }, { closed, yUp }) {
  const point = (v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const extent = [0, 1, 2].map((axis) => spread(positions, axis));
  const isFlat = extent[2] < 0.2 * Math.max(extent[0], extent[1]);
  const up = yUp && !isFlat ? [0, 1, 0] : isFlat ? [0, 1, 0] : [0, 0, 1];
  // Flat meshes are seen from above, relief from nearly above, bodies from a little to the side.
  const relief = isFlat && extent[2] > 0 ? [0.25, -0.75, 1] : [0, 0, 1];
  const toEye = unit(isFlat ? relief : up[1] ? [-0.35, 0.3, 1] : [0.55, -1, 0.75]);
  const right = unit(cross(up, toEye));
  const above = cross(toEye, right);
  const light = unit([0, 1, 2].map((k) => toEye[k] + 0.5 * above[k] - 0.45 * right[k]));

  const seen = Array.from({ length: positions.length / 3 }, (_, v) => [dot(point(v), right), -dot(point(v), above)]);
  const place = fitting(seen);
  const faces = [];
  for (let f = 0; f + 1 < offsets.length; f++) {
    const face = Array.from(corners.subarray(offsets[f], offsets[f + 1]));
    const normal = unit(vectorArea(face.map(point)));
    if (closed && dot(normal, toEye) <= 0) continue;
    const depth = face.reduce((sum, v) => sum + dot(point(v), toEye), 0) / face.length;
    const lit = Math.abs(dot(normal, light));
    faces.push({
      depth,
      tone: Math.min(tones.length - 1, Math.floor(tones.length * lit)),
      path: pathOf(face.map((v) => place(seen[v]))),
    });
  }
  faces.sort((one, other) => one.depth - other.depth);
  const thin = faces.length > 700 ? 2 : 6;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}"><g stroke="${edge}" stroke-width="${thin}" stroke-linejoin="round">${merged(faces)}</g></svg>\n`;
}

function spread(positions, axis) {
  let [low, high] = [Infinity, -Infinity];
  for (let k = axis; k < positions.length; k += 3)
    [low, high] = [Math.min(low, positions[k]), Math.max(high, positions[k])];
  return high - low;
}

function vectorArea(points) {
  const area = [0, 0, 0];
  for (const [k, p] of points.entries())
    cross(p, points[(k + 1) % points.length]).forEach((c, axis) => {
      area[axis] += c / 2;
    });
  return area;
}

/** Takes points of the plane into the picture. */
function fitting(points) {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min((width - 2 * margin) / (right - left || 1), (height - 2 * margin) / (bottom - top || 1));
  return ([x, y]) => [width / 2 + scale * (x - (left + right) / 2), height / 2 + scale * (y - (top + bottom) / 2)];
}

/** From corner to corner: short numbers. */
function pathOf(points) {
  const rounded = points.map((p) => p.map(Math.round));
  const steps = rounded.slice(1).flatMap(([x, y], k) => [x - rounded[k][0], y - rounded[k][1]]);
  return `M${rounded[0].join(' ')}l${steps.join(' ').replaceAll(' -', '-')}z`;
}

/** Neighbours of one tone share an element. */
function merged(faces) {
  let text = '';
  for (const [k, { tone, path }] of faces.entries()) {
    text += tone === faces[k - 1]?.tone ? path : `${k ? '"/>' : ''}<path fill="${tones[tone]}" d="${path}`;
  }
  return `${text}"/>`;
}
