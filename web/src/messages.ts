import { type Mesh, PolylapError } from './polylap.js';
import type { Message } from './results.js';
import { t, told, word } from './words.js';

const manyFaces = 200_000;

/** The error's own words as a sentence, with the line in front if they do not name it. */
export function explain(reason: unknown): string {
  if (reason instanceof PolylapError && reason.code === 'out-of-memory')
    return t(
      'There is not enough memory for it. Take a smaller mesh, or the command line, which may use all there is.',
    );
  const message = reason instanceof Error ? reason.message : String(reason);
  const named = !(reason instanceof PolylapError) || reason.line < 1 || /\bline\b/i.test(message);
  const text = told(named ? message : `line ${reason.line}: ${message}`);
  return sentence(`${text.charAt(0).toUpperCase()}${text.slice(1)}`);
}

const sentence = (text: string) => (/[.!?]$/.test(text) ? text : `${text}.`);

/** What there is to know about a mesh that has come in. */
export function describe(mesh: Mesh, label: string): string {
  const parts = [
    `${label}: ${t('{n} vertex|{n} vertices', { n: mesh.vertices })}, ${t('{n} face|{n} faces', { n: mesh.faces })}.`,
  ];
  for (const { message } of mesh.issues) parts.push(sentence(told(message)));
  if (mesh.faces > manyFaces) parts.push(t('A large mesh: a step may take seconds.'));
  return parts.join(' ');
}

/** What reading and repairing did to a file; null if nothing. */
export function reportOf({ notes, repairs }: Pick<Mesh, 'notes' | 'repairs'>, label: string): Message | null {
  const list = [...repairs.changes.map(({ message }) => message), ...notes].map((message) => sentence(told(message)));
  if (list.length > 0)
    return {
      title: t(repairs.changes.length > 0 ? word('{label}: what was changed') : word('{label}: what was read'), {
        label,
      }),
      text: '',
      list,
    };
  const looked = repairs.originalFaces.length > 0;
  return looked ? { title: `${label}`, text: t('There was nothing to repair.') } : null;
}
