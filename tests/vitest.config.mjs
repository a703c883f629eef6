import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const root = fileURLToPath(new URL('..', import.meta.url));

/** One project per folder of tests: `vitest run --config tests/vitest.config.mjs --project repo`. */
const project = (name, test = {}) => ({
  root,
  test: { name, include: [`tests/${name}/**/*.test.{ts,mjs}`], environment: 'node', allowOnly: false, ...test },
});

export default defineConfig({
  root,
  test: {
    projects: [
      project('repo', { testTimeout: 60_000 }),
      project('wasm', { testTimeout: 60_000 }),
      // One browser at a time: it draws in software, and shares two cores with the page's worker.
      project('web', { testTimeout: 120_000, hookTimeout: 120_000, fileParallelism: false }),
    ],
  },
});
