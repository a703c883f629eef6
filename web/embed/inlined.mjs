/** Vite plugins for files that carry everything in themselves: no request is made by them, wherever they are opened from. */
import { isUtf8 } from 'node:buffer';
import { createHash } from 'node:crypto';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import { build } from 'vite';
import { replace } from '../replace.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const pack = (bytes) => deflateRawSync(bytes, { level: 9, memLevel: 9 }).toString('base64');

/** What is put into the files: made once for all of them. */
export async function inlinedParts() {
  const [core, worker, files] = await Promise.all([
    readFile(join(root, 'build/wasm/polylap.wasm')),
    classicWorker(),
    publicFiles(),
  ]);
  return { core: pack(core), worker: pack(worker), files };
}

/** The worker with the loader of the whole core only, in one script. */
async function classicWorker() {
  const [{ output }] = await build({
    configFile: false,
    logLevel: 'warn',
    plugins: [
      replace({ 'build/wasm/polylap-core': 'build/wasm/polylap.js' }),
      {
        // The loader works out where its wasm would be, but makes its instance of the module it is given.
        name: 'nowhere',
        enforce: 'pre',
        transform: (code, id) =>
          id.endsWith('build/wasm/polylap.js') ? code.replaceAll('import.meta.url', "'file:'") : null,
      },
    ],
    build: {
      write: false,
      lib: { entry: join(root, 'wasm/src/worker.ts'), formats: ['iife'], name: 'worker' },
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  return output[0].code;
}

/** Path → text. */
async function publicFiles() {
  const folder = join(root, 'build/public');
  const texts = {};
  for (const name of (await readdir(folder, { recursive: true })).sort()) {
    if (!/\.\w+$/.test(name)) continue;
    const bytes = await readFile(join(folder, name));
    if (!isUtf8(bytes)) throw new Error(`${name} is not text: inlined-files.ts takes texts only`);
    texts[name.replaceAll('\\', '/')] = bytes.toString();
  }
  return texts;
}

/**
 * @param parts see inlinedParts
 * @param has whether a file of build/public can be asked for
 */
export function inlined({ core, worker, files }, has = (_path) => true) {
  const given = {
    core,
    worker,
    files: pack(JSON.stringify(Object.fromEntries(Object.entries(files).filter(([path]) => has(path))))),
  };
  const virtual = /^\0inlined:(core|worker|files)$/;
  return [
    replace({
      'wasm/src/create': 'web/embed/inlined-client.ts',
      'web/src/public-file': 'web/embed/inlined-files.ts',
    }),
    {
      name: 'inlined',
      resolveId: (source) => (virtual.test(`\0${source}`) ? `\0${source}` : null),
      load(id) {
        const [, part] = id.match(virtual) ?? [];
        return part ? `export default ${JSON.stringify(given[part])};` : null;
      },
    },
  ];
}

const hashOf = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** Puts the script there that is beside it. Its text is known to the policy, as if it had been there from the start. */
const starter = `(async () => {
  const text = atob(document.getElementById('packed').textContent);
  const bytes = Uint8Array.from(text, (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const script = document.createElement('script');
  script.type = 'module';
  script.textContent = await new Response(stream).text();
  document.head.append(script);
})().catch(() => document.body.prepend('This file needs a newer browser.'));`;

/** What such a file is allowed: what is in it, and nothing else. The policy is its own, so that the file can be kept anywhere. */
const policyOf = (scripts, styles) =>
  [
    "default-src 'none'",
    `script-src ${[...scripts.map(hashOf), "'wasm-unsafe-eval'"].join(' ')}`,
    'worker-src blob:',
    `style-src ${styles.map(hashOf).join(' ')}`,
    'img-src data: blob:',
    "connect-src 'none'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');

/**
 * A file that carries its script, packed, and its policy.
 * @param html without a script, its styles inline
 */
export function sealed(html, script) {
  // What a parser makes of line ends would change the hashes.
  if (html.includes('\r')) throw new Error('a file with a policy has plain line ends');
  if (/<script/i.test(html)) throw new Error('a file with a policy has no other script');
  const styles = [...html.matchAll(/<style\b[^>]*>([\s\S]*?)<\/style>/g)].map(([, text]) => text);
  const policy = policyOf([starter, script], styles);
  return html
    .replace(
      /<meta charset="[^"]*" ?\/?>/,
      (charset) => `${charset}\n<meta http-equiv="Content-Security-Policy" content="${policy}">`,
    )
    .replace(
      '</body>',
      () => `<script type="text/plain" id="packed">${pack(script)}</script>\n<script>${starter}</script>\n</body>`,
    );
}

/** What vite-plugin-singlefile has made, sealed. */
export function sealedPage(html) {
  const scripts = [...html.matchAll(/<script\b[^>]*>([\s\S]*?)<\/script>/g)];
  if (scripts.length !== 1) throw new Error(`one script is to be packed, not ${scripts.length}`);
  const [[element, script]] = scripts;
  return sealed(html.replace(element, ''), script);
}
