import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { buildPackage } from '../../.ci/build.mjs';
import { root } from './files.mjs';
import { codeBlocks, readTables, updated } from './readme.mjs';

const readme = readFileSync(join(root, 'README.md'), 'utf8');
const scratch = join(root, 'build/readme');
const run = (command, args, options = {}) =>
  execFileSync(command, args, { cwd: scratch, encoding: 'utf8', ...options });

beforeAll(() => {
  rmSync(scratch, { recursive: true, force: true });
  mkdirSync(scratch, { recursive: true });
});

it('shows the operators and their claims as they are (else run: npm run generate)', async () => {
  const tables = await readTables();
  expect(updated(readme, tables)).toBe(readme);
  const [first, ...rest] = tables.operators;
  const others = (operators) => updated(readme, { ...tables, operators });
  expect(others([...tables.operators, { ...first, id: 'one-more' }])).not.toBe(readme);
  const claims = { ...first.claims, local: { ...first.claims.local, why: 'for another reason' } };
  expect(others([{ ...first, claims }, ...rest])).not.toBe(readme);
});

it('shows the C++ program that the consumer tests build and run', () => {
  expect(codeBlocks(readme, 'cpp')[0]).toBe(readFileSync(join(root, 'tests/consumer/consumer.cpp'), 'utf8'));
});

it('shows commands that run', () => {
  cpSync(join(root, 'tests/data/meshes/quad-torus-32x16-noisy.obj'), join(scratch, 'mesh.obj'));
  const bin = process.env.POLYLAP_NATIVE_BIN
    ? join(process.env.POLYLAP_NATIVE_BIN, '..')
    : join(root, 'build/native/bin');
  const commands = codeBlocks(readme, 'sh').find((block) => block.includes('polylap info'));
  const said = run('bash', ['-euo', 'pipefail', '-c', commands], {
    env: { ...process.env, PATH: `${bin}${delimiter}${process.env.PATH}` },
  });
  expect(said).toMatch(/\b512\b/);
  for (const [, file] of commands.matchAll(/(?:-o|--mass-out) (\S+)/g))
    expect(readFileSync(join(scratch, file)).length).toBeGreaterThan(1000);
});

describe('the npm package', () => {
  const installed = join(scratch, 'node_modules/polylap');
  beforeAll(async () => {
    await buildPackage();
    const [{ filename, files }] = JSON.parse(run('npm', ['pack', root, '--json', '--ignore-scripts']));
    expect(files.every(({ path }) => /^(build\/(npm|wasm)\/|package\.json$|README\.md$|LICENSE$)/.test(path))).toBe(
      true,
    );
    mkdirSync(installed, { recursive: true });
    run('tar', ['-xzf', filename, '-C', installed, '--strip-components=1']);
  }, 120_000);

  const blocks = codeBlocks(readme, 'js');

  it('runs the README’s JavaScript in Node', () => {
    writeFileSync(join(scratch, 'example.mjs'), blocks[0]);
    const said = run('node', ['example.mjs']);
    expect(said).toMatch(/^Alexa–Wardetzky: 2048 negative weights/m);
    expect(said).toMatch(/^Planar: 0 negative weights/m);
  });

  it('has types that the README’s JavaScript passes', () => {
    for (const [index, block] of blocks.entries()) writeFileSync(join(scratch, `typed-${index}.mts`), block);
    const options = [
      '--noEmit',
      '--strict',
      '--module',
      'nodenext',
      '--target',
      'es2022',
      '--lib',
      'es2023,dom',
      '--types',
      '',
    ];
    const tsc = (files) => run(join(root, 'node_modules/.bin/tsc'), [...options, '--ignoreConfig', ...files]);
    expect(tsc(blocks.map((_, index) => `typed-${index}.mts`))).toBe('');
    writeFileSync(join(scratch, 'wrong.mts'), blocks[0].replace('{ id }', "{ id: 'no-such-operator' }"));
    expect(() => tsc(['wrong.mts'])).toThrow();
  });

  it('serves the browser its worker', () => {
    const create = readFileSync(join(installed, 'build/npm/create.js'), 'utf8');
    expect(create).toContain("new URL('./worker.js', import.meta.url)");
    expect(readFileSync(join(installed, 'build/npm/worker.js'), 'utf8')).toContain('serve');
  });
});
