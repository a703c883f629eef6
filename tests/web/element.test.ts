/** `<polylap-compare>` on the pages of others: what it shows, what it takes, and what it tells. */
import { describe, expect, it } from 'vitest';
import type { PolylapCompare } from '../../web/embed/element.js';
import { complaints } from './acts.js';
import { gridObj, picture } from './browser.js';
import { liveContexts, shown, showsNegative, soon, stateOf, toldBy, useHosts } from './hosts.js';

const hosts = useHosts();
const element = (id: string, attributes = '') => `<polylap-compare id="${id}" ${attributes}></polylap-compare>`;

describe('two on one page', () => {
  it('share the workers, have a context each, and ask the network for nothing but their script', async () => {
    const { page, troubles, requests, close } = await hosts.open(
      element('one') + element('two', 'mesh="grid-8" controls="none"'),
      { viewport: { width: 1200, height: 1400 } },
    );
    await showsNegative(page, 'one', 2048, 0);
    await showsNegative(page, 'two', 256, 0);
    expect(page.workers().length).toBe(2);
    await page.waitForFunction(() => globalThis.contexts.length === 2);
    expect(await liveContexts(page)).toBe(2);
    await picture(page, 'element-two');
    // What one is told is its own.
    await page.locator('#one').getByLabel('λ of A', { exact: true }).press('Home');
    await page.waitForFunction(async () => {
      const state = await document.querySelector('polylap-compare')?.getState();
      return state?.sides.a.parameters.lambda !== 1;
    });
    expect((await stateOf(page, 'two')).sides.a.parameters.lambda).toBe(1);
    expect(requests.filter((path) => !/^\/course\//.test(path))).toEqual(['/lib/polylap-compare.js']);
    expect(troubles).toEqual([]);
    await close();
  });

  it('hear only their own keys, pastes and drops', async () => {
    const { page, troubles, close } = await hosts.open(element('one', 'views="a"') + element('two', 'views="a"'), {
      viewport: { width: 700, height: 1200 },
    });
    const selected = () =>
      page.evaluate(() =>
        Promise.all([...document.querySelectorAll('polylap-compare')].map(async (e) => (await e.getState()).selected)),
      );
    expect(await selected()).toEqual([null, null]);
    await page.locator('#two [data-view=a]').focus();
    await page.keyboard.press(']');
    await page.keyboard.press(']');
    expect(await selected()).toEqual([null, 1]);
    // Where nothing has the focus, the one under the pointer is meant.
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.locator('#one [data-view=a]').hover();
    await page.keyboard.press(']');
    expect(await selected()).toEqual([0, 1]);
    // Keys of the host's own field are the host's.
    const vertices = () =>
      page
        .locator('polylap-compare [data-side=a] [data-readout=vertices]')
        .evaluateAll((all) => all.map((e) => e.dataset.value));
    const give = (id: string, type: 'paste' | 'drop') =>
      page.locator(`#${id} [data-view=a]`).evaluate((view, kind) => {
        const data = new DataTransfer();
        data.setData('text/plain', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
        const how = { bubbles: true, composed: true, cancelable: true };
        view.dispatchEvent(
          kind === 'paste'
            ? new ClipboardEvent('paste', { ...how, clipboardData: data })
            : new DragEvent('drop', { ...how, dataTransfer: data }),
        );
      }, type);
    await give('two', 'paste');
    await soon(vertices).toEqual(['512', '4']);
    await give('one', 'drop');
    await soon(vertices).toEqual(['4', '4']);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('attributes', () => {
  it('say what is shown, and what changes later takes effect', async () => {
    const { page, troubles, close } = await hosts.open(
      element(
        'one',
        'mesh="grid?nx=2&ny=2&width=2&height=2" a="planar" b="alexa-wardetzky?lambda=2" task="dual" alt="Four squares"',
      ),
    );
    const state = () => stateOf(page, 'one');
    const first = await state();
    expect(first.source).toMatchObject({ kind: 'shape', shape: { id: 'grid', parameters: { nx: 2, ny: 2 } } });
    expect(first.sides.a.operator).toBe('planar');
    expect(first.sides.b).toMatchObject({ operator: 'alexa-wardetzky', parameters: { lambda: 2 } });
    expect(first.task).toBe('dual');
    expect(await page.getByRole('group', { name: 'Four squares' }).isVisible()).toBe(true);
    await page.locator('#one').evaluate((one) => {
      one.setAttribute('lambda', '0.5');
      one.setAttribute('a', 'cotan');
      one.setAttribute('task', 'smooth');
      one.setAttribute('theme', 'dark');
    });
    await soon(async () => (await state()).sides.a.operator).toBe('cotan');
    const second = await state();
    expect(second.sides.b.parameters.lambda).toBe(0.5);
    expect(second.task).toBe('smooth');
    expect(second.theme).toBe('dark');
    await page.locator('#one').evaluate((one) => one.setAttribute('mesh', 'cube'));
    await soon(async () => (await state()).source).toMatchObject({ kind: 'shape', shape: { id: 'cube' } });
    expect((await state()).sides.a.operator).toBe('cotan');
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows the pair in columns as wide as text, one side where there is less room', async () => {
    const { page, close } = await hosts.open(`<div id="column">${element('one', 'loading="eager"')}</div>`);
    await showsNegative(page, 'one', 2048, 0);
    const seen = async (width: number) => {
      await page.locator('#column').evaluate((column, w) => column.style.setProperty('width', `${w}px`), width);
      const card = (side: string) => page.locator(`#one .card[data-side=${side}]`).isVisible();
      return Promise.all(['a', 'b', 'delta'].map(card));
    };
    await soon(() => seen(960)).toEqual([true, true, false]);
    await soon(() => seen(700)).toEqual([true, true, false]);
    await picture(page, 'element-column');
    await page.locator('#one').getByRole('button', { name: 'Δ Difference' }).click();
    await soon(() => seen(680)).toEqual([true, true, true]);
    await soon(async () => (await seen(600)).filter(Boolean)).toHaveLength(1);
    await close();
  });

  it('that cannot be had are told of, and the rest is shown', async () => {
    const wrong = [
      ['mesh="teapot"', 'There is no mesh “teapot”'],
      ['a="magic"', 'There is no operator “magic” for a'],
      ['a="alexa-wardetzky?lambda=-3"', 'cannot be -3'],
      ['figure="nothing"', 'There is no figure “nothing”'],
      ['task="cook"', 'task cannot be “cook”; it is one of weights, smooth, harmonic, dual, check.'],
      ['controls="many"', 'controls cannot be “many”'],
      ['lambda="big"', '“big” is no number for lambda.'],
      ['autoplay="-1"', 'autoplay is a number of steps'],
    ] as const;
    const { page, close } = await hosts.open(
      wrong.map(([attribute], k) => element(`e${k}`, `loading="eager" ${attribute}`)).join(''),
    );
    for (const [k, [, message]] of wrong.entries()) {
      expect(await page.locator(`#e${k}`).getByRole('alert').first().textContent()).toContain(message);
      await soon(async () => JSON.stringify(await toldBy(page, `e${k}`, 'error'))).toContain(message);
      await showsNegative(page, `e${k}`, 2048, 0);
    }
    await close();
  });

  it('opens a mesh of the host, and says why it cannot', async () => {
    const { page, close } = await hosts.open(
      element('good', 'mesh="mesh.obj" controls="none"') +
        element('gone', 'mesh="gone.obj" controls="none"') +
        element('bad', 'mesh="./bad.obj" controls="none"'),
      { files: { 'mesh.obj': gridObj(3), 'bad.obj': 'v 0 0 0\nf 1 2 3\n' }, viewport: { width: 1200, height: 1400 } },
    );
    expect(await shown(page, 'good', 'negative', 'b')).toBeGreaterThanOrEqual(0);
    const { source } = await stateOf(page, 'good');
    expect(source).toMatchObject({ kind: 'file', name: 'mesh.obj' });
    expect(await page.locator('#gone').getByRole('alert').last().textContent()).toContain(
      'gone.obj could not be loaded',
    );
    expect(await page.locator('#bad').getByRole('alert').last().textContent()).toContain('Line 2');
    const why = await page.locator('#good').evaluate((good) =>
      (good as HTMLElementTagNameMap['polylap-compare']).load('none.obj').then(
        () => '',
        ({ message }: Error) => message,
      ),
    );
    expect(why).toContain('none.obj says 404');
    await soon(async () => JSON.stringify(await toldBy(page, 'good', 'error'))).toContain(
      'none.obj could not be loaded',
    );
    await picture(page, 'element-errors');
    await close();
  });

  it('brings figures: drawn ones, and those of the gallery', async () => {
    const { page, troubles, close } = await hosts.open(
      element('drawn', 'figure="one-interior-vertex"') +
        element('gallery', 'figure="gallery:maximum-principle" lambda="0.5"'),
      { viewport: { width: 900, height: 1500 } },
    );
    expect(await page.locator('#drawn figure[data-figure=one-interior-vertex] svg').first().isVisible()).toBe(true);
    const link = await page.locator('#drawn a.permalink').getAttribute('href');
    expect(new URL(link ?? '').pathname).toBe('/lib/index.html');
    const state = await stateOf(page, 'gallery');
    expect(state.task).toBe('harmonic');
    expect(state.harmonic.pins.length).toBe(32);
    expect(state.sides.a.parameters.lambda).toBe(0.5);
    const svg = await page.evaluate(() => (document.getElementById('drawn') as PolylapCompare).toSVG());
    expect(svg).toMatch(/^<svg[^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    // It takes no context.
    expect(await page.evaluate(() => globalThis.contexts.length)).toBe(1);
    await picture(page, 'element-figures');
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows as much as it is asked for', async () => {
    const { page, troubles, close } = await hosts.open(
      ['none', 'some', 'full'].map((controls) => element(controls, `controls="${controls}"`)).join('') +
        element('one-view', 'views="b" controls="none"') +
        element('delta', 'views="delta" controls="none" task="smooth"'),
      { viewport: { width: 1000, height: 3000 } },
    );
    const seen = (selector: string) =>
      page.evaluate(
        (wanted) =>
          [...document.querySelectorAll('polylap-compare')]
            .filter(({ shadowRoot }) => shadowRoot?.querySelector(wanted)?.checkVisibility())
            .map(({ id }) => id),
        selector,
      );
    expect(await seen('.masthead')).toEqual(['full']);
    expect(await seen('.panel')).toEqual(['full']);
    expect(await seen('[role=tab]')).toEqual(['some', 'full']);
    expect(await seen('[data-side=a] .parameter')).toEqual(['some', 'full']);
    expect(await seen('[data-side=a] .loud')).toEqual(['none', 'some', 'full']);
    expect(await seen('[data-side=b] .loud')).toEqual(['none', 'some', 'full', 'one-view']);
    expect(await seen('[data-side=delta] .view')).toEqual(['delta']);
    expect(await page.locator('#delta [data-readout=delta-max]').getAttribute('data-value')).toBe('0');
    await page.evaluate(() => (document.getElementById('delta') as PolylapCompare).step());
    await soon(async () =>
      Number(await page.locator('#delta [data-readout=delta-max]').getAttribute('data-value')),
    ).toBeGreaterThan(0);
    await picture(page, 'element-controls', true);
    expect(troubles).toEqual([]);
    await close();
  });

  it('takes the narrow layout where it is narrow, on however wide a page', async () => {
    const { page, troubles, close } = await hosts.open(
      element('narrow', 'controls="full" style="width: 400px; height: 700px"') + element('wide'),
      { viewport: { width: 1300, height: 1400 } },
    );
    expect(await page.locator('#narrow .side-switch').isVisible()).toBe(true);
    expect(await page.locator('#narrow [data-view=b]').isVisible()).toBe(false);
    expect(await page.locator('#wide .side-switch').isVisible()).toBe(false);
    expect(await page.locator('#wide [data-view=b]').isVisible()).toBe(true);
    // A picture of a view for which there is no room, all the same.
    const sizes = await page.evaluate(async () => {
      const narrow = document.getElementById('narrow') as PolylapCompare;
      const width = async (view: 'a' | 'b') => (await createImageBitmap(await narrow.toPNG(view))).width;
      const paths = (await narrow.toSVG('b')).split('<path').length;
      return [await width('a'), await width('b'), paths];
    });
    expect(sizes[0]).toBe(sizes[1]);
    expect(sizes[2]).toBe(513);
    expect(await page.locator('#narrow [data-view=b]').isVisible()).toBe(false);
    // It scrolls in one place only.
    expect(await page.locator('#narrow .panel').evaluate((e) => e.scrollHeight - e.clientHeight)).toBeLessThanOrEqual(
      0,
    );
    const wider = await page.locator('#narrow .polylap').evaluate((e) => e.scrollWidth - e.clientWidth);
    expect(wider).toBeLessThanOrEqual(0);
    // The menu opens where its button is, not in a corner of the host's window.
    await page.locator('#narrow').getByRole('button', { name: 'Menu' }).click();
    const menu = await page.locator('#narrow .actions').boundingBox();
    const button = await page.locator('#narrow .more').boundingBox();
    expect(Math.abs((menu?.x ?? 0) + (menu?.width ?? 0) - (button?.x ?? 0) - (button?.width ?? 0))).toBeLessThan(2);
    expect((menu?.y ?? 0) - (button?.y ?? 0) - (button?.height ?? 0)).toBeGreaterThan(0);
    await picture(page, 'element-narrow');
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('scripts', () => {
  it('ask it for its state, its surfaces, its pictures and its matrices', async () => {
    const { page, troubles, close } = await hosts.open(element('one', 'mesh="grid-8"'));
    const asked = await page.evaluate(async () => {
      const one = document.getElementById('one') as PolylapCompare;
      const state = await one.getState();
      const steps = await one.step(3);
      await one.reset();
      const back = await one.getState();
      await one.setState({ ...state, task: 'harmonic', harmonic: { value: 1, pins: [{ vertex: 0, value: 1 }] } });
      const set = await one.getState();
      const { stiffness, mass } = await one.matrix('b');
      const sum = stiffness.values.reduce((all, value) => all + value, 0);
      const area = mass.values.reduce((all, value) => all + value, 0);
      const [png, both] = [await one.toPNG('a'), await one.toPNG()];
      const sizes = await Promise.all([png, both].map(async (blob) => (await createImageBitmap(blob)).width));
      const svg = await one.toSVG('a');
      const paths = new DOMParser().parseFromString(svg, 'image/svg+xml').querySelectorAll('path').length;
      const loaded = await one.load(
        'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'.length > 0 ? new Blob(['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n']) : '',
        't.obj',
      );
      const refusals = [];
      for (const wrong of [
        () => one.load(new TextEncoder().encode('f 1 2 3\n'), 'bad.obj'),
        () => one.setState({ version: 2 }),
        () => one.setState({ ...state, task: 'cook' }),
        () => one.matrix('c' as 'a'),
        () => one.step(0),
      ])
        refusals.push(
          await wrong().then(
            () => '',
            (error: Error) => error.message,
          ),
        );
      return { steps, back: back.step, set, sum, area, type: png.type, sizes, paths, loaded, refusals };
    });
    expect(asked.steps).toBe(3);
    expect(asked.back).toBe(0);
    expect(asked.set.task).toBe('harmonic');
    expect(asked.set.harmonic.pins).toEqual([{ vertex: 0, value: 1 }]);
    // Constants are in the kernel; the mass is the area.
    expect(Math.abs(asked.sum)).toBeLessThan(1e-9);
    expect(asked.area).toBeCloseTo(64, 9);
    expect(asked.type).toBe('image/png');
    expect(asked.sizes[1]).toBe(2 * (asked.sizes[0] ?? 0));
    // 64 squares; Harmonic draws no negative weights.
    expect(asked.paths).toBe(64);
    expect(asked.loaded).toEqual({ vertices: 3, faces: 1 });
    expect(asked.refusals).toEqual([
      expect.stringContaining('Line 1'),
      expect.stringContaining('version 3'),
      expect.stringContaining('cook'),
      expect.stringContaining('a and b'),
      expect.stringContaining('above 0'),
    ]);
    expect(troubles).toEqual([]);
    await close();
  });

  it('hear of it: ready, steps, what is picked, changes', async () => {
    const { page, troubles, close } = await hosts.open(element('one'));
    expect((await toldBy(page, 'one', 'ready')).length).toBe(1);
    await page.evaluate(() => (document.getElementById('one') as PolylapCompare).step(2));
    const steps = await toldBy(page, 'one', 'step');
    expect(steps.map(({ step }) => step)).toEqual([1, 2]);
    const areas = steps.map(({ a }) => (a as { area: number }).area);
    expect(areas[1]).toBeLessThan(areas[0] ?? 0);
    await page.locator('#one [data-view=b]').focus();
    await page.keyboard.press(']');
    expect(await toldBy(page, 'one', 'pick')).toEqual([{ vertex: 0, face: null }]);
    const changes = await toldBy(page, 'one', 'state-change');
    expect(changes.at(-1)?.state).toMatchObject({ version: 3, selected: 0, step: 2 });
    expect(
      await page.evaluate(() => JSON.stringify(globalThis.told.map(({ detail }) => detail)).length),
    ).toBeGreaterThan(100);
    expect(troubles).toEqual([]);
    await close();
  });
});

it.each([
  ['light', {}],
  ['dark', { colorScheme: 'dark' as const }],
  ['narrow', { viewport: { width: 360, height: 800 }, hasTouch: true }],
])('axe, %s: finds nothing, inside and around', async (name, options) => {
  const { page, troubles, close } = await hosts.open(
    element('none', 'controls="none" alt="A torus"') +
      element('some', 'task="harmonic"') +
      element('full', 'controls="full"') +
      element('wrong', 'mesh="teapot"') +
      element('drawn', 'figure="one-interior-vertex"'),
    { style: ':root { color-scheme: light dark }', ...options },
  );
  expect(await complaints(page)).toEqual([]);
  await picture(page, `element-${name}`, true);
  expect(troubles).toEqual([]);
  await close();
});
