import { App } from './app.js';
import { bindEdges } from './bind-edges.js';
import { bindPins } from './bind-pins.js';
import { bindInput, bindKeys, bindViewer } from './bind-viewer.js';
import { bindWeights } from './bind-weights.js';
import { h } from './dom.js';
import { page } from './layout/page.js';
import type { Client } from './polylap.js';
import type { Gestures } from './scene/host-scroll.js';
import { Viewer } from './scene/viewer.js';
import { type Keys, Scope } from './scope.js';
import { views as allViews, type View } from './state.js';
import { type Language, language, t } from './words.js';

/** The whole page; tasks, operators and their parameters; or the views with the loud numbers. */
export type Controls = 'full' | 'some' | 'none';
/** Which views there are: A and B, of which a narrow page shows one and a switch, or one alone. */
export type Shown = 'both' | View;

/** How it behaves on the page that it is part of. */
export interface Settings extends Gestures {
  controls: Controls;
  views: Shown;
  keys: Keys;
}

export interface MountOptions {
  /** May be shared; what it holds for this page is closed with it. */
  client: Promise<Client>;
  /** The page is the document: keys, drops and pastes anywhere in it are its own. */
  whole?: boolean;
  settings?: Partial<Settings>;
  /** Brings the first mesh, or whatever there is to see first. */
  start: (app: App) => Promise<unknown>;
  /** Of a page that was released: goes on where that was. */
  app?: App;
  /** Offers the other languages, and does what it takes to speak one: see words.ts. */
  speak?: (language: Language) => void;
  /** Draws nothing before wake(). */
  asleep?: boolean;
  /** After each frame. */
  onFrame?: () => void;
  /** Asleep, and what there is to see has changed. */
  onStale?: () => void;
}

export interface Mounted {
  readonly app: App;
  readonly viewer: Viewer;
  /** What was appended to the root; it fills it. */
  readonly element: HTMLElement;
  /** What there is to see first has been asked for, and the mesh is there, or the reason why not. */
  readonly ready: Promise<void>;
  /** Changes how it behaves, at once. */
  set(settings: Partial<Settings>): void;
  /** @returns false where there is no WebGL, which is told in the views */
  wake(): boolean;
  /** Holds no WebGL context any more; the last picture stays, and everything else goes on. */
  sleep(): void;
  /** A view as a PNG, whether it sleeps or not. @throws Error, a sentence, where there is no WebGL or the view is not on screen */
  photograph(view: View, transparent: boolean): Promise<Blob>;
  /** Takes away what is seen and leaves the rest, to be mounted again in another language. */
  release(): App;
  /** Leaves nothing behind: no listener, no context, no mesh in the workers. */
  dispose(): void;
}

/** A page has one title, one banner and one main part: not those of what is part of it. */
function withoutLandmarks(body: HTMLElement): void {
  for (const each of body.querySelectorAll('header, footer, h1')) each.setAttribute('role', 'none');
}

/**
 * The page within a part of a document or within a shadow root, in the language of words.ts.
 * The style sheet `styles/main.css` belongs to whoever owns the root.
 */
export function mount(root: ShadowRoot | HTMLElement, options: MountOptions): Mounted {
  const { client, whole = false, start } = options;
  const settings: Settings = {
    controls: 'full',
    views: 'both',
    keys: 'capture',
    wheel: 'auto',
    touch: 'auto',
    ...options.settings,
  };
  const app = options.app ?? new App(client);
  const forget = [app.state.mark(), app.results.mark()];
  const ready = options.app ? Promise.resolve() : start(app).then(() => app.history.begin());
  const taken = options.app?.results.get().mesh;
  if (options.app) app.translate();
  const body = h('div', { class: 'page' });
  const probe = h('span', { class: 'colour-probe', 'aria-hidden': 'true' });
  const element = h('div', { class: 'polylap', lang: language(), 'data-whole': String(whole) }, body, probe);
  root.append(element);
  const scope = new Scope(element, root, whole, settings.keys);

  const photograph = async (view: View, transparent: boolean) => {
    const slept = !viewer.awake;
    if (!wake()) throw new Error(t('This browser shows no WebGL, so there are no pictures.'));
    try {
      return await viewer.photograph(view, transparent);
    } finally {
      if (slept) viewer.sleep();
    }
  };
  const { canvas, views, help } = page(app, body, scope, photograph, options.speak);
  bindKeys(app, scope, help);
  if (!whole) withoutLandmarks(body);

  const overlays = allViews.map((side) => {
    const message = h('p', { class: 'view-message', hidden: true });
    views[side].append(message);
    return message;
  });
  const tell = (text: string | null) => {
    for (const overlay of overlays) {
      overlay.hidden = text === null;
      overlay.textContent = text ?? '';
    }
    if (text) app.say(text);
  };

  const viewer = new Viewer(canvas, views, settings, {
    afterFrame: () => options.onFrame?.(),
    stale: () => options.onStale?.(),
    lost: () => tell(t('The graphics card took the picture away. It comes back by itself as soon as it can.')),
    restored: () => {
      tell(null);
      app.say(t('The picture is back.'));
    },
  });
  app.front = () => viewer.front() ?? 0;
  let failed = false;
  const wake = () => {
    if (failed) return false;
    try {
      viewer.wake();
    } catch {
      failed = true;
      void ready.then(() =>
        tell(t('This browser shows no WebGL, so the meshes cannot be drawn. All numbers are right without it.')),
      );
    }
    return !failed;
  };
  bindViewer(app, viewer);
  bindInput(app, viewer, views);
  bindPins(app, viewer, views);
  bindWeights(app, viewer);
  bindEdges(app, viewer, views);

  app.state.watch(
    (state) => [state.theme],
    (theme) => {
      element.dataset.theme = theme;
      viewer.recolour();
    },
  );
  // Its colours are those of the page, whoever changes them: the system, the host's style sheet, or a class on an element around.
  probe.addEventListener('transitionend', () => viewer.recolour());
  // Something to read from the start: the row of a vertex in front.
  app.results.watch(
    (results) => [results.mesh],
    (mesh) => {
      // After all that is asked about a new mesh in any case.
      queueMicrotask(() => {
        const { selected } = app.state.get();
        if (mesh && mesh !== taken && app.results.get().mesh === mesh && selected === null) app.select(app.front());
      });
    },
  );

  const set = (patch: Partial<Settings>) => {
    Object.assign(settings, patch);
    scope.keys = settings.keys;
    element.dataset.controls = settings.controls;
    element.dataset.views = settings.views;
    const named = settings.controls === 'none';
    for (const name of element.querySelectorAll<HTMLElement>('.operator-name')) name.hidden = !named;
    viewer.camera.settleGestures();
    showOnly();
  };
  const showOnly = () => {
    const { views: only } = settings;
    const { shown, delta } = app.state.get();
    const open = only === 'delta';
    if (only !== 'both' && (shown !== only || delta.open !== open))
      app.state.set({ shown: only, delta: { ...delta, open } });
  };
  app.state.watch((state) => [state.shown, state.delta.open], showOnly);
  set({});
  if (!options.asleep) wake();

  const release = () => {
    scope.end();
    for (const each of forget) each();
    viewer.dispose();
    element.remove();
    return app;
  };
  const dispose = () => release().close();
  return { app, viewer, element, ready, set, wake, sleep: () => viewer.sleep(), photograph, release, dispose };
}
