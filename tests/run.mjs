// `npm test`: everything, from a machine that has only Node. Closes with one line, `N passed, N failed`; a skipped test counts as failed.
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import {
  build,
  buildSite,
  configure,
  ensureModules,
  ensurePackages,
  root,
  run,
  runMain,
  runTool,
} from '../.ci/build.mjs';
import { countJunit, countVitest, runSteps, summary } from './steps.mjs';

const results = join(root, 'build/results');

/** Runs a test runner, then counts what it wrote down, whether or not it ended well. */
async function counted(file, read, start) {
  const path = join(results, file);
  let failure;
  await start(path).catch((error) => {
    failure = error;
  });
  if (!existsSync(path)) throw failure ?? new Error(`${file} was not written`);
  const count = read(readFileSync(path, 'utf8'));
  // A runner that fails without a failing test (a suite that cannot load, a leak at exit) has failed all the same.
  if (failure && count.failed === 0) return { ...count, failed: 1 };
  return count;
}

const ctest = (preset) =>
  counted(`${preset}.xml`, countJunit, (path) => run('ctest', ['--preset', preset, '--output-junit', path]));

const vitest = (project) =>
  counted(`${project}.json`, countVitest, (path) =>
    runTool('vitest', [
      'run',
      '--config',
      'tests/vitest.config.mjs',
      '--project',
      project,
      '--reporter=default',
      '--reporter=json',
      `--outputFile.json=${path}`,
    ]),
  );

const steps = [
  { id: 'packages', title: 'System packages', work: () => ensurePackages() },
  { id: 'modules', title: 'Node packages', work: ensureModules },
  { id: 'configure', title: 'Configure', needs: ['packages'], work: () => configure('native') },
  { id: 'native', title: 'Native build', needs: ['configure'], work: () => build('native') },
  { id: 'native-tests', title: 'Native tests', needs: ['native'], work: () => ctest('native') },
  { id: 'asan', title: 'Sanitizer build', needs: ['packages'], work: () => build('asan') },
  { id: 'asan-tests', title: 'Native tests under ASan and UBSan', needs: ['asan'], work: () => ctest('asan') },
  { id: 'wasm', title: 'WebAssembly build', needs: ['packages'], work: () => build('wasm') },
  {
    id: 'check',
    title: 'Format, lint, types',
    needs: ['modules', 'native'],
    work: () => run('node', ['.ci/check.mjs']),
  },
  { id: 'wasm-tests', title: 'WebAssembly tests', needs: ['modules', 'native', 'wasm'], work: () => vitest('wasm') },
  { id: 'repo-tests', title: 'Repository tests', needs: ['modules', 'native', 'wasm'], work: () => vitest('repo') },
  { id: 'site', title: 'Site', needs: ['modules', 'wasm'], work: buildSite },
  { id: 'web-tests', title: 'Browser tests', needs: ['native', 'site'], work: () => vitest('web') },
];

await runMain(async () => {
  rmSync(results, { recursive: true, force: true });
  mkdirSync(results, { recursive: true });
  const outcomes = await runSteps(steps);
  console.log(`\n${summary(outcomes)}`);
  if (outcomes.some((outcome) => outcome.failed > 0)) process.exitCode = 1;
});
