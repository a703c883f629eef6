// The browser benchmark: node tests/bench/browser/run.mjs OUTPUT [--largest VERTICES]. Drives page.ts in Chromium, and runs the same kernels natively.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { cpus, totalmem } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { chromium } from 'playwright-core';
import { createServer } from 'vite';
import { build, configure, ensurePackages, root, runMain } from '../../../.ci/build.mjs';

/** Tori of so many quads each way: 10k, 100k, 250k and 1M vertices. */
const sides = { small: 100, medium: 316, large: 500, largest: 1000 };

async function startPage() {
  const server = await createServer({
    root,
    configFile: false,
    logLevel: 'error',
    appType: 'mpa',
    worker: { format: 'es' },
    server: {
      port: 0,
      host: 'localhost',
      fs: { allow: [root, join(root, 'node_modules')], strict: false },
      hmr: false,
    },
    optimizeDeps: { noDiscovery: true },
  });
  await server.listen();
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking'],
  });
  const page = await browser.newPage();
  page.setDefaultTimeout(600_000);
  page.on('pageerror', (error) => console.error(`page: ${error.message}`));
  await page.goto(`http://localhost:${server.httpServer.address().port}/tests/bench/browser/index.html`);
  await page.waitForFunction(() => globalThis.bench);
  const ask = (name, ...words) =>
    page
      .evaluate(([job, given]) => globalThis.bench[job](...given), [name, words])
      .then((rows) => {
        for (const { name: what, n, value, unit } of rows)
          console.log(`${String(n).padStart(8)} ${what}: ${value.toPrecision(4)} ${unit}`);
        return rows;
      });
  const close = async () => {
    await browser.close();
    await server.close();
  };
  return { ask, close, version: browser.version() };
}

function native(side, repeats) {
  const program = join(root, 'build/bench/tests/bench/browser/polylap_bench_kernels');
  const text = execFileSync(program, [side, side, repeats, 0].map(String), { encoding: 'utf8' });
  return JSON.parse(text).map((row) => ({ ...row, name: `native ${row.name}` }));
}

await runMain(async () => {
  const output = resolve(process.argv[2] ?? join(root, 'build/bench/browser.json'));
  const at = process.argv.indexOf('--largest');
  const limit = at < 0 ? Number.POSITIVE_INFINITY : Number(process.argv[at + 1]);
  const fits = (side) => side * side <= limit;
  await ensurePackages('native', 'wasm');
  await configure('bench');
  await build('bench', ['polylap_bench_kernels']);
  await build('wasm', ['polylap_bindings', 'polylap_bench_kernels']);

  const { ask, close, version } = await startPage();
  const rows = [];
  try {
    rows.push(...(await ask('starting', 32)));
    rows.push(...(await ask('smoothing', sides.small)));
    for (const side of [sides.medium, sides.large].filter(fits)) {
      rows.push(...(await ask('kernels', side, side, 5, true)), ...native(side, 5));
    }
    rows.push(...(await ask('pins', sides.medium)));
    if (fits(sides.large)) rows.push(...(await ask('core', 'loading', sides.large)));
    if (fits(sides.largest)) {
      rows.push(...(await ask('kernels', sides.largest, sides.largest, 1, false)), ...native(sides.largest, 1));
      rows.push(...(await ask('core', 'largest', sides.largest)));
    }
  } finally {
    await close();
  }
  mkdirSync(dirname(output), { recursive: true });
  const machine = {
    processor: cpus()[0]?.model ?? '',
    cores: cpus().length,
    memory: Math.round(totalmem() / 1e9),
    browser: `Chromium ${version}`,
  };
  writeFileSync(output, `${JSON.stringify({ machine, rows }, null, 1)}\n`);
});
