/** Takes the place of web/src/public-file.ts where a file carries in itself what else lies beside the page. */
import files from 'inlined:files';
import { unpack } from './unpack.js';

const types: Record<string, string> = { svg: 'image/svg+xml', json: 'application/json', obj: 'text/plain' };

let opened: ReadonlyMap<string, Blob> | undefined;
const addresses = new Map<string, string>();

async function open(): Promise<ReadonlyMap<string, Blob>> {
  const texts = (await (await unpack(files)).json()) as Record<string, string>;
  const blob = ([path, text]: [string, string]) =>
    [path, new Blob([text], { type: types[path.replace(/.*\./, '')] ?? '' })] as const;
  opened ??= new Map(Object.entries(texts).map(blob));
  return opened;
}

/** As in public-file.ts. */
export async function publicFile(path: string, signal?: AbortSignal): Promise<Blob> {
  const file = (opened ?? (await open())).get(path);
  signal?.throwIfAborted();
  if (!file) throw new Error(`there is no ${path} in this file`);
  return file;
}

/** As in public-file.ts, once any file has been had. */
export function publicUrl(path: string): string {
  const file = opened?.get(path);
  const address = addresses.get(path) ?? (file ? URL.createObjectURL(file) : '');
  addresses.set(path, address);
  return address;
}
