import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { generate, readTables } from '../../wasm/generate.mjs';
import { operators } from '../../wasm/src/generated.ts';

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');

it('generated.ts is what the built module yields (else run: node wasm/generate.mjs)', async () => {
  expect(read('wasm/src/generated.ts')).toBe(generate(await readTables()));
});

it('generated.ts has all error codes of result.hpp', () => {
  const body = read('core/include/polylap/base/result.hpp').match(/enum class ErrorCode[^{]*\{([^}]*)\}/)?.[1] ?? '';
  const names = body
    .split(',')
    .map((name) => name.trim().replaceAll('_', '-'))
    .filter(Boolean);
  expect(names.length).toBeGreaterThan(10);
  const union = read('wasm/src/generated.ts').match(/type ErrorCode =([^;]*);/)?.[1] ?? '';
  expect([...union.matchAll(/'([^']+)'/g)].map(([, name]) => name)).toEqual(names);
});

it('formulas are MathML without errors or inline styles', () => {
  for (const { formulaMathml } of operators) {
    expect(formulaMathml).toMatch(/^<math .*<\/math>$/);
    expect(formulaMathml).not.toMatch(/ style=|temml-error|merror/);
  }
});
