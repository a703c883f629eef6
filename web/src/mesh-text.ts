/** What can be told of a mesh file without reading it: cheap, so that the worker need not run out of memory to find out. */
import type { MeshFormat } from './polylap.js';

export const formats: readonly MeshFormat[] = ['obj', 'off', 'ply', 'stl'];
/** The extension of a name that is a format, or null. */
export function formatOf(name: string): MeshFormat | null {
  const ending = name.toLowerCase().replace(/^.*\./, '');
  return formats.find((format) => format === ending) ?? null;
}

/** Which format a text is in; null if it is no mesh. */
export function formatOfText(text: string): MeshFormat | null {
  const start = text.replace(/^\uFEFF/, '').trimStart();
  if (/^ply\s*\n/.test(start)) return 'ply';
  if (/^(#.*\s)*(ST|C|N|4|n)*OFF\b/.test(start)) return 'off';
  if (/^solid\b[\s\S]*\bfacet\b/.test(start)) return 'stl';
  return /^\s*v\s+[-+.\d]/m.test(text) ? 'obj' : null;
}

/** From this size on OBJ files are counted, by their lines. */
const worthCounting = 8e6;
/** Headers are shorter. */
const headerBytes = 4096;
/** A triangle of an STL file: twelve floats and two bytes; as text seldom less than this. */
const [stlBytes, stlTextBytes] = [50, 200];

/** Faces that a file says it has, or has by its lines; 0 where nothing can be said. */
export async function countFaces(file: Blob, name: string): Promise<number> {
  const format = formatOf(name);
  if (format === 'obj') return file.size < worthCounting ? 0 : countLines(file);
  const head = new Uint8Array(await file.slice(0, headerBytes).arrayBuffer());
  const text = new TextDecoder('latin1').decode(head);
  if (format === 'ply') return Number(/^element\s+face\s+(\d+)/m.exec(text)?.[1] ?? 0);
  if (format === 'stl') {
    const facets = head.length >= 84 ? new DataView(head.buffer).getUint32(80, true) : 0;
    if (file.size === 84 + stlBytes * facets) return facets;
    return /^\s*solid\b/.test(text) ? Math.floor(file.size / stlTextBytes) : 0;
  }
  if (format === 'off') return offFaces(text, head);
  return 0;
}

function offFaces(text: string, head: Uint8Array): number {
  const binary = /^\s*\w*OFF\s+BINARY[^\n]*\n/.exec(text)?.[0].length;
  if (binary !== undefined) {
    if (head.length < binary + 8) return 0;
    const view = new DataView(head.buffer);
    // In either byte order; the wrong one makes small numbers large.
    return Math.min(view.getUint32(binary + 4, true), view.getUint32(binary + 4, false));
  }
  const numbers = text
    .replace(/#.*$/gm, '')
    .replace(/^\s*\w*OFF\b/, '')
    .trim()
    .split(/\s+/);
  return Number.parseInt(numbers[1] ?? '', 10) || 0;
}

async function countLines(file: Blob): Promise<number> {
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
