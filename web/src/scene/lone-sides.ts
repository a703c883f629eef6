/**
 * The polygon edges at the boundary.
 * @param triangles 3T vertices
 * @param edges T; bit k: side k → k+1 is an edge of a polygon
 * @returns T; bit k: side k is an edge of a polygon and of no other
 */
export function loneSides(triangles: Int32Array, edges: Uint8Array, vertexCount: number): Uint8Array {
  const ends = (side: number) => {
    const first = side - (side % 3);
    const i = triangles[side] as number;
    const j = triangles[first + ((side + 1) % 3)] as number;
    return i < j ? ([i, j] as const) : ([j, i] as const);
  };
  const drawn = (side: number) => (((edges[Math.floor(side / 3)] as number) >> (side % 3)) & 1) === 1;

  // The sides by their smaller vertex; then, around each of these, how many go to the same other one.
  const starts = new Int32Array(vertexCount + 1);
  for (let side = 0; side < triangles.length; side++) if (drawn(side)) (starts[ends(side)[0]] as number)++;
  let total = 0;
  for (let v = 0; v <= vertexCount; v++) {
    total += starts[v] as number;
    starts[v] = total;
  }
  const sides = new Int32Array(total);
  for (let side = 0; side < triangles.length; side++)
    if (drawn(side)) {
      const at = --(starts[ends(side)[0]] as number);
      sides[at] = side;
    }
  const times = new Int32Array(vertexCount);
  const lone = new Uint8Array(edges.length);
  for (let v = 0; v < vertexCount; v++) {
    const around = sides.subarray(starts[v], starts[v + 1]);
    for (const side of around) (times[ends(side)[1]] as number)++;
    for (const side of around)
      if (times[ends(side)[1]] === 1) (lone[Math.floor(side / 3)] as number) |= 1 << (side % 3);
    for (const side of around) times[ends(side)[1]] = 0;
  }
  return lone;
}
