// `npm run bench [native] [browser]`: measures, and writes build/bench/*.json, results.json, RESULTS.md and the README's lines about speed.
// `npm run bench native -- --largest 100000` keeps to small meshes, `npm run bench write` only writes the texts anew, from results.json.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build, configure, ensureModules, ensurePackages, root, run, runMain } from '../../.ci/build.mjs';
import { resultsMarkdown, withSpeed } from './results.mjs';

const path = (name) => join(root, name);
const stored = path('tests/bench/results.json');
const readJson = (name) => JSON.parse(readFileSync(name, 'utf8'));

/** The commit that is measured; with a plus where what is measured differs from it. */
function commit() {
  const git = (...words) => execFileSync('git', ['-c', 'safe.directory=*', ...words], { cwd: root, encoding: 'utf8' });
  const changed = git(
    'status',
    '--porcelain',
    '--',
    'core',
    'wasm',
    'tests/bench/native',
    'tests/bench/browser',
  ).trim();
  return git('rev-parse', '--short=10', 'HEAD').trim() + (changed ? '+' : '');
}

const words = process.argv.slice(2);
const limits = words.includes('--largest') ? words.splice(words.indexOf('--largest'), 2) : [];

const parts = {
  async native(json) {
    await ensurePackages('native', 'bench');
    await configure('bench');
    await build('bench', ['polylap_bench']);
    // Eigen and polylap use one thread; so must the peers. OpenBLAS may be older than the processor, and not know by itself how wide it is.
    const processor = existsSync('/proc/cpuinfo') ? readFileSync('/proc/cpuinfo', 'utf8') : '';
    const wide = /\bavx512f\b/.test(processor) ? { OPENBLAS_CORETYPE: 'SkylakeX' } : {};
    const env = { ...wide, OPENBLAS_NUM_THREADS: '1', OMP_NUM_THREADS: '1' };
    await run(path('build/bench/tests/bench/polylap_bench'), ['--json', json, ...limits], { env });
  },
  async browser(json) {
    await ensurePackages('browser');
    await ensureModules();
    await run(process.execPath, [path('tests/bench/browser/run.mjs'), json, ...limits]);
  },
};

/** One run of a part: {date, commit, minutes, …what it measured}. */
async function measure(part) {
  const start = performance.now();
  const json = path(`build/bench/${part}.json`);
  const about = { date: new Date().toISOString(), commit: commit() };
  await parts[part](json);
  return { ...about, minutes: Number(((performance.now() - start) / 60_000).toFixed(1)), ...readJson(json) };
}

/** One row a line, so that runs can be compared. */
function format(results) {
  const line = (row) => JSON.stringify(row);
  const parts = Object.entries(results).map(([part, { rows, ...about }]) => {
    const head = line(about).slice(0, -1);
    return `"${part}": ${head}, "rows": [\n${rows.map(line).join(',\n')}\n]}`;
  });
  return `{\n${parts.join(',\n')}\n}\n`;
}

function write(results) {
  writeFileSync(path('tests/bench/RESULTS.md'), resultsMarkdown(results));
  const readme = readFileSync(path('README.md'), 'utf8');
  writeFileSync(path('README.md'), withSpeed(readme, results));
}

await runMain(async () => {
  const unknown = words.find((part) => !(part in parts) && part !== 'write');
  if (unknown)
    throw new Error(`usage: npm run bench [native] [browser] [write] [-- --largest VERTICES], not ${unknown}`);
  mkdirSync(path('build/bench'), { recursive: true });
  const results = existsSync(stored) ? readJson(stored) : {};
  const available = Object.keys(parts).filter(
    (part) => part !== 'browser' || existsSync(path('tests/bench/browser/run.mjs')),
  );
  for (const part of words.length > 0 ? words.filter((name) => name in parts) : available) {
    results[part] = await measure(part);
  }
  writeFileSync(stored, format(results));
  write(results);
});
