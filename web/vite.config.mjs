import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { lightPages } from './light-dev.mjs';
import { replace } from './replace.mjs';
import { threeParts } from './three-parts.mjs';

/** Has the browser fetch the core while it fetches the script that asks for it. */
const earlyCore = () => ({
  name: 'early-core',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: (_html, { bundle }) => {
      const core = Object.keys(bundle).find((file) => /polylap-core-[^/]*\.wasm$/.test(file));
      if (!core) throw new Error('polylap-core.wasm is not part of the build');
      const attrs = { rel: 'preload', as: 'fetch', crossorigin: true, href: `./${core}` };
      return [{ tag: 'link', attrs, injectTo: 'head' }];
    },
  },
});

// light-dark() in the style sheet sets the floor.
export const target = ['chrome123', 'firefox121', 'safari17.5'];

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  // What web/gallery.mjs makes.
  publicDir: fileURLToPath(new URL('../build/public', import.meta.url)),
  plugins: [threeParts(), earlyCore(), lightPages(), replace({ 'web/embed/home': 'web/embed/page-home.ts' })],
  worker: { format: 'es' },
  // The module and its wasm live beside web/.
  server: { fs: { allow: ['..'] } },
  build: {
    outDir: '../dist',
    emptyOutDir: true,
    target,
    chunkSizeWarningLimit: 800,
  },
});
