// What `npm start`, `npm test` and `npm run build…` share. Node's own modules only: it runs before anything is installed.
//   node .ci/build.mjs native|wasm|package|site
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));

/** Debian's emscripten brings its own, older Node: what runs from here goes on with the one that runs this. */
const path = [dirname(process.execPath), process.env.PATH].join(delimiter);

/** Runs a command in the root folder with its output on the terminal; rejects unless it ends with code 0. */
export function run(command, args = [], { env = {}, quiet = false } = {}) {
  return new Promise((resolve, reject) => {
    const stdio = quiet ? ['ignore', 'ignore', 'inherit'] : ['ignore', 'inherit', 'inherit'];
    const child = spawn(command, args, { cwd: root, stdio, env: { ...process.env, PATH: path, ...env } });
    child.once('error', (error) => reject(new Error(`${command} could not be started: ${error.message}`)));
    child.once('close', (code, signal) => {
      if (code === 0) resolve();
      else reject(new Error(`${command} ${args.join(' ')} ended with ${signal ?? `code ${code}`}`));
    });
  });
}

/** Runs a tool from node_modules. */
export const runTool = (name, args, options) => run(join(root, 'node_modules/.bin', name), args, options);

/** Debian packages. @param groups see .ci/setup; none: all */
export const ensurePackages = (...groups) => run(join(root, '.ci/setup'), groups);

/** node_modules as package-lock.json has it. */
export async function ensureModules() {
  const stamp = join(root, 'node_modules/.polylap-lock');
  const wanted = createHash('sha256')
    .update(readFileSync(join(root, 'package-lock.json')))
    .digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return;
  await run('npm', ['ci', '--no-fund', '--no-audit']);
  writeFileSync(stamp, wanted);
}

const onPath = (name) => (process.env.PATH ?? '').split(delimiter).some((folder) => existsSync(join(folder, name)));

/** Configures a preset of CMakePresets.json. */
export function configure(preset) {
  // CMake takes this as the default of a fresh build folder, so that ccache is a choice of this script and not of the project.
  const env = onPath('ccache') ? { CMAKE_CXX_COMPILER_LAUNCHER: 'ccache' } : {};
  return run('cmake', ['--preset', preset], { env, quiet: true });
}

/** Brings a preset up to date; quick when nothing changed. */
export async function build(preset, targets = []) {
  if (!existsSync(join(root, 'build', preset, 'build.ninja'))) await configure(preset);
  const only = targets.length > 0 ? ['--target', ...targets] : [];
  await run('cmake', ['--build', '--preset', preset, '--parallel', String(availableParallelism()), ...only]);
}

/** The meshes that the page offers as files, and the pictures of its gallery, in build/public. Needs the wasm preset. */
export const buildGallery = () => run(process.execPath, [join(root, 'web/gallery.mjs')]);

/** The static site in dist/. Needs the wasm preset. */
export async function buildSite() {
  await buildGallery();
  await runTool('vite', ['build', 'web']);
  await Promise.all(['web/pages.mjs', 'web/embed/build.mjs'].map((path) => run(process.execPath, [join(root, path)])));
}

/** What `npm pack` packs: the TypeScript of wasm/src as modules with types, in build/npm. Needs the wasm preset. */
export const buildPackage = () => runTool('tsc', ['-p', 'wasm/tsconfig.json']);

const goals = {
  async native() {
    await ensurePackages('native');
    await build('native', ['polylap', 'polylap_cli']);
  },
  async wasm() {
    await ensurePackages('wasm');
    await build('wasm');
  },
  async package() {
    await goals.wasm();
    await ensureModules();
    await buildPackage();
  },
  async site() {
    await goals.wasm();
    await ensureModules();
    await buildSite();
  },
};

/** Runs `main`; an error becomes one line and exit code 1. */
export async function runMain(main) {
  try {
    if (Number(process.versions.node.split('.')[0]) < 20)
      throw new Error(`polylap needs Node 20 or newer, this is ${process.version}`);
    await main();
  } catch (error) {
    console.error(`\npolylap: ${error.message}`);
    process.exitCode = 1;
  }
}

if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const goal = goals[process.argv[2]];
  if (goal) await runMain(goal);
  else {
    console.error(`usage: node .ci/build.mjs ${Object.keys(goals).join('|')}`);
    process.exitCode = 2;
  }
}
