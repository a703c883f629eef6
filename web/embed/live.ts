import { specOf } from '../src/answers.js';
import type { App } from '../src/app.js';
import { type Mounted, mount } from '../src/mount.js';
import type { Matrices, Shape, Side } from '../src/polylap.js';
import { readState } from '../src/read-state.js';
import { sharedClient } from '../src/start-client.js';
import { type State, sides, type View, views } from '../src/state.js';
import { t } from '../src/words.js';
import { fullPage } from './home.js';
import { surfaceSvg } from './surface-svg.js';
import { type ContentName, contentNames, type Wish } from './wish.js';

/** What is told to the host, see element.ts. */
export interface Events {
  ready: { state: State };
  'state-change': { state: State };
  pick: { vertex: number | null; face: number | null };
  step: { step: number; a: Shape; b: Shape };
  error: { message: string };
}
export type Emit = <K extends keyof Events>(type: K, detail: Events[K]) => void;

/** What outlives an element's time in the document. */
export interface Kept {
  state: State;
  file: Blob | null;
}

export type MeshFile = ArrayBuffer | Uint8Array<ArrayBuffer> | Blob | string;

const still = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
const whole = ({ title, text }: { title: string; text: string }) => `${title}. ${text}`;

/** The page in an element: what the attributes wish for, what scripts ask of it, and what it tells. */
export class LivePage {
  readonly mounted: Mounted;
  /** The mesh and its first numbers are there, or the reason why not is shown. */
  readonly ready: Promise<void>;
  private readonly app: App;
  private inView = false;
  /** Whether it plays when it comes into view. */
  private plays: boolean;
  /** After so many steps it rests. */
  private rest: number;

  /**
   * @param kept what it was when it left the document
   * @param changed what it shows is not what it would show
   */
  constructor(
    ground: HTMLElement,
    private wish: Wish,
    first: State,
    kept: Kept | null,
    private readonly emit: Emit,
    changed: () => void,
  ) {
    this.rest = wish.autoplay;
    this.plays = this.rest > 0 && !still();
    this.mounted = mount(ground, {
      client: sharedClient(),
      settings: wish.settings,
      asleep: true,
      onStale: changed,
      start: (app) => this.begin(app, first, kept),
    });
    this.app = this.mounted.app;
    this.app.address = fullPage;
    this.app.state.set({ theme: wish.theme });
    this.ready = this.mounted.ready.then(() => this.settled()).then(() => this.listen(changed));
    this.app.results.watch(
      (results) => [results.error],
      (error) => error && emit('error', { message: whole(error) }),
    );
  }

  private async begin(app: App, first: State, kept: Kept | null): Promise<void> {
    const state = kept?.state ?? this.wish.apply(first, contentNames);
    if (kept?.file && state.source.kind === 'file')
      await app.goTo({ ...state, source: { ...state.source, file: app.meshes.keep(kept.file) } });
    else if (this.wish.address && !kept) {
      const { source: _, ...rest } = state;
      app.state.set(rest);
      await this.fetched(this.wish.address, app);
      // It begins as a mesh of its own; what was asked for besides holds for it.
      if (app.results.get().mesh) await app.goTo({ ...rest, source: app.state.get().source });
    } else await app.goTo(state);
    // Where its numbers can be read.
    if (this.wish.settings.controls === 'full' && app.results.get().mesh && app.state.get().selected === null)
      app.select(app.front());
  }

  private listen(changed: () => void): void {
    const { app, emit } = this;
    let told = app.state.get();
    let waiting = false;
    app.state.watch(
      (state) => [state],
      (state) => {
        if (waiting || state === told) return;
        waiting = true;
        queueMicrotask(() => {
          waiting = false;
          const { selected, selectedFace } = told;
          told = app.state.get();
          emit('state-change', { state: told });
          if (told.selected !== selected || told.selectedFace !== selectedFace)
            emit('pick', { vertex: told.selected, face: told.selectedFace });
        });
      },
    );
    let { step } = app.results.get().a;
    app.results.watch(
      ({ a, b }) => [a.step, b.step, a.shape, b.shape],
      (one, other, a, b) => {
        if (one !== other || one === step || !a || !b) return;
        step = one;
        emit('step', { step, a, b });
        if (this.rest > 0 && step >= this.rest) {
          this.rest = 0;
          app.smoothing.pause();
        }
      },
    );
    // A picture that nobody draws is drawn when there is nothing to wait for.
    app.results.watch(
      (results) => [results],
      () => this.stale && changed(),
    );
    this.follow();
  }

  // --- in view and out of it ----------------------------------------------------------------------------------------------

  get stale(): boolean {
    return this.mounted.viewer.stale && this.app.results.get().mesh !== null && this.app.work.idle;
  }

  wake(): void {
    this.mounted.wake();
  }

  sleep(): void {
    this.mounted.sleep();
  }

  seen(inView: boolean): void {
    this.inView = inView;
    void this.ready.then(() => this.follow());
  }

  /** Nobody watches what plays out of view. */
  private follow(): void {
    const { smoothing, results } = this.app;
    if (this.inView && this.plays) {
      this.plays = false;
      void smoothing.play();
    } else if (!this.inView && results.get().playing) {
      this.plays = true;
      smoothing.pause();
    }
  }

  // --- what changes it ----------------------------------------------------------------------------------------------------

  /** @param names what else is wished for than before */
  async change(wish: Wish, names: readonly ContentName[]): Promise<void> {
    const { app } = this;
    const played = this.wish.autoplay;
    this.wish = wish;
    this.mounted.set(wish.settings);
    if (app.state.get().theme !== wish.theme) app.state.set({ theme: wish.theme });
    if (wish.autoplay !== played) {
      this.rest = wish.autoplay;
      this.plays = this.rest > 0 && !still();
      if (this.rest === 0) app.smoothing.pause();
    }
    await this.ready;
    if (names.includes('mesh') && wish.address) await this.fetched(wish.address);
    const state = wish.apply(app.state.get(), names);
    if (names.length > 0) await app.goTo(state);
    this.follow();
  }

  /** A mesh of the host's. What goes wrong is shown. */
  private async fetched(address: string, app = this.app): Promise<void> {
    const name = decodeURIComponent(new URL(address, document.baseURI).pathname.split('/').pop() ?? '') || address;
    // It has been told.
    const contents = await this.had(address, name, app).catch(() => null);
    if (contents) await app.meshes.open(contents, name);
  }

  /** What is at an address. @throws Error, which is shown, too */
  private async had(address: string, name = address, app = this.app): Promise<Blob> {
    try {
      return await meshAt(address);
    } catch (reason) {
      const text = reason instanceof Error ? reason.message : String(reason);
      app.results.set({ error: { title: t('{name} could not be loaded', { name }), text } });
      throw reason;
    }
  }

  /** Until nothing is under way. */
  settled(): Promise<void> {
    const { app } = this;
    const done = () => {
      const { mesh, error, playing, a, b } = app.results.get();
      const numbers = mesh ? a.weights !== null && b.weights !== null : error !== null;
      return numbers && (app.work.idle || playing);
    };
    return new Promise((resolve) => {
      let timer: ReturnType<typeof setTimeout> | undefined;
      const look = () => {
        clearTimeout(timer);
        timer = setTimeout(() => {
          if (!done()) return;
          stop();
          resolve();
        });
      };
      let stop = () => {};
      stop = app.results.watch((results) => [results], look);
    });
  }

  // --- what scripts ask for -----------------------------------------------------------------------------------------------

  get state(): State {
    return structuredClone(this.app.state.get());
  }

  get kept(): Kept {
    const { source } = this.app.state.get();
    const file = source.kind === 'file' ? (this.app.meshes.contents(source.file) ?? null) : null;
    return { state: this.app.state.get(), file };
  }

  async setState(value: unknown): Promise<void> {
    const { app } = this;
    const state = readState(structuredClone(value));
    if (state.source.kind === 'file') {
      const { source } = app.state.get();
      if (source.kind !== 'file' || source.name !== state.source.name)
        throw new Error(`The state is of ${state.source.name}, which is not here: load() it first.`);
      state.source = { ...state.source, file: source.file };
    }
    this.good(await app.goTo(state));
    await this.settled();
  }

  async load(from: MeshFile, name?: string): Promise<{ vertices: number; faces: number }> {
    const { app } = this;
    const contents = typeof from === 'string' ? await this.had(from) : from instanceof Blob ? from : new Blob([from]);
    const known = typeof from === 'string' ? from.replace(/[?#].*$/, '').replace(/.*\//, '') : '';
    const file = name ?? (from instanceof File ? from.name : known || 'mesh.obj');
    const error = await app.meshes.open(contents, file);
    if (error) throw new Error(whole(error));
    await this.settled();
    const { vertices = 0, faces = 0 } = app.results.get().mesh ?? {};
    return { vertices, faces };
  }

  async step(count = 1): Promise<number> {
    if (!(Number.isInteger(count) && count > 0)) throw new Error('step() takes a whole number above 0.');
    this.app.results.set({ error: null });
    for (let k = 0; k < count; k++) {
      await this.app.smoothing.step();
      this.good(true);
    }
    await this.settled();
    return this.app.state.get().step;
  }

  async reset(): Promise<void> {
    await this.app.smoothing.reset();
    await this.settled();
  }

  /** @returns what is seen in a view, or in all that there are, side by side */
  async toPng(view?: View): Promise<Blob> {
    const { mounted } = this;
    const wanted = view ? [known(view)] : views.filter((each) => mounted.viewer.seen(each));
    const shots = await Promise.all(wanted.map((each) => this.showing(each, () => mounted.photograph(each, false))));
    if (shots.length === 1 && shots[0]) return shots[0];
    const pictures = await Promise.all(shots.map((shot) => createImageBitmap(shot)));
    const canvas = document.createElement('canvas');
    canvas.width = pictures.reduce((sum, { width }) => sum + width, 0);
    canvas.height = Math.max(...pictures.map(({ height }) => height));
    const context = canvas.getContext('2d');
    let x = 0;
    for (const picture of pictures) {
      context?.drawImage(picture, x, 0);
      x += picture.width;
      picture.close();
    }
    return new Promise((resolve, reject) => {
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture is too large to be saved.'))));
    });
  }

  toSvg(view?: View): string {
    const { viewer } = this.mounted;
    const wanted = view ? known(view) : (views.find((each) => viewer.seen(each)) ?? 'a');
    return this.showing(wanted, () => surfaceSvg(this.app, viewer, wanted));
  }

  /** With a view on screen for which there may be no room: for as long as nothing is painted. */
  private showing<T>(view: View, shoot: () => T): T {
    const { viewer, element } = this.mounted;
    const there = view !== 'delta' || this.app.results.get().difference !== null;
    if (viewer.seen(view) || !there) return shoot();
    const { views: before = 'both' } = element.dataset;
    element.dataset.views = view;
    try {
      return shoot();
    } finally {
      element.dataset.views = before;
      viewer.request();
    }
  }

  async matrix(side: Side): Promise<Matrices> {
    if (!sides.includes(side)) throw new Error(`There are the sides a and b, not ${side}.`);
    const { mesh } = this.app.results.get();
    if (!mesh) throw new Error('There is no mesh yet.');
    const { sides: choices, vertexWeights } = this.app.state.get();
    return mesh.matrices(specOf(choices[side], vertexWeights[side], mesh.vertices), { side });
  }

  dispose(): void {
    this.mounted.dispose();
  }

  /** @throws Error with what the page shows as wrong */
  private good(fine: boolean): void {
    const { error } = this.app.results.get();
    if (error) throw new Error(whole(error));
    if (!fine) throw new Error('Something else was asked for in the meantime.');
  }
}

function known(view: View): View {
  if (!views.includes(view)) throw new Error(`There are the views ${views.join(', ')}, not ${view}.`);
  return view;
}

/** @throws Error, a sentence */
async function meshAt(address: string): Promise<Blob> {
  const answer = await fetch(new URL(address, document.baseURI)).catch(() => null);
  if (!answer)
    throw new Error(t('There is no answer from {address}, or it does not let other sites read it.', { address }));
  if (!answer.ok) throw new Error(t('The server of {address} says {status}.', { address, status: answer.status }));
  return answer.blob();
}
