/** The page in German: every word of it, its numbers, its layout, and the way there and back with everything on screen. */
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { conversions, operators, shapes } from '../../wasm/src/generated.js';
import words from '../../web/src/words/de.json';
import { complaints, numbersOf, sharedLink, stateOf } from './acts.js';
import { chooseMesh, openFile, picture, readout, settled, tasks, useSite, visit } from './browser.js';

const site = useSite();
const german = (options = {}) => visit(site, options, `${site.url}?lang=de`);
const texts: Readonly<Record<string, string>> = words.texts;
const taskIds = tasks.map((task) => task.toLowerCase());
const task = (page: Page, id: string) => page.locator(`[data-tab=${id}]`).click();

/** English that no German sentence has; names that are the same in both languages are none of it. */
const english =
  /\b(the|of|and|is|are|it|its|with|from|by|for|not|none|no|at|in all|where|when|what|which|here|there|vertex|vertices|weights?|faces?|edges?|mesh|meshes|steps?|shown?|surface|boundary|value|values|largest|smallest|each|every|choose|select|click|drag|save|open|close|undo|redo|help|side)\b/i;
const keys = new Set(Object.entries(texts).flatMap(([key, text]) => (key === text ? [] : [key])));

/** Everything that is said to somebody who looks or listens: texts, names and hints, also of what a click would show. */
const said = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const found = new Set<string>();
    const attributes = ['aria-label', 'title', 'placeholder', 'aria-valuetext', 'aria-roledescription', 'alt', 'label'];
    for (const element of document.querySelectorAll<HTMLElement>('body, body *')) {
      if (element.closest('noscript, script, style, .bibtex, .link, #paste-text, math')) continue;
      for (const node of element.childNodes)
        if (node.nodeType === Node.TEXT_NODE && node.textContent?.trim()) found.add(node.textContent.trim());
      for (const name of attributes) {
        const value = element.getAttribute(name);
        // Below what an operator is stands the work that it comes from.
        const own = element.matches('.operator') ? value?.split('\n')[0] : value;
        // In the language that it leads to.
        if (own?.trim() && !element.matches('[data-action=language]')) found.add(own.trim());
      }
    }
    return [...found];
  });

const untranslated = async (page: Page) =>
  (await said(page)).filter((text) => keys.has(text) || english.test(text.replace(/\b[\w-]+\.(obj|ply)\b/g, '')));

it('no English is left in any task, nor in the dialogs', async () => {
  const { page, troubles, close } = await german();
  expect(
    await page.evaluate(() => [document.documentElement.lang, document.querySelector<HTMLElement>('.polylap')?.lang]),
  ).toEqual(['de', 'de']);
  expect(await page.title()).toContain('Laplace-Operatoren');
  await page.locator('[data-action=delta]').click();
  for (const id of taskIds) {
    await task(page, id);
    if (id === 'harmonic') await page.locator('[data-action=example-pins]').click();
    if (id === 'smooth') await page.locator('[data-action=step]:visible').first().click();
    if (id === 'dual') await page.locator('[data-field=edge]').fill('3');
    if (id === 'weights') await page.keyboard.press('}');
    await settled(page);
    if (id === 'check') {
      await page.locator('[data-action=all-reasons]').click();
      for (const action of ['study', 'spectrum']) {
        await page.locator(`[data-action=${action}]`).click();
        await settled(page);
      }
      await page.locator('.study').first().waitFor();
    }
    expect([id, ...(await untranslated(page))]).toEqual([id]);
  }
  for (const action of ['gallery', 'make', 'paste', 'share', 'save', 'help']) {
    await page.locator(`[data-action=${action}]`).click();
    await page.locator('dialog[open]').waitFor();
    expect([action, ...(await untranslated(page))]).toEqual([action]);
    await page.keyboard.press('Escape');
  }
  expect(troubles).toEqual([]);
  await close();
});

it('no English is left in what is said of any operator, on a mesh where all can fail, nor of any shape', async () => {
  const { page, close } = await german();
  await task(page, 'check');
  await page.locator('[data-action=all-reasons]').click();
  for (const mesh of ['noisy-saddle', 'soup']) {
    await page.locator('.mesh-menu').selectOption(mesh);
    await page.waitForFunction((id) => (globalThis.polylap.state().source as { id?: string }).id === id, mesh);
    for (const { id } of operators) {
      await page.locator('[data-side=a] .operator').selectOption(id);
      await settled(page);
      await page.waitForFunction(() => globalThis.polylap.results().a.check !== null);
      expect([mesh, id, ...(await untranslated(page))]).toEqual([mesh, id]);
    }
  }
  await page.locator('[data-action=make]').click();
  const menus = page.locator('.make-dialog section');
  for (const [k, table] of [shapes, conversions].entries())
    for (const { id } of table) {
      await menus.nth(k).locator('select').first().selectOption(id);
      expect([id, ...(await untranslated(page))]).toEqual([id]);
    }
  await close();
});

it.each([
  ['few.obj', 'v 0 0 0\nv 1 0 0\nf 1 2', 'Zeile 3: Facette 0 hat 2 Ecken, weniger als 3.'],
  ['number.obj', 'v 0 0 nan\n', "Zeile 1: Knoten 0 hat 'nan', das ist keine endliche Zahl."],
  [
    'index.obj',
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4',
    'Zeile 4: Facette 0 hat den Index 4 (ab 1 gezählt, wie in der Datei), aber die Datei hat 3 Knoten.',
  ],
  [
    'corner.obj',
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x',
    "Zeile 4: Facette 0 hat die Ecke 'x', das ist nichts von v, v/vt, v//vn, v/vt/vn mit ganzen Zahlen.",
  ],
  ['empty.obj', '', 'Die Datei ist leer.'],
  ['page.obj', '<!doctype html><p>', 'Dies ist eine HTML-Seite, keine OBJ-Datei.'],
  [
    'short.off',
    'OFF\n9 1 0\n0 0 0\n',
    'Zeile 2: 9 Knoten sind angekündigt, aber die 8 Bytes, die folgen, reichen dafür nicht.',
  ],
  ['few.ply', 'ply\nformat ascii 1.0\n', 'Die Datei endet in ihrem Kopf: end_header fehlt.'],
  ['notes.txt', 'v 0 0 0', "'notes.txt' ist keine Netzdatei: ihr Name muss auf .obj, .off, .ply oder .stl enden."],
])('what is wrong with %s is said in German', async (name, text, message) => {
  const { page, close } = await german();
  await page.locator('input[type=file]').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
  const error = page.locator('.error');
  await error.waitFor({ state: 'visible' });
  expect(await error.locator('p').textContent()).toBe(`${name} konnte nicht geöffnet werden. ${message}`);
  await close();
});

it('numbers are written with a comma, and read with either; files and machines have points', async () => {
  const { page, close } = await german();
  const smallest = page.locator('[data-readout=smallest][data-of=a]');
  expect(await smallest.textContent()).toMatch(/^−\d,\d{3}$/);
  expect(await smallest.getAttribute('data-value')).toMatch(/^-\d\.\d+$/);
  const lambda = page.locator('[data-side=a] [data-parameter=lambda] .number');
  for (const typed of ['0,75', '0.75']) {
    await lambda.fill('1');
    await lambda.fill(typed);
    await lambda.press('Tab');
    expect((await stateOf(page)).sides.a.parameters.lambda).toBe(0.75);
  }
  await page.locator('[data-parameter=lambda] input[type=range]').first().focus();
  await page.keyboard.press('ArrowRight');
  await settled(page);
  expect(await lambda.inputValue()).toMatch(/^0,\d+$/);
  await page.locator('[data-action=save]').click();
  const [file] = await Promise.all([page.waitForEvent('download'), page.locator('[data-action=save-row]').click()]);
  expect(file.suggestedFilename()).toMatch(/^noisy-torus-row-\d+\.csv$/);
  const csv = readFileSync(await file.path(), 'utf8');
  expect(csv).toMatch(/^column,S_A,S_B\n\d+,-?\d+\.\d+,-?\d+(\.\d+)?/);
  await close();
});

it('switching takes along all that is on screen, and undo reaches back over it', async () => {
  const { page, requests, troubles, close } = await visit(site);
  await chooseMesh(page, 'noisy-saddle');
  await page.getByLabel('Operator of B').selectOption('umbrella');
  await page.getByRole('tab', { name: 'Smooth' }).click();
  await page.getByRole('button', { name: 'Step', exact: true }).click();
  await page.getByRole('tab', { name: 'Harmonic' }).click();
  await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
  await page.getByRole('button', { name: 'Δ Difference' }).click();
  await settled(page);
  const before = {
    state: await stateOf(page),
    numbers: await numbersOf(page),
    undo: await page.locator('[data-action=undo]').getAttribute('title'),
  };
  expect(before.numbers.length).toBeGreaterThan(10);
  expect([...requests].some((url) => /german/.test(url))).toBe(false);

  await page.getByRole('button', { name: 'Deutsch' }).click();
  await page.getByRole('tab', { name: 'Harmonisch', selected: true }).waitFor();
  await settled(page);
  expect(await stateOf(page)).toEqual(before.state);
  expect(await numbersOf(page)).toEqual(before.numbers);
  expect(await page.locator('[data-action=undo]').getAttribute('title')).toBe(
    'Rückgängig machen: die Vorgaben (Strg Z)',
  );
  expect(page.url()).toContain('?lang=de');
  expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('EN');
  expect(await untranslated(page)).toEqual([]);
  expect(await page.locator('canvas.scene').count()).toBe(1);

  // What is done goes on counting, in views that are there once.
  await page.locator('[data-action=undo]').click();
  await page.getByText('Rückgängig gemacht: die Vorgaben.').waitFor();
  await settled(page);
  expect((await stateOf(page)).harmonic.pins).toEqual([]);
  await page.locator('[data-action=redo]').click();
  await page.getByText('Wiederhergestellt: die Vorgaben.').waitFor();
  await settled(page);

  await page.getByRole('button', { name: 'English' }).click();
  await page.getByRole('tab', { name: 'Harmonic', selected: true }).waitFor();
  await settled(page);
  expect(await stateOf(page)).toEqual(before.state);
  expect(await numbersOf(page)).toEqual(before.numbers);
  expect(await page.locator('[data-action=undo]').getAttribute('title')).toBe(before.undo);
  expect(troubles).toEqual([]);
  await close();
});

it('on a narrow page the choice is in the menu, and the focus comes back to its button', async () => {
  const { page, close } = await visit(site, { viewport: { width: 390, height: 844 } });
  await page.getByRole('button', { name: 'Menu' }).click();
  await page.getByRole('button', { name: 'Deutsch' }).click();
  await page.getByRole('tab', { name: 'Gewichte' }).waitFor();
  expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('Menü');
  await close();
});

it('an opened file and what was done to it are told of again in the other language', async () => {
  const { page, close } = await visit(site);
  await openFile(page, 'twice.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\n');
  await page.getByText('1 vertex is in no face').waitFor();
  await page.getByRole('button', { name: 'Deutsch' }).click();
  await page.getByText('twice.obj: 5 Knoten, 1 Facette. 1 Knoten liegt in keiner Facette, der Knoten 4.').waitFor();
  await settled(page);
  expect((await stateOf(page)).source).toMatchObject({ kind: 'file', name: 'twice.obj' });
  expect(await readout(page, 'vertices', 'a')).toBe(5);
  await close();
});

it('a link from a German page opens in German, and one without a language in English', async () => {
  const { page, close } = await german();
  await task(page, 'dual');
  await settled(page);
  await page.locator('[data-action=share]').click();
  await page.locator('#share-link').waitFor();
  const link = await page.locator('#share-link').inputValue();
  expect(link).toMatch(/\?lang=de#v=3&s=/);
  const state = await stateOf(page);
  await close();
  const there = await visit(site, {}, link);
  expect(await there.page.locator('[aria-selected=true]').textContent()).toBe('Dual');
  expect(await there.page.locator('[data-action=open]').textContent()).toBe('Öffnen…');
  expect(await stateOf(there.page)).toEqual(state);
  await there.close();
  const plain = await visit(site, {}, link.replace('?lang=de', ''));
  expect(await plain.page.locator('[data-action=open]').textContent()).toBe('Open…');
  await plain.page.getByRole('button', { name: 'Share…' }).click();
  expect(await sharedLink(plain.page)).not.toContain('lang');
  await plain.close();
});

it.each([
  ['light', { colorScheme: 'light' as const }],
  ['narrow and dark', { viewport: { width: 320, height: 700 }, hasTouch: true, colorScheme: 'dark' as const }],
])('axe, %s: finds nothing in German, and nothing is cut off or too wide', async (name, options) => {
  const { page, close } = await german(options);
  const isNarrow = name.startsWith('narrow');
  const look = async (what: string) =>
    expect([what, ...(await complaints(page)), ...(await cut(page))]).toEqual([what]);
  for (const id of taskIds) {
    await task(page, id);
    if (id === 'harmonic') await page.locator('[data-action=example-pins]').click();
    await settled(page);
    if (id === 'check') await page.locator('[data-action=all-reasons]').click();
    await picture(page, `german-${id}-${name}`, true);
    await look(id);
  }
  for (const action of ['gallery', 'make', 'paste', 'share', 'save', 'help']) {
    if (isNarrow) await page.locator('.more').click();
    await page.locator(`[data-action=${action}]`).click();
    await page.locator('dialog[open]').waitFor();
    await look(action);
    await page.keyboard.press('Escape');
  }
  await close();
});

/** Words of buttons, tabs, headings and table heads that do not fit where they stand, and pages that scroll sideways. */
const cut = (page: Page) =>
  page.evaluate(() => {
    const within = document.querySelector('dialog[open]') ?? document.body;
    const found: string[] = [];
    for (const element of within.querySelectorAll<HTMLElement>(
      'button, th, h2, h3, label, figcaption, .line-name, dt',
    )) {
      if (
        !element.checkVisibility() ||
        element.classList.contains('unseen') ||
        getComputedStyle(element).fontSize === '0px'
      )
        continue;
      if (element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0)
        found.push(`cut: ${element.textContent}`);
    }
    const { scrollWidth, clientWidth } = document.documentElement;
    if (scrollWidth > clientWidth) found.push(`the page is ${scrollWidth - clientWidth} px too wide`);
    return found;
  });
