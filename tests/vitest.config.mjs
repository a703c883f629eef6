import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { nodeFiles } from '../web/node-files.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));

/** One project per folder of tests: `vitest run --config tests/vitest.config.mjs --project repo`. */
const project = (name, test = {}) => ({
  root,
  // The modules of the page find here what lies beside it there.
  plugins: name === 'web' ? [nodeFiles()] : [],
  test: { name, include: [`tests/${name}/**/*.test.{ts,mjs}`], environment: 'node', allowOnly: false, ...test },
});

export default defineConfig({
  root,
  test: {
    projects: [
      project('repo', { testTimeout: 60_000 }),
      project('wasm', { testTimeout: 60_000 }),
      // One browser at a time: it draws in software, and shares two cores with the page's worker.
      project('web', {
        testTimeout: 120_000,
        hookTimeout: 120_000,
        fileParallelism: false,
        // What is waited for comes when it comes.
        expect: { poll: { timeout: 30_000 } },
      }),
    ],
  },
});
