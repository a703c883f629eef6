/** The whole state as the hash of a link, and back. Nothing leaves the machine: the part of an address after # is never sent. */
import { readState } from './read-state.js';
import type { State } from './state.js';

/** Beyond so many characters, programs cut links off; a file that makes it longer is left out. */
const longestLink = 60_000;

export interface Link {
  /** With the # in front. */
  hash: string;
  /** Whether the file is left out, because it is too large. */
  withoutFile: boolean;
}

/** @param file what the state's source was opened from, if that is a file */
export async function linkOf(state: State, file: Blob | null): Promise<Link> {
  const stored = state.source.kind === 'file' ? { ...state, source: { ...state.source, file: undefined } } : state;
  const hash = `#v=${state.version}&s=${await pack(new Blob([JSON.stringify(stored)]))}`;
  if (!file) return { hash, withoutFile: false };
  // What is larger by so much is not small when packed.
  const packed = file.size < 100 * longestLink ? `&m=${await pack(file)}` : null;
  const fits = packed !== null && hash.length + packed.length <= longestLink;
  return { hash: fits ? hash + packed : hash, withoutFile: !fits };
}

/** @returns null where the hash is none of ours. @throws Error, a sentence, where it is one that cannot be read */
export async function readLink(hash: string): Promise<{ state: State; file: Blob | null } | null> {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const [version, packed, mesh] = [parts.get('v'), parts.get('s'), parts.get('m')];
  if (version === null || packed === null) return null;
  const text = await unpack(packed).then((blob) => blob.text());
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new Error('a part of it is missing');
  }
  return { state: readState(value), file: mesh === null ? null : await unpack(mesh) };
}

async function pack(blob: Blob): Promise<string> {
  const stream = blob.stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let text = '';
  for (let k = 0; k < bytes.length; k += 0x8000) text += String.fromCharCode(...bytes.subarray(k, k + 0x8000));
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

async function unpack(text: string): Promise<Blob> {
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    return await new Response(stream).blob();
  } catch {
    throw new Error('a part of it is missing');
  }
}
