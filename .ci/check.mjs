// `npm run check`: format, lint and types of everything; `npm run fix` repairs what a tool can repair.
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { configure, ensureModules, ensurePackages, root, run, runMain, runTool } from './build.mjs';

const filesIn = (folder, ending) =>
  readdirSync(join(root, folder), { recursive: true })
    .map((name) => join(folder, name))
    .filter((name) => ending.test(name))
    .sort();
const cppIn = (...folders) => folders.flatMap((folder) => filesIn(folder, /\.[ch]pp$/));

/** Runs a command quietly; resolves to its code and what it said. */
const listen = (command, args) =>
  new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: root });
    const said = [];
    child.stdout.on('data', (chunk) => said.push(chunk));
    child.stderr.on('data', (chunk) => said.push(chunk));
    child.once('error', reject);
    child.once('close', (code) => resolve({ code, text: Buffer.concat(said).toString() }));
  });

const clangFormat = (...mode) => run('clang-format-14', [...mode, ...cppIn('core', 'wasm', 'tests')]);

/** How clang-tidy, which knows no em++, has to be told to read a file of the wasm build. */
async function emscriptenArguments() {
  const { text } = await listen('em++', ['--cflags']);
  const flags = text
    .trim()
    .split(/\s+/)
    .filter((flag) => /^(--sysroot=|-D)/.test(flag));
  const sysroot = flags.find((flag) => flag.startsWith('--sysroot='))?.slice('--sysroot='.length);
  return [...flags, `-isystem${sysroot}/include/compat`, '--target=wasm32-unknown-emscripten'];
}

/** Lints each source once per content: what it and any header say is the key of a stamp in build/tidy. */
async function clangTidy() {
  const stamps = join(root, 'build/tidy');
  mkdirSync(stamps, { recursive: true });
  const shared = createHash('sha256').update((await listen('clang-tidy-14', ['--version'])).text);
  for (const path of ['.clang-tidy', ...filesIn('core', /\.hpp$/)]) shared.update(readFileSync(join(root, path)));
  const base = shared.digest('hex');

  const groups = [{ preset: 'native', files: filesIn('core', /\.cpp$/), extra: [] }];
  groups.push({ preset: 'wasm', files: filesIn('wasm', /\.cpp$/), extra: await emscriptenArguments() });
  const jobs = groups.flatMap(({ preset, files, extra }) =>
    files.map((file) => {
      const key = createHash('sha256')
        .update(base)
        .update(file)
        .update(readFileSync(join(root, file)))
        .digest('hex');
      const flags = ['-Wno-unknown-warning-option', ...extra].map((flag) => `--extra-arg=${flag}`);
      return { file, stamp: join(stamps, key), args: ['--quiet', '-p', `build/${preset}`, ...flags, file] };
    }),
  );
  const todo = jobs.filter(({ stamp }) => !existsSync(stamp));
  for (const { preset } of groups) {
    if (todo.length > 0 && !existsSync(join(root, 'build', preset, 'compile_commands.json'))) await configure(preset);
  }

  let bad = 0;
  const work = async () => {
    for (let job = todo.shift(); job; job = todo.shift()) {
      const { code, text } = await listen('clang-tidy-14', job.args);
      if (code === 0) {
        writeFileSync(job.stamp, job.file);
      } else {
        bad += 1;
        console.log(text.replaceAll(`${root}`, '').replace(/^\d+ warnings? .*\n/gm, ''));
      }
    }
  };
  const fresh = todo.length;
  await Promise.all(Array.from({ length: availableParallelism() }, work));
  console.log(`${jobs.length} files, ${fresh} of them new or changed, ${bad} with findings`);
  if (bad > 0) throw new Error(`clang-tidy has findings in ${bad} files`);
}

const checks = {
  'clang-format': () => clangFormat('--dry-run', '-Werror'),
  'clang-tidy': clangTidy,
  biome: () => runTool('biome', ['ci', `--colors=${process.stdout.isTTY ? 'force' : 'off'}`]),
  tsc: () => runTool('tsc', ['--noEmit']),
};

await runMain(async () => {
  await ensurePackages('native', 'wasm', 'lint');
  await ensureModules();
  if (process.argv.includes('--fix')) {
    await clangFormat('-i');
    await runTool('biome', ['check', '--write']);
    return;
  }
  const failed = [];
  for (const [name, check] of Object.entries(checks)) {
    const start = performance.now();
    console.log(`--- ${name}`);
    await check().catch((error) => failed.push(`${name}: ${error.message}`));
    console.log(`--- ${name}: ${((performance.now() - start) / 1000).toFixed(1)} s`);
  }
  if (failed.length > 0)
    throw new Error(`${failed.length} of ${Object.keys(checks).length} checks failed\n  ${failed.join('\n  ')}`);
});
