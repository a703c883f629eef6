/**
 * Brings figures to life. Until one is touched there is nothing but their markup and this; the figure's own code, the client and the core come with the
 * first touch, one client for all figures of a page.
 */
import { exact } from '../src/format.js';
import { latest } from '../src/latest.js';
import type { Client } from '../src/polylap.js';
import type { ComparedPage } from './compared.js';
import { digitsIn } from './digits.js';
import type { Control, Point, Reading, Setting, Settings } from './figure.js';
import { grasp } from './grasp.js';
import { type Load, type Loaded, load } from './list.js';
import { figureHtml, readingText, turnValues } from './markup.js';
import { morphChildren } from './morph.js';
import { type Lang, sayer } from './words.js';

export interface MountOptions {
  lang?: Lang;
  /** Where figures come from, if not from beside the page. */
  load?: Load;
  /** The client, once it is needed; that of the page unless told. */
  client?: () => Promise<Client>;
  /** Address of the full page, for the permalink; what the markup has unless told. */
  fullPage?: string;
  /** `release`: arrow keys stay with whoever else wants them, as in slides. */
  keys?: 'take' | 'release';
}

export interface Mounted {
  readonly id: string;
  readonly element: HTMLElement;
  settings(): Settings;
  /** What is out of range is brought into it. */
  set(change: Settings): void;
  reset(): void;
  /** Loads what it takes and computes; done when nothing is under way. */
  wake(): Promise<void>;
  destroy(): void;
}

const sharedClient = async (): Promise<Client> => (await import('../src/start-client.js')).sharedClient();

/** How long a pointer rests on a figure before it counts as one that wants something, in ms. */
const intent = 120;

/**
 * @param host holds the markup of a figure (see markup.ts); without any, it is made
 * @throws Error when there is no such figure
 */
export async function mount(host: HTMLElement, id: string, options: MountOptions = {}): Promise<Mounted> {
  const found = host.matches('[data-figure]') ? host : host.querySelector<HTMLElement>(`[data-figure="${id}"]`);
  if (found) return hydrate(found, options);
  const { client = sharedClient, lang = 'en', fullPage = '../index.html' } = options;
  const { render } = await import('./show.js');
  const loaded = await (options.load ?? load)(id, lang);
  host.innerHTML = figureHtml(await render(await client(), loaded, { lang, fullPage }));
  return hydrate(host.firstElementChild as HTMLElement, options);
}

/** All figures of a document that stand there as markup. */
export const hydrateAll = (root: ParentNode = document, options: MountOptions = {}): Mounted[] =>
  [...root.querySelectorAll<HTMLElement>('[data-figure]')].map((figure) => hydrate(figure, options));

export function hydrate(element: HTMLElement, options: MountOptions = {}): Mounted {
  return new LiveFigure(element, options);
}

const clamp = (value: number, min: number, max: number): number => Math.min(max, Math.max(min, value));

class LiveFigure implements Mounted {
  readonly id: string;
  readonly #controls: readonly Control[];
  readonly #options: MountOptions;
  readonly #gone = new AbortController();
  #settings: Settings;
  #awake: Promise<{ loaded: Loaded; client: Client } | null> | undefined;
  /** What was computed last, and for which settings. */
  #computed: { settings: Settings; data: unknown } | undefined;
  #working: Promise<void> = Promise.resolve();
  #finished: (() => void) | undefined;
  #intent: ReturnType<typeof setTimeout> | undefined;
  /** The page in a figure that compares, once it has been started. */
  #page: ComparedPage | undefined;

  constructor(
    readonly element: HTMLElement,
    options: MountOptions,
  ) {
    this.#options = options;
    this.id = element.dataset.figure ?? '';
    this.#controls = JSON.parse(element.dataset.controls ?? '[]');
    this.#settings = this.#initial();
    // A browser that comes back to a page may fill in what was there. Nobody has touched the figure by this.
    this.#form?.reset();
    this.#listen();
  }

  settings(): Settings {
    return this.#settings;
  }

  set(change: Settings): void {
    this.#settings = { ...this.#settings, ...this.#within(change) };
    this.#showControls();
    void this.wake();
  }

  reset(): void {
    this.set(this.#initial());
  }

  async wake(): Promise<void> {
    if (!this.#finished) this.#working = new Promise((done) => (this.#finished = done));
    this.#show(this.#settings);
    await this.#working;
  }

  destroy(): void {
    clearTimeout(this.#intent);
    this.#gone.abort();
    this.#page?.dispose();
  }

  #initial(): Settings {
    return Object.fromEntries(this.#controls.map(({ id, initial }) => [id, initial]));
  }

  #within(change: Settings): Settings {
    const entries = this.#controls.flatMap((control): [string, Setting][] => {
      const given = change[control.id];
      if (given === undefined) return [];
      return [[control.id, fitting(control, given)]];
    });
    return Object.fromEntries(entries);
  }

  get #isHeavy(): boolean {
    return this.element.dataset.kind === 'compared';
  }

  get #lang(): Lang {
    return this.element.lang === 'de' ? 'de' : 'en';
  }

  get #form(): HTMLFormElement | null {
    return this.element.querySelector('form');
  }

  get #drawing(): HTMLElement {
    return this.element.querySelector('.drawing') as HTMLElement;
  }

  #say(text: string): void {
    const note = this.element.querySelector('.note');
    if (note && note.textContent !== text) note.textContent = text;
  }

  /** Of settings that come faster than answers only the newest is computed. */
  readonly #show = latest(async (settings: Settings): Promise<void> => {
    const awake = await this.#loaded();
    if (awake && !this.#gone.signal.aborted) await this.#update(settings, awake);
    // Controls and figure go on saying the same.
    if (!awake) {
      this.#settings = this.#computed?.settings ?? this.#initial();
      this.#showControls();
    }
    if (settings !== this.#settings && awake) return;
    this.element.dataset.state = awake ? 'ready' : 'asleep';
    const finished = this.#finished;
    this.#finished = undefined;
    finished?.();
  });

  #loaded(): Promise<{ loaded: Loaded; client: Client } | null> {
    this.#awake ??= this.#fetch().catch((reason) => {
      console.error(reason);
      // What could not be had may be had the next time.
      this.#awake = undefined;
      this.#say(this.element.querySelector<HTMLElement>('.note')?.dataset.failed ?? '');
      return null;
    });
    return this.#awake;
  }

  async #fetch(): Promise<{ loaded: Loaded; client: Client }> {
    this.element.dataset.state = 'loading';
    this.#say(this.element.querySelector<HTMLElement>('.note')?.dataset.loading ?? '');
    const lang = this.#lang;
    const { client = sharedClient, load: from = load } = this.#options;
    const [loaded, started] = await Promise.all([from(this.id, lang), client()]);
    this.#say('');
    return { loaded, client: started };
  }

  async #update(settings: Settings, { loaded, client }: { loaded: Loaded; client: Client }): Promise<void> {
    const { figure, words, shared } = loaded;
    this.element.dataset.state = 'busy';
    void this.#link(settings, loaded);
    try {
      const stale =
        !this.#computed ||
        this.#controls.some(({ id, view }) => !view && this.#computed?.settings[id] !== settings[id]);
      const page = figure.kind === 'compared' ? await this.#started(client) : null;
      const [data] = await Promise.all([
        stale ? figure.compute(client, settings) : this.#computed?.data,
        page?.show(figure.state(settings)),
      ]);
      this.#computed = { settings, data };
      if (figure.kind === 'drawn') this.#draw(figure.draw(data, settings, sayer(words)), settings);
      this.#read(figure.kind === 'drawn' ? figure.read(data, settings) : (data as readonly Reading[]));
      this.#say('');
    } catch (reason) {
      const message = reason instanceof Error ? reason.message : String(reason);
      this.#say(sayer(shared)('error', { reason: message }));
    }
  }

  async #started(client: Client): Promise<ComparedPage> {
    const { startCompared } = await import('./compared.js');
    const keys = this.#options.keys === 'release' ? 'release' : 'capture';
    this.#page ??= await startCompared(this.#drawing, client, { keys, lang: this.element.lang });
    return this.#page;
  }

  #draw(drawing: string, settings: Settings): void {
    const parsed = document.createElement('template');
    parsed.innerHTML = drawing;
    const turned = this.#drawing.querySelector<HTMLElement>('[data-turn]');
    const { activeElement } = this.element.getRootNode() as Document | ShadowRoot;
    const focused = activeElement?.getAttribute('data-handle');
    morphChildren(turned ?? this.#drawing, parsed.content as unknown as Element);
    if (focused && !activeElement?.isConnected)
      this.#drawing.querySelector<SVGElement>(`[data-handle="${CSS.escape(focused)}"]`)?.focus();
    if (turned)
      for (const [name, value] of Object.entries(turnValues(settings[turned.dataset.turn ?? ''])))
        turned.setAttribute(name, value);
  }

  #read(readings: readonly Reading[]): void {
    for (const reading of readings) {
      const place = this.element.querySelector<HTMLElement>(`[data-reading="${reading.id}"]`);
      if (!place) continue;
      place.dataset.value = String(reading.value);
      place.textContent = readingText(reading);
      place.classList.toggle('bad', reading.bad === true);
    }
  }

  async #link(settings: Settings, { figure }: Loaded): Promise<void> {
    const link = this.element.querySelector<HTMLAnchorElement>('a.permalink');
    if (!link) return;
    const { permalink } = await import('./show.js');
    const page = this.#options.fullPage ?? link.getAttribute('href')?.replace(/#.*$/, '') ?? '';
    const address = await permalink(figure, settings, page);
    if (settings === this.#settings) link.setAttribute('href', address);
  }

  #showControls(): void {
    for (const { id, kind } of this.#controls) {
      const setting = this.#settings[id];
      const inputs = this.element.querySelectorAll<HTMLInputElement>(`input[name="${CSS.escape(id)}"]`);
      for (const input of inputs) {
        if (kind === 'choice') input.checked = input.value === setting;
        else if (input.valueAsNumber !== setting) input.valueAsNumber = Number(setting);
      }
      const output = this.element.querySelector(`output[data-of="${CSS.escape(id)}"]`);
      if (output) output.textContent = digitsIn(this.#lang, exact(Number(setting)));
    }
  }

  #listen(): void {
    const { element } = this;
    const { signal } = this.#gone;
    const on = <K extends keyof HTMLElementEventMap>(name: K, act: (event: HTMLElementEventMap[K]) => void) =>
      element.addEventListener(name, act, { signal });
    on('pointerenter', ({ pointerType }) => {
      if (pointerType === 'mouse' && !this.#awake && !this.#isHeavy)
        this.#intent = setTimeout(() => void this.wake(), intent);
    });
    on('pointerleave', () => clearTimeout(this.#intent));
    const first = ({ target }: Event) => {
      const wants = target instanceof Element && target.closest('.controls, .drawing');
      if (wants && !this.#awake) void this.wake();
    };
    // Who only passes by with the pointer or the Tab key has not asked for two views.
    if (this.#isHeavy) on('click', first);
    else {
      on('focusin', first);
      on('pointerdown', first);
    }
    on('input', ({ target }) => this.#input(target));
    on('reset', () => this.reset());
    on('submit', (event) => event.preventDefault());
    grasp(element, this.#controls, {
      setting: (id) => this.#settings[id] as Point,
      set: (id, point) => this.set({ [id]: point }),
      takesKeys: this.#options.keys !== 'release',
      signal,
    });
  }

  #input(target: EventTarget | null): void {
    if (!(target instanceof HTMLInputElement)) return;
    this.set({ [target.name]: target.type === 'range' ? target.valueAsNumber : target.value });
  }
}

/** A setting as the control can have it. */
function fitting(control: Control, given: Setting): Setting {
  switch (control.kind) {
    case 'slider':
      return clamp(Number(given), control.min, control.max);
    case 'choice':
      return control.choices.includes(String(given)) ? String(given) : control.initial;
    case 'handle': {
      const [x, y] = given as Point;
      return [clamp(x, control.min[0], control.max[0]), clamp(y, control.min[1], control.max[1])];
    }
    case 'turn': {
      const [azimuth, elevation] = given as Point;
      return [((((azimuth + 180) % 360) + 360) % 360) - 180, clamp(elevation, -90, 90)];
    }
  }
}
