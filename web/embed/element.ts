/**
 * `<polylap-compare>`: two discrete Laplace operators on a polygon mesh, or a figure, on any page.
 *
 *     <script type="module" src="polylap-compare.js"></script>
 *     <polylap-compare mesh="noisy-torus" a="alexa-wardetzky?lambda=1" b="planar" task="smooth"></polylap-compare>
 *
 * Attributes, all optional; changes take effect at once:
 *   mesh      id of an example or of a shape (`torus?nu=24&nv=12`), or the address of an OBJ, OFF, PLY or STL file (another site's needs CORS)
 *   a, b      ids of operators, with parameters after a `?`
 *   lambda    λ of the operators that have one
 *   task      weights | smooth | harmonic | dual | check
 *   figure    id of a figure, which brings all of the above; given beside it, they change it. `gallery:<id>` is that entry of the gallery
 *   views     both | a | b | delta
 *   controls  some | full | none: the tasks and the operators' parameters; the whole page; only the views with their loud numbers
 *   wheel     scroll | zoom: whose the wheel is without Ctrl
 *   touch     scroll | turn: whose one finger is, up and down
 *   keys      capture | release | none: while the focus is inside; `release` leaves arrows, Space and page keys to the host
 *   theme     auto | light | dark: `auto` is the host's color-scheme
 *   autoplay  a number of steps, 20 if empty: smooths when in sight, unless less motion is asked for
 *   loading   lazy | eager | click: near the viewport, at once, or by a button over the poster
 *   poster    address of a picture to show before that;   alt: what there is to see, for who does not see it
 *   lang      en | de; that of the host's element otherwise. One language for all elements of a page: that of the one that starts last
 *
 * Events, which bubble and are composed, with `detail`:
 *   ready         { state }
 *   state-change  { state }                               whatever changed it
 *   pick          { vertex, face }                        what is selected; null where nothing is
 *   step          { step, a, b }                          measures of both surfaces after a step, see Shape
 *   error         { message }                             a sentence; it is shown, too
 *
 * Custom properties: --polylap-paper, -card, -ink, -quiet, -hairline, -border, -accent, -on-accent, -negative, -mesh-lit, -mesh-shade, -mesh-edge,
 * -mesh-spoke, -serif, -sans. Parts: page, header, tasks, message, views, card, card-a, card-b, card-delta, view, view-a, view-b, view-delta, operator,
 * counter, parameters, panel, status, legend, cover, start, figure.
 */
import { ids as figures } from '../figures/list.js';
import { adopt } from '../src/adopt.js';
import { h } from '../src/dom.js';
import type { Matrices, Side } from '../src/polylap.js';
import { initialState, type State, type View } from '../src/state.js';
import embedStyles from '../src/styles/embed.css?inline';
import styles from '../src/styles/main.css?inline';
import { languageOf, setLanguage, t } from '../src/words.js';
import { crowd, type Member } from './crowd.js';
import { LiveFigure } from './figure.js';
import { type Emit, type Events, type Kept, LivePage, type MeshFile } from './live.js';
import { type ContentName, contentNames, type Name, names, readWish, type Wish } from './wish.js';

/** What is mounted: the page, or a drawn figure. */
type Live = LivePage | LiveFigure;

/** What hosts may style. */
const parts: Readonly<Record<string, string>> = {
  '.polylap': 'page',
  '.masthead': 'header',
  '.tabs': 'tasks',
  '.messages': 'message',
  '.stage': 'views',
  '.card': 'card',
  '.view': 'view',
  '.operator, .operator-name': 'operator',
  '.loud': 'counter',
  '.card-foot': 'parameters',
  '.panel': 'panel',
  '.status': 'status',
  '.legend': 'legend',
  '.card[data-side=a]': 'card-a',
  '.card[data-side=b]': 'card-b',
  '.card[data-side=delta]': 'card-delta',
  '.view[data-view=a]': 'view-a',
  '.view[data-view=b]': 'view-b',
  '.view[data-view=delta]': 'view-delta',
};

export class PolylapCompare extends HTMLElement implements Member {
  static readonly observedAttributes = names;

  readonly #ground = h('div', { class: 'ground' });
  readonly #wrong = h('p', { class: 'wrong', role: 'alert', hidden: true, part: 'message' });
  #cover: HTMLElement | null = null;
  #wish: Wish | null = null;
  #live: Live | null = null;
  #kept: Kept | null = null;
  #changed = new Set<Name>();
  #listening: AbortController | null = null;
  /** Counts what was begun: what belongs to an earlier one is of no interest. */
  #turn = 0;
  #begun = false;
  #ready = deferred<Live>();
  #isReady = false;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    root.append(h('div', { class: 'embed' }, this.#wrong, this.#ground));
    adopt(root, styles);
    adopt(root, embedStyles);
  }

  connectedCallback(): void {
    // Only moved.
    if (this.#listening) return;
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    const use = () => crowd.use(this);
    this.addEventListener('pointerenter', use, { signal });
    this.addEventListener('focusin', use, { signal });
    void this.#speak().then(() => {
      if (signal.aborted) return;
      const { loading } = this.#read();
      this.#showCover();
      crowd.add(this, this);
      if (loading === 'eager' || this.#begun) this.#start();
    });
  }

  /** Where its words cannot be had it speaks English. */
  #speak(): Promise<void> {
    const around = this.closest<HTMLElement>('[lang]')?.lang;
    return setLanguage(languageOf(this.getAttribute('lang'), around)).catch(() => {});
  }

  disconnectedCallback(): void {
    // Who moves an element takes it out and puts it in at once.
    queueMicrotask(() => {
      if (this.isConnected || !this.#listening) return;
      this.#listening.abort();
      this.#listening = null;
      this.#wish = null;
      crowd.remove(this);
      this.#stop();
    });
  }

  attributeChangedCallback(name: Name, before: string | null, now: string | null): void {
    if (before === now || !this.#listening || !this.#wish) return;
    // Several that are set at once are one change.
    if (this.#changed.size === 0) queueMicrotask(() => this.#change());
    this.#changed.add(name);
  }

  // --- for scripts; each waits until the element is ready, which starts it -------------------------------------------------

  /** What is shown, as data: JSON that setState() and links of the page take. Of a drawn figure, what the page shows instead. */
  async getState(): Promise<State> {
    return (await this.#started()).state;
  }

  /** @throws Error, a sentence that names what is wrong; then everything stays as it is */
  async setState(state: unknown): Promise<void> {
    return (await this.#page()).setState(state);
  }

  /**
   * Opens a mesh: the bytes or the text-file of an OBJ, OFF, PLY or STL file, or its address.
   * @throws Error, a sentence that names line, face or vertex; then the mesh stays as it is
   */
  async load(from: MeshFile, name?: string): Promise<{ vertices: number; faces: number }> {
    return (await this.#page()).load(from, name);
  }

  /** Takes steps of smoothing on both sides. @returns how many there are now */
  async step(count = 1): Promise<number> {
    return (await this.#page()).step(count);
  }

  /** Back to the loaded mesh; of a drawn figure, to its first settings. */
  async reset(): Promise<void> {
    return (await this.#started()).reset();
  }

  /** What is seen in a view, or in all of them side by side, at twice the resolution of the screen. */
  async toPNG(view?: View): Promise<Blob> {
    return (await this.#started()).toPng(view);
  }

  /** What is seen as polygons that print sharply. */
  async toSVG(view?: View): Promise<string> {
    return (await this.#started()).toSvg(view);
  }

  /** Stiffness and mass of a side's operator on its surface. */
  async matrix(side: Side): Promise<Matrices> {
    return (await this.#page()).matrix(side);
  }

  // --- for the crowd ------------------------------------------------------------------------------------------------------

  get stale(): boolean {
    return this.#live?.stale ?? false;
  }

  seen(inView: boolean): void {
    if (inView && this.#wish?.loading === 'lazy') this.#start();
    this.#live?.seen(inView);
    this.#inView = inView;
  }
  #inView = false;

  wake(): void {
    this.#live?.wake();
  }

  sleep(): void {
    this.#live?.sleep();
  }

  // --- from attributes ----------------------------------------------------------------------------------------------------

  #read(): Wish {
    const wish = readWish((name) => this.getAttribute(name), { figures });
    this.#wish = wish;
    this.#wrong.hidden = wish.problems.length === 0;
    this.#wrong.textContent = wish.problems.join(' ');
    // Once whoever made the element had time to listen.
    for (const message of wish.problems) setTimeout(() => this.#emit('error', { message }));
    return wish;
  }

  #change(): void {
    const changed = [...this.#changed];
    this.#changed.clear();
    if (!this.#listening) return;
    const before = this.#wish;
    const wish = this.#read();
    const names = contentNames.filter((name): name is ContentName => changed.includes(name));
    const otherFigure = before?.figure !== wish.figure;
    if (!this.#begun) {
      this.#showCover();
      if (wish.loading === 'eager' || (wish.loading === 'lazy' && this.#inView)) this.#start();
    } else if (otherFigure || wish.figure !== null || changed.includes('lang')) {
      this.#stop();
      if (otherFigure) this.#kept = null;
      this.#start();
      // What was kept knows nothing of it.
      if (this.#kept && names.length > 0) void this.#started().then((live) => live.change(wish, names));
    } else void this.#started().then((live) => live.change(wish, names));
    this.#name();
  }

  /** What it is called, for those who do not see it. */
  #name(): void {
    const name = this.#wish?.alt ?? (this.#wish?.figure ? null : t('Two Laplace operators on one mesh'));
    if (name) this.#ground.setAttribute('aria-label', name);
    else this.#ground.removeAttribute('aria-label');
    this.#ground.setAttribute('role', 'group');
  }

  #showCover(): void {
    const { poster, alt, loading } = this.#wish as Wish;
    const picture = poster ? h('img', { src: poster, alt: alt ?? '' }) : null;
    const text = picture ? null : h('p', {}, alt);
    const start = h('button', { type: 'button', class: 'primary', part: 'start' }, t('Start'));
    start.addEventListener('click', () => this.#start());
    const cover = h('div', { class: 'cover', part: 'cover' }, picture, text, loading === 'click' ? start : null);
    this.#uncover();
    this.#cover = cover;
    this.#ground.append(cover);
    this.#name();
  }

  #uncover(): void {
    this.#cover?.remove();
    this.#cover = null;
  }

  // --- life ---------------------------------------------------------------------------------------------------------------

  #start(): void {
    this.#begun = true;
    if (this.#live || !this.#listening || !this.#wish) return;
    const turn = ++this.#turn;
    this.#begin(() => turn === this.#turn).catch((reason) => {
      if (turn !== this.#turn) return;
      const message = reason instanceof Error ? reason.message : String(reason);
      this.#wrong.hidden = false;
      this.#wrong.textContent = message;
      this.#emit('error', { message });
      this.#begun = false;
      this.#ready.reject(new Error(message));
      this.#ready = deferred();
    });
  }

  async #begin(wanted: () => boolean): Promise<void> {
    await this.#speak();
    if (!wanted()) return;
    const wish = this.#wish as Wish;
    const { figure } = wish;
    const keys = wish.settings.keys === 'capture' ? 'take' : 'release';
    const drawn = figure === null ? null : await LiveFigure.of(figure, this.#ground, keys);
    if (!wanted()) return drawn instanceof LiveFigure ? drawn.dispose() : undefined;
    const live =
      drawn instanceof LiveFigure
        ? drawn
        : new LivePage(this.#ground, wish, drawn ?? initialState(), this.#kept, this.#emit, () => crowd.look());
    this.#live = live;
    this.toggleAttribute('data-drawn', live instanceof LiveFigure);
    for (const [selector, name] of Object.entries(parts))
      for (const element of this.#ground.querySelectorAll(selector)) element.part.add(name);
    crowd.look();
    await live.ready;
    if (!wanted()) return;
    this.#uncover();
    live.seen(this.#inView);
    this.#ready.resolve(live);
    this.#isReady = true;
    this.#emit('ready', { state: live.state });
  }

  #stop(): void {
    this.#turn++;
    if (this.#live instanceof LivePage) this.#kept = this.#live.kept;
    this.#live?.dispose();
    this.#live = null;
    // Who waits already waits for the next one.
    if (this.#isReady) this.#ready = deferred();
    this.#isReady = false;
    this.#ground.replaceChildren();
  }

  #started(): Promise<Live> {
    this.#start();
    return this.#ready.promise;
  }

  async #page(): Promise<LivePage> {
    const live = await this.#started();
    if (live instanceof LiveFigure)
      throw new Error('This figure is a drawing: there are getState(), reset(), toSVG() and toPNG().');
    return live;
  }

  readonly #emit: Emit = (type, detail) => {
    this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true, composed: true }));
  };
}

interface Deferred<T> {
  promise: Promise<T>;
  resolve: (value: T) => void;
  reject: (reason: Error) => void;
}

function deferred<T>(): Deferred<T> {
  const made = {} as Deferred<T>;
  made.promise = new Promise<T>((resolve, reject) => Object.assign(made, { resolve, reject }));
  // Whoever waits for it is told; nobody else needs to be.
  made.promise.catch(() => {});
  return made;
}

declare global {
  interface HTMLElementTagNameMap {
    'polylap-compare': PolylapCompare;
  }
}

/** The events of `<polylap-compare>`; addEventListener takes them where its listener says so. */
export type PolylapEvents = { [K in keyof Events]: CustomEvent<Events[K]> };

if (!customElements.get('polylap-compare')) customElements.define('polylap-compare', PolylapCompare);
