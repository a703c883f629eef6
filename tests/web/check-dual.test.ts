/** Properties beside claims, the orthogonal dual, and weights of vertices. */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { operators, properties } from '../../wasm/src/node.js';
import { chooseMesh, dataFile, openFile, picture, readout, settled, shows, useSite, useVisit } from './browser.js';

const at = useVisit(useSite());
const verdict = (property: string, side: string) =>
  at.page.locator(`[data-property=${property}] [data-of=${side}] [data-verdict]`).getAttribute('data-verdict');

describe('check', () => {
  beforeAll(async () => {
    await at.page.getByRole('tab', { name: 'Check' }).click();
    await shows(at.page, 'negative-ordered', 2048, 0);
  });

  it('shows what is measured beside what is claimed', async () => {
    await shows(at.page, 'negative-pairs', 1024, 0);
    await shows(at.page, 'kernel', 1, 1);
    await shows(at.page, 'components', 1, 1);
    expect(await at.page.locator('[data-property]').count()).toBe(properties.length);
    for (const [side, id] of [
      ['a', 'alexa-wardetzky'],
      ['b', 'planar'],
    ] as const) {
      const claims = operators.find((operator) => operator.id === id)?.claims;
      for (const { id: property } of properties)
        expect(await at.page.locator(`[data-property=${property}] .claim[data-of=${side}]`).textContent()).toBe(
          claims?.[property].where,
        );
    }
    expect([await verdict('positiveWeights', 'a'), await verdict('positiveWeights', 'b')]).toEqual(['fails', 'holds']);
    expect([await verdict('symmetric', 'a'), await verdict('symmetric', 'b')]).toEqual(['holds', 'holds']);
  });

  it('gives the reasons without hovering, and turns to the offending place', async () => {
    const { page } = at;
    const opener = page.locator('[data-property=positiveWeights] .opener');
    await opener.focus();
    await page.keyboard.press('Enter');
    expect(await opener.getAttribute('aria-expanded')).toBe('true');
    const reasons = page.locator('[data-property=positiveWeights] + .reasons');
    const why = operators.find(({ id }) => id === 'planar')?.claims.positiveWeights.why ?? 'none';
    expect(await reasons.textContent()).toContain(why);
    const found = (await reasons.locator('[data-of=a] p').last().textContent()) ?? '';
    expect(found).toMatch(/the worst is −[\d.]+ between vertices \d+ and \d+\. Show$/);
    await reasons.locator('[data-of=a]').getByRole('button').click();
    const { place, vertex } = await page.evaluate(() => ({
      place: globalThis.polylap.results().place,
      vertex: globalThis.polylap.state().selected,
    }));
    expect(place?.side).toBe('a');
    expect(place?.vertices).toHaveLength(2);
    expect(vertex).toBe(place?.vertices[0]);
    await page.waitForFunction((of) => globalThis.polylap.project('a', of)?.visible, vertex ?? 0);
    await picture(page, 'check-place');
  });

  it('draws a mode of a kernel that is too big', async () => {
    const { page } = at;
    await chooseMesh(page, 'grid-8');
    await page.getByLabel('λ of A, value').fill('0');
    await shows(page, 'kernel', 2, 1);
    expect(await page.locator('.legend-values').isVisible()).toBe(false);
    await page.getByLabel('Kernel mode of A').selectOption('1');
    expect(await page.locator('.legend-values').isVisible()).toBe(true);
    const signs = await page.evaluate(() => {
      const { check } = globalThis.polylap.results().a;
      const [, mode] = check && typeof check !== 'string' ? check.kernelModes : [];
      return Array.from(mode ?? [], Math.sign);
    });
    // The checkerboard: neighbours in a row have opposite signs.
    expect(signs).toHaveLength(81);
    for (let i = 0; i < 80; i++) if (i % 9 < 8) expect(signs[i]).toBe(-(signs[i + 1] ?? 0));
    expect(await readout(page, 'range-max')).toBeCloseTo(-(await readout(page, 'range-min')), 12);
    await picture(page, 'check-mode');
    await page.getByLabel('λ of A, value').fill('1');
    await shows(page, 'kernel', 1, 1);
    expect(await page.locator('.legend-values').isVisible()).toBe(false);
  });

  it('studies convergence, and can be cancelled', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Study convergence' }).click();
    await page.waitForFunction(() => {
      const button = document.querySelector<HTMLElement>('[data-action=cancel]');
      const waits = button?.checkVisibility() && /convergence/.test(button.parentElement?.textContent ?? '');
      if (waits) button?.click();
      return waits;
    });
    await page.waitForFunction(() => globalThis.polylap.results().a.study === 'Cancelled.');
    await page.getByRole('button', { name: 'Study convergence' }).click();
    await page.waitForFunction(() => {
      const { a, b } = globalThis.polylap.results();
      return [a.study, b.study].every((study) => typeof study === 'object' && study !== null);
    });
    expect(await page.locator('.study').count()).toBeGreaterThanOrEqual(2);
    expect(await page.locator('.study tbody tr').count()).toBeGreaterThanOrEqual(4);
    expect(await page.locator('.study-verdict').first().textContent()).toMatch(/^A claims .*converge/);
    expect(await verdict('convergent', 'a')).not.toBe('not-measured');
    await picture(page, 'check-study');
  });
});

describe('dual', () => {
  beforeAll(() => at.page.getByRole('tab', { name: 'Dual' }).click());

  it.each([
    ['torus', 1024, 977, 559],
    ['grid-2', 4, 4, 8],
  ])('%s: %d constraints of rank %d, null space %d', async (id, constraints, rank, nullSpace) => {
    await chooseMesh(at.page, id);
    await shows(at.page, 'constraints', constraints, constraints);
    await shows(at.page, 'rank', rank, rank);
    await shows(at.page, 'null-space', nullSpace, nullSpace);
    expect(await readout(at.page, 'residual', 'a')).toBeLessThan(1e-8);
    expect(await at.page.locator('[data-readout=dual-verdict]').textContent()).toMatch(/is usable/);
    await picture(at.page, `dual-${id}`);
  });

  it('says plainly when it is not usable, and offers the compromise', async () => {
    const { page } = at;
    await openFile(page, 'skew.obj', readFileSync(dataFile('meshes/grid-8x8-skew.obj')));
    await shows(page, 'shift', 5.695907698323571, 5.695907698323571, 1e-6);
    await shows(page, 'null-space', 80, 80);
    const shift = await readout(page, 'shift', 'a');
    expect(await page.locator('[data-readout=dual-verdict]').textContent()).toMatch(/not usable: a point lies 5\.7/);
    await page.getByLabel('μ of the compromise, value').fill('1');
    await page.waitForFunction(() => {
      const { dual } = globalThis.polylap.results().b;
      return dual !== null && typeof dual === 'object' && dual.residual > 1e-6;
    });
    expect(await readout(page, 'shift', 'a')).toBeLessThan(shift);
    await page.getByLabel('μ of the compromise, value').fill('0');
  });

  it('shows and hides its layers', async () => {
    const { page } = at;
    await chooseMesh(page, 'torus');
    await page.waitForFunction(() => globalThis.polylap.results().a.dual !== null);
    const box = await page.locator('[data-view=a]').boundingBox();
    if (!box) throw new Error('no view');
    const shot = async () => (await page.screenshot({ clip: box })).toString('base64');
    const all = await shot();
    await page.locator('[data-field=layer-edges]').uncheck();
    expect(await shot()).not.toBe(all);
    await page.locator('[data-field=layer-edges]').check();
    await page.waitForTimeout(200);
    expect(await shot()).toBe(all);
  });
});

describe('weights of vertices', () => {
  beforeAll(async () => {
    const { page } = at;
    await chooseMesh(page, 'noisy-torus');
    await page.getByRole('tab', { name: 'Weights' }).click();
    await page.getByLabel('Operator of A').selectOption('weighted-cotan');
    await settled(page);
  });

  it('change numbers as they are dragged, are kept per side, and go with the mesh', async () => {
    const { page } = at;
    await page.locator('[role=tabpanel]:visible').getByLabel('Vertex', { exact: true }).fill('403');
    const smallest = await readout(page, 'smallest', 'a');
    const slider = page.getByRole('slider', { name: 'Weight ω of the vertex on A' });
    expect(await page.getByRole('slider', { name: 'Weight ω of the vertex on B' }).isVisible()).toBe(false);
    await slider.focus();
    await page.keyboard.press('Home');
    await page.waitForFunction(
      (before) =>
        Number(document.querySelector<HTMLElement>('[data-readout=smallest][data-of=a]')?.dataset.value) !== before,
      smallest,
    );
    const { vertexWeights, unit } = await page.evaluate(() => ({
      vertexWeights: globalThis.polylap.state().vertexWeights,
      unit: globalThis.polylap.results().mesh?.meanSquaredEdge ?? 0,
    }));
    expect(Object.keys(vertexWeights.a)).toEqual(['403']);
    expect(vertexWeights.a[403]).toBeCloseTo(-unit, 4);
    expect(vertexWeights.b).toEqual({});
    await picture(page, 'vertex-weights');
    await page.getByRole('button', { name: 'Clear all weights of A' }).click();
    await settled(page);
    expect(await readout(page, 'smallest', 'a')).toBe(smallest);
    await page.locator('[role=tabpanel]:visible').getByLabel('Weight ω of the vertex on A, value').fill('0.01');
    await settled(page);
    await chooseMesh(page, 'torus');
    expect(await page.evaluate(() => globalThis.polylap.state().vertexWeights.a)).toEqual({});
  });
});

it('makes no noise', () => {
  expect(at.troubles).toEqual([]);
});
