// What lies beside the page, in Node: takes the place of src/public-file.ts, where nothing is fetched.
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const addressOf = (path) => new URL(`../build/public/${path}`, import.meta.url);

export const publicFile = async (path) => new Blob([await readFile(addressOf(path))]);
export const publicUrl = (path) => addressOf(path).href;

/** Vite: whoever imports that in Node imports this. */
export const nodeFiles = () => ({
  name: 'node-files',
  enforce: 'pre',
  resolveId: (source, _importer, { ssr }) =>
    ssr && /\/public-file\.js$/.test(source) ? fileURLToPath(import.meta.url) : null,
});
