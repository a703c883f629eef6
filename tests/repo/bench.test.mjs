import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { exponent, resultsMarkdown, withSpeed } from '../bench/results.mjs';
import { lookUp, targets, verdict } from '../bench/targets.mjs';
import { root } from './files.mjs';

const read = (path) => readFileSync(join(root, path), 'utf8');
const stored = JSON.parse(read('tests/bench/results.json'));

it('shows the results as they are stored (else run: npm run bench write)', () => {
  expect(resultsMarkdown(stored)).toBe(read('tests/bench/RESULTS.md'));
  const readme = read('README.md');
  expect(withSpeed(readme, stored)).toBe(readme);
  const doubled = stored.native.rows.map((row) => ({ ...row, value: 2 * row.value }));
  const other = { ...stored, native: { ...stored.native, rows: doubled } };
  expect(resultsMarkdown(other)).not.toBe(read('tests/bench/RESULTS.md'));
  expect(withSpeed(readme, other)).not.toBe(readme);
});

it('has a line per target, and numbers for every native target', () => {
  const text = resultsMarkdown(stored);
  for (const { what, target } of targets) expect(text).toContain(`| ${what} | ${target} |`);
  const find = lookUp(stored);
  const measured = targets.filter(({ what }) => !/browser|Chromium|WebAssembly/i.test(what));
  expect(measured.length).toBeGreaterThan(6);
  for (const { measure } of measured) expect(measure(find).some(({ value }) => value !== undefined)).toBe(true);
});

it('judges a number by its limit', () => {
  expect(verdict({ value: 2.5, atLeast: 2.5 })).toBe('met');
  expect(verdict({ value: 2.4, atLeast: 2.5 })).toBe('missed');
  expect(verdict({ value: 150, atMost: 150 })).toBe('met');
  expect(verdict({ value: 151, atMost: 150 })).toBe('missed');
  expect(verdict({ value: undefined, atMost: 150 })).toBe('not measured');
  expect(verdict({ value: Number.NaN, atMost: 150 })).toBe('missed');
});

it('makes a table from a small run', () => {
  const row = (item, metric, value) => ({ group: 'factor', shape: 'torus', n: 99856, item, metric, unit: 'ms', value });
  const times = { polylap: [20, 80], 'Eigen LDLT, AMD': [50, 400], 'CHOLMOD supernodal, AMD': [90, 60] };
  const rows = Object.entries(times).flatMap(([item, [analyse, numeric]]) => [
    row(item, 'analyse', analyse),
    row(item, 'numeric', numeric),
  ]);
  const machine = {
    processor: 'P',
    cores: 2,
    memory: 8,
    compiler: 'C',
    flags: '-O3',
    kernels: 'K',
    libraries: ['L 1'],
  };
  const about = { date: '2026-01-02T03:04:05Z', commit: 'abc' };
  const inBrowser = {
    'native solve': 7,
    'native solve, two lanes': 10,
    solve: 14,
    analysis: 30,
    factor: 20,
    'Eigen analysis': 10,
    'Eigen factor': 180,
  };
  const browserRows = Object.entries(inBrowser).map(([name, value]) => ({ name, n: 250000, unit: 'ms', value }));
  const browser = { ...about, machine: { browser: 'Chromium 1' }, rows: browserRows };
  const text = resultsMarkdown({ native: { ...about, machine, rows }, browser });
  expect(text).toContain('- Browser: 2026-01-02, commit abc; Chromium 1\n');
  expect(text).toMatch(/same WebAssembly, 250k \| ≥ 3\.5× \| from scratch 3\.80×; numbers 9\.00× \| ✓ met/);
  expect(text).toMatch(/WebAssembly over native.* solve 250k 1\.40×; best kernels 2\.00×/);
  expect(text).toContain('- Native: 2026-01-02, commit abc; C, `-O3`, kernels: K; L 1\n');
  expect(text).toMatch(
    /Eigen LDLT with AMD \|.*\| 100k from scratch 4\.50×; 100k numbers 5\.00×; 250k .* not measured/,
  );
  expect(text).toMatch(/CHOLMOD supernodal, the better .* 100k from scratch 1\.50×; 100k numbers 0\.75× ✗;.* ✗ missed/);
  expect(text).toContain('| 99856 | Eigen LDLT, AMD | 450 ms | 4.50× | 50.0 ms | 400 ms |');
});

it('measures growth by least squares', () => {
  const points = [1e3, 1e4, 1e5].map((n) => [n, 7 * n ** 1.5]);
  expect(exponent(points)).toBeCloseTo(1.5, 12);
});
