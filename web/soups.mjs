// Polygons that no modeller would make, for the gallery: concave, with many corners, in no plane. OBJ text, the same on every machine.

/** Numbers in [0, 1) from a whole seed (Mulberry32). */
function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}

const line = (letter, values) => `${letter} ${values.join(' ')}\n`;
export const obj = (points, faces) =>
  points
    .map((p) =>
      line(
        'v',
        p.map((c) => Number(c.toFixed(4)) + 0),
      ),
    )
    .join('') +
  faces
    .map((face) =>
      line(
        'f',
        face.map((v) => v + 1),
      ),
    )
    .join('');

/** The quad of Herholz 2012, Figure 4.6, with our own proportions: one of its diagonals gets a negative weight, the other one less of it. */
export const quad = () =>
  obj(
    [
      [0, 0, 0],
      [1.6, 0.15, 0],
      [1.9, 1, 0],
      [-0.1, 0.9, 0],
    ],
    [[0, 1, 2, 3]],
  );

/** Polygons of 5 to 11 corners that touch nowhere, most of them concave, on a wavy ground. */
export function polygonSoup({ columns = 6, rows = 4, seed = 4 } = {}) {
  const next = random(seed);
  const [points, faces] = [[], []];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const corners = 5 + Math.floor(7 * next());
      const turn = 2 * Math.PI * next();
      faces.push(Array.from({ length: corners }, (_, k) => points.length + k));
      for (let k = 0; k < corners; k++) {
        const angle = turn + (2 * Math.PI * (k + 0.5 * (next() - 0.5))) / corners;
        const radius = 0.12 + 0.35 * next();
        const [x, y] = [column + radius * Math.cos(angle), row + radius * Math.sin(angle)];
        points.push([x, y, 0.12 * Math.sin(2.1 * x) * Math.cos(2.3 * y)]);
      }
    }
  }
  return obj(points, faces);
}

/**
 * Faces of a mesh grown together at random into polygons of many corners.
 * @param points one [x, y, z] a vertex
 * @param faces the vertices of each, all turned alike
 * @param size at most so many faces become one
 */
export function patchwork(points, faces, { size = 4, seed = 3 } = {}) {
  const next = random(seed);
  const owner = new Map(); // directed edge → face
  const edgesOf = (face) => face.map((v, k) => [v, face[(k + 1) % face.length]]);
  for (const [f, face] of faces.entries()) for (const [v, w] of edgesOf(face)) owner.set(`${v},${w}`, f);
  const taken = new Set();
  const patches = [];
  for (const start of faces.keys()) {
    if (taken.has(start)) continue;
    let patch = [start];
    let outline = faces[start];
    taken.add(start);
    const wanted = 1 + Math.floor(size * next());
    for (let attempt = 0; attempt < 4 * size && patch.length < wanted; attempt++) {
      const k = Math.floor(outline.length * next());
      const neighbour = owner.get(`${outline[(k + 1) % outline.length]},${outline[k]}`);
      if (neighbour === undefined || taken.has(neighbour)) continue;
      const grown = outlineOf([...patch, neighbour].flatMap((f) => edgesOf(faces[f])));
      if (!grown) continue;
      patch = [...patch, neighbour];
      outline = grown;
      taken.add(neighbour);
    }
    patches.push(outline);
  }
  const used = [...new Set(patches.flat())].sort((v, w) => v - w);
  const number = new Map(used.map((v, k) => [v, k]));
  return obj(
    used.map((v) => points[v]),
    patches.map((patch) => patch.map((v) => number.get(v))),
  );
}

/** The one simple loop around faces with these directed edges; null if there is no such loop. */
function outlineOf(edges) {
  const there = new Set(edges.map((edge) => edge.join()));
  const rim = edges.filter(([v, w]) => !there.has(`${w},${v}`));
  const after = new Map(rim);
  if (after.size !== rim.length) return null;
  const loop = [rim[0][0]];
  for (let v = after.get(loop[0]); v !== loop[0]; v = after.get(v)) loop.push(v);
  return loop.length === rim.length ? loop : null;
}
