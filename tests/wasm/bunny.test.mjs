import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { measureBunny, withBunny } from '../repo/bunny.mjs';

it('the README counts what the quad bunny has (else run: npm run generate)', async () => {
  const measured = await measureBunny();
  const readme = readFileSync(new URL('../../README.md', import.meta.url), 'utf8');
  expect(withBunny(readme, measured)).toBe(readme);
  // Closed, in one piece, and without a hole: as many quads as vertices but for two.
  expect(measured.boundary).toBe(0);
  expect(measured.components).toBe(1);
  expect(measured.faces).toBe(measured.vertices - 2);
  expect(measured.vertices).toBeGreaterThan(4900);
  expect(measured.vertices).toBeLessThan(5100);
});
