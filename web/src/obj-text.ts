/** OBJ text has a line that defines a vertex. */
export const looksLikeObj = (text: string) => /^\s*v\s+[-+.\d]/m.test(text);

/** Faces of an OBJ file, by its lines; 0 for what is no OBJ. Cheap, so that the worker need not run out of memory to find out. */
export async function countFaces(file: Blob, name: string): Promise<number> {
  if (!/\.obj$/i.test(name) || file.size < 8e6) return 0;
  let faces = 0;
  let atStart = true;
  for (let at = 0; at < file.size; at += 4e6) {
    for (const byte of new Uint8Array(await file.slice(at, at + 4e6).arrayBuffer())) {
      if (atStart && byte === 102) faces++;
      atStart = byte === 10;
    }
  }
  return faces;
}
