import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { threeParts } from './three-parts.mjs';

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  // What web/gallery.mjs makes.
  publicDir: fileURLToPath(new URL('../build/public', import.meta.url)),
  plugins: [threeParts()],
  worker: { format: 'es' },
  // The module and its wasm live beside web/.
  server: { fs: { allow: ['..'] } },
  build: {
    outDir: '../dist',
    emptyOutDir: true,
    // light-dark() in the style sheet sets the floor.
    target: ['chrome123', 'firefox121', 'safari17.5'],
    chunkSizeWarningLimit: 800,
  },
});
