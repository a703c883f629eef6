/** What somebody asks for in attributes of the element, or in the query of an address: the same names, the same values. */
import { groups, stateOf } from '../src/gallery.js';
import type { Controls, Settings, Shown } from '../src/mount.js';
import { operators, type Side, shapes } from '../src/polylap.js';
import { readState } from '../src/read-state.js';
import type { Gesture } from '../src/scene/host-scroll.js';
import type { Keys } from '../src/scope.js';
import {
  type Choice,
  forAnotherMesh,
  initialState,
  operatorOf,
  presets,
  type Source,
  type State,
  type Task,
  type Theme,
} from '../src/state.js';
import { t, told } from '../src/words.js';

/** What decides what is shown; the rest is how. */
export const contentNames = ['figure', 'mesh', 'a', 'b', 'lambda', 'task'] as const;
export type ContentName = (typeof contentNames)[number];

export const names = [
  ...contentNames,
  'views',
  'controls',
  'wheel',
  'touch',
  'keys',
  'theme',
  'autoplay',
  'loading',
  'poster',
  'alt',
  'lang',
] as const;
export type Name = (typeof names)[number];

export type Loading = 'eager' | 'lazy' | 'click';

export interface Wish {
  settings: Settings;
  theme: Theme;
  /** Steps of smoothing to play when it is in sight; 0: none. */
  autoplay: number;
  loading: Loading;
  poster: string | null;
  alt: string | null;
  /** The id of a figure that is no entry of the gallery. */
  figure: string | null;
  /** Of a mesh that the host has. */
  address: string | null;
  /** Puts what is asked for under some names, as far as it can be had, into a state. */
  apply: (state: State, changed: readonly ContentName[]) => State;
  /** What cannot be had, a sentence each; what could be is there. */
  problems: readonly string[];
}

const tasks = ['weights', 'smooth', 'harmonic', 'dual', 'check'] as const satisfies readonly Task[];
const shown = ['both', 'a', 'b', 'delta'] as const satisfies readonly Shown[];
const controls = ['full', 'some', 'none'] as const satisfies readonly Controls[];
const keys = ['capture', 'release', 'none'] as const satisfies readonly Keys[];
const themes = ['auto', 'light', 'dark'] as const satisfies readonly Theme[];
const loadings = ['eager', 'lazy', 'click'] as const satisfies readonly Loading[];
const wheels: Readonly<Record<string, Gesture>> = { zoom: 'mesh', scroll: 'scroll' };
const touches: Readonly<Record<string, Gesture>> = { turn: 'mesh', scroll: 'scroll' };

/** So many steps `autoplay` takes by itself: then there is something to see, and it rests. */
const autoplaySteps = 20;
const mostAutoplay = 1000;

const entries = groups.flatMap(({ entries }) => entries);
const list = (words: readonly string[]) => words.join(', ');

/** An address rather than a name. */
const looksLikeFile = (mesh: string) => /[/:]|\.(obj|off|ply|stl)$/i.test(mesh);

/** `id?name=value&…` */
function parts(text: string): { id: string; query: URLSearchParams } {
  const at = text.indexOf('?');
  return at < 0
    ? { id: text, query: new URLSearchParams() }
    : { id: text.slice(0, at), query: new URLSearchParams(text.slice(at + 1)) };
}

/** What a line of a table takes as numbers are numbers; read-state.ts says what is wrong with the rest. */
const parametersOf = (query: URLSearchParams) =>
  Object.fromEntries(
    [...query].map(([id, value]) => [
      id,
      value.trim() !== '' && Number.isFinite(Number(value)) ? Number(value) : value,
    ]),
  );

/** Of an element: it leaves the page that it is on as it is. */
const usually: Settings = { controls: 'some', views: 'both', keys: 'capture', wheel: 'scroll', touch: 'scroll' };

interface Place {
  /** What holds where nothing is given. */
  usual?: Settings;
  /** The figures that can be shown there, beside the entries of the gallery. */
  figures?: readonly string[];
}

/** @param get the value of a name; null where it is not given */
export function readWish(get: (name: Name) => string | null, { usual = usually, figures = [] }: Place = {}): Wish {
  const problems: string[] = [];
  const given = (name: Name) => get(name)?.trim() || null;
  const choose = <T extends string>(name: Name, allowed: readonly T[]): T | null => {
    const value = given(name);
    const found = allowed.find((each) => each === value) ?? null;
    if (value !== null && found === null)
      problems.push(t('{name} cannot be “{value}”; it is one of {list}.', { name, value, list: list(allowed) }));
    return found;
  };
  const gesture = (name: 'wheel' | 'touch', meanings: Readonly<Record<string, Gesture>>): Gesture =>
    meanings[choose(name, Object.keys(meanings)) ?? ''] ?? usual[name];
  const settings: Settings = {
    controls: choose('controls', controls) ?? usual.controls,
    views: choose('views', shown) ?? usual.views,
    keys: choose('keys', keys) ?? usual.keys,
    wheel: gesture('wheel', wheels),
    touch: gesture('touch', touches),
  };
  const task = choose('task', tasks);
  const wanted = get('autoplay') === null ? 0 : Number(given('autoplay') ?? autoplaySteps);
  const autoplay = Number.isInteger(wanted) && wanted >= 0 && wanted <= mostAutoplay ? wanted : 0;
  if (autoplay !== wanted)
    problems.push(
      t('autoplay is a number of steps up to {most}, not “{value}”.', {
        most: mostAutoplay,
        value: get('autoplay') ?? '',
      }),
    );

  const asked = given('figure');
  const figure = asked !== null && figures.includes(asked) ? asked : null;
  const entry = figure ? undefined : entries.find(({ id }) => id === asked?.replace(/^gallery:/, ''));
  if (asked !== null && !figure && !entry) {
    const there = [...new Set([...figures, ...entries.map(({ id }) => id)])];
    problems.push(t('There is no figure “{id}”. There are {list}.', { id: asked, list: list(there) }));
  }
  const mesh = given('mesh');
  const address = mesh !== null && sourceOf(mesh) === null && looksLikeFile(mesh) ? mesh : null;

  const puts: Readonly<Record<ContentName, (state: State) => State>> = {
    figure: (state) => (entry ? stateOf(entry, state) : state),
    mesh: (state) => {
      if (mesh === null || address !== null) return state;
      const source = sourceOf(mesh);
      if (source) return { ...state, ...forAnotherMesh(state), source };
      const there = list([...new Set([...presets, ...shapes].map(({ id }) => id))]);
      throw new Error(
        t(
          'There is no mesh “{id}”. There are {list}; a file is known by its address, which has a / or ends in .obj, .off, .ply or .stl.',
          { id: mesh, list: there },
        ),
      );
    },
    a: (state) => withChoice(state, 'a', given('a')),
    b: (state) => withChoice(state, 'b', given('b')),
    lambda: (state) => withLambda(state, given('lambda')),
    // What plays is there to be seen.
    task: (state) => ({ ...state, task: task ?? (autoplay > 0 && !entry ? 'smooth' : state.task) }),
  };
  const put = (state: State, name: ContentName) => readState(puts[name](state));
  let state = initialState();
  const possible = contentNames.filter((name) => {
    try {
      state = put(state, name);
      return true;
    } catch (reason) {
      problems.push(sentence(reason));
      return false;
    }
  });
  return {
    settings,
    theme: choose('theme', themes) ?? 'auto',
    autoplay,
    loading: choose('loading', loadings) ?? 'lazy',
    poster: given('poster'),
    alt: given('alt'),
    figure,
    address,
    apply: (state, changed) => changed.filter((name) => possible.includes(name)).reduce(put, state),
    problems,
  };
}

function sourceOf(mesh: string): Source | null {
  if (presets.some(({ id }) => id === mesh)) return { kind: 'preset', id: mesh };
  const { id, query } = parts(mesh);
  if (!shapes.some((shape) => shape.id === id)) return null;
  return { kind: 'shape', shape: { id, parameters: parametersOf(query) } };
}

function withChoice(state: State, side: Side, wanted: string | null): State {
  if (wanted === null) return state;
  const { id, query } = parts(wanted);
  if (!operators.some((operator) => operator.id === id)) {
    const there = list(operators.map((operator) => operator.id));
    throw new Error(t('There is no operator “{id}” for {side}. There are {list}.', { id, side, list: there }));
  }
  return { ...state, sides: { ...state.sides, [side]: { operator: id, parameters: parametersOf(query) } } };
}

/** For the operators that have it. */
function withLambda(state: State, wanted: string | null): State {
  if (wanted === null) return state;
  const lambda = Number(wanted);
  if (!Number.isFinite(lambda)) throw new Error(t('“{value}” is no number for lambda.', { value: wanted }));
  const withIt = (side: Side): Choice => {
    const choice = state.sides[side];
    const has = operatorOf(choice).parameters.some(({ id }) => id === 'lambda');
    return has ? { ...choice, parameters: { ...choice.parameters, lambda } } : choice;
  };
  return { ...state, sides: { a: withIt('a'), b: withIt('b') } };
}

function sentence(reason: unknown): string {
  const text = told(reason instanceof Error ? reason.message : String(reason));
  return `${text[0]?.toUpperCase() ?? ''}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`;
}
