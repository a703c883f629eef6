// What lies beside the page, in Node: takes the place of src/public-file.ts, where nothing is fetched.
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const addressOf = (path) => new URL(`../build/public/${path}`, import.meta.url);

export const publicFile = async (path) => new Blob([await readFile(addressOf(path))]);
export const publicUrl = (path) => addressOf(path).href;

/** Vite: whoever imports that imports this. */
export const nodeFiles = () => ({
  name: 'node-files',
  enforce: 'pre',
  resolveId: (source) => (/\/public-file\.js$/.test(source) ? fileURLToPath(import.meta.url) : null),
});
