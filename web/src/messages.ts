import { plural } from './format.js';
import { type Mesh, PolylapError } from './polylap.js';
import type { Message } from './results.js';

const manyFaces = 200_000;

/** The error's own words as a sentence, with the line in front if they do not name it. */
export function explain(reason: unknown): string {
  if (reason instanceof PolylapError && reason.code === 'out-of-memory')
    return 'There is not enough memory for it. Take a smaller mesh, or the command line, which may use all there is.';
  const message = reason instanceof Error ? reason.message : String(reason);
  const named = !(reason instanceof PolylapError) || reason.line < 1 || /\bline\b/i.test(message);
  const text = named ? message : `line ${reason.line}: ${message}`;
  return sentence(`${text.charAt(0).toUpperCase()}${text.slice(1)}`);
}

const sentence = (text: string) => (/[.!?]$/.test(text) ? text : `${text}.`);

/** What there is to know about a mesh that has come in. */
export function describe(mesh: Mesh, label: string): string {
  const parts = [`${label}: ${plural(mesh.vertices, 'vertex', 'vertices')}, ${plural(mesh.faces, 'face')}.`];
  for (const { message } of mesh.issues) parts.push(sentence(message));
  if (mesh.faces > manyFaces) parts.push('A large mesh: a step may take seconds.');
  return parts.join(' ');
}

/** What reading and repairing did to a file; null if nothing. */
export function reportOf({ notes, repairs }: Pick<Mesh, 'notes' | 'repairs'>, label: string): Message | null {
  const list = [...repairs.changes.map(({ message }) => sentence(message)), ...notes.map(sentence)];
  if (list.length > 0)
    return {
      title: repairs.changes.length > 0 ? `${label}: what was changed` : `${label}: what was read`,
      text: '',
      list,
    };
  const looked = repairs.originalFaces.length > 0;
  return looked ? { title: `${label}`, text: 'There was nothing to repair.' } : null;
}
