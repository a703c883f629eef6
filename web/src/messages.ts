import { plural } from './format.js';
import { type Mesh, PolylapError } from './polylap.js';

const manyFaces = 200_000;

/** The error's own words as a sentence, with the line in front if they do not name it. */
export function explain(reason: unknown): string {
  const message = reason instanceof Error ? reason.message : String(reason);
  const named = !(reason instanceof PolylapError) || reason.line < 1 || /\bline\b/i.test(message);
  const text = named ? message : `line ${reason.line}: ${message}`;
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`;
}

/** What there is to know about a mesh that has come in. */
export function describe(mesh: Mesh, label: string): string {
  const parts = [`${label}: ${plural(mesh.vertices, 'vertex', 'vertices')}, ${plural(mesh.faces, 'face')}.`];
  for (const issue of mesh.issues) parts.push(`${issue.message.replace(/\.?$/, '.')}`);
  if (mesh.faces > manyFaces) parts.push('A large mesh: a step may take seconds.');
  return parts.join(' ');
}
