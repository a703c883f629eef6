// The pages that are light: readable as they come, with a small script. Built apart from the full page, so that neither is cut up for the other's sake.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { figureWords } from './figures/words.mjs';
import { threeParts } from './three-parts.mjs';

const file = (name) => fileURLToPath(new URL(name, import.meta.url));

export default defineConfig({
  root: file('.'),
  configFile: false,
  base: './',
  publicDir: false,
  plugins: [figureWords(), threeParts()],
  worker: { format: 'es' },
  build: {
    outDir: file('../dist'),
    emptyOutDir: false,
    target: ['chrome123', 'firefox121', 'safari17.5'],
    manifest: 'light.json',
    rollupOptions: {
      // How long plugins take is nobody's concern.
      checks: { pluginTimings: false },
      input: { figures: file('figures/page.ts'), thesis: file('thesis/article.ts'), class: file('class/class.ts') },
    },
  },
});
