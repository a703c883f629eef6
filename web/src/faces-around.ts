import type { Geometry } from './polylap.js';

/** Per vertex, its faces: those of v are faces[starts[v]] … faces[starts[v + 1] - 1], ascending. */
interface Around {
  starts: Int32Array;
  faces: Int32Array;
}

const known = new WeakMap<Int32Array, Around>();

/** The faces around a vertex; found for all vertices at once, the first time. */
export function facesAround({ offsets, corners, positions }: Geometry, vertex: number): Int32Array {
  let around = known.get(corners);
  if (!around) {
    around = gather(offsets, corners, positions.length / 3);
    known.set(corners, around);
  }
  return around.faces.subarray(around.starts[vertex], around.starts[vertex + 1]);
}

function gather(offsets: Int32Array, corners: Int32Array, vertices: number): Around {
  const starts = new Int32Array(vertices + 1);
  for (const v of corners) (starts[v + 1] as number)++;
  for (let v = 0; v < vertices; v++) (starts[v + 1] as number) += starts[v] as number;
  const next = starts.slice();
  const faces = new Int32Array(corners.length);
  for (let f = 0; f + 1 < offsets.length; f++)
    for (let c = offsets[f] as number; c < (offsets[f + 1] as number); c++)
      faces[(next[corners[c] as number] as number)++] = f;
  return { starts, faces };
}
