/** What a frame shows, or a page of which something is asked by name: the element, as large as the frame. */

import { adopt } from '../src/adopt.js';
import { readLink } from '../src/share.js';
import { PolylapCompare } from './element.js';
import { serveFrame } from './frame.js';
import styles from './frame-page.css?inline';
import type { Events } from './live.js';
import { wanted } from './wanted.js';
import { names } from './wish.js';

const element = new PolylapCompare();
/** With nothing asked for it is the whole page. */
const usual = new Map([['controls', 'full']]);

function follow(): void {
  const asked = wanted();
  const given = names.some((name) => name !== 'lang' && asked.has(name)) ? new Map<string, string>() : usual;
  for (const name of names) {
    const value = asked.get(name) ?? given.get(name);
    if (value === undefined) element.removeAttribute(name);
    else element.setAttribute(name, value);
  }
  void followLink();
}

/** A link to a state, with its file if that is in it. */
async function followLink(): Promise<void> {
  try {
    const link = await readLink(location.hash);
    if (!link) return;
    const { state, file } = link;
    if (file && state.source.kind === 'file') await element.load(file, state.source.name);
    await element.setState(state);
  } catch (reason) {
    frame?.tell('error', { message: reason instanceof Error ? reason.message : String(reason) });
  }
}

const bound = <K extends 'getState' | 'setState' | 'load' | 'step' | 'reset' | 'toPNG' | 'toSVG' | 'matrix'>(name: K) =>
  (element[name] as (...given: never[]) => unknown).bind(element);
const frame = serveFrame({
  methods: {
    getState: bound('getState'),
    setState: bound('setState'),
    load: bound('load'),
    step: bound('step'),
    reset: bound('reset'),
    toPNG: bound('toPNG'),
    toSVG: bound('toSVG'),
    matrix: bound('matrix'),
  },
  releasesKeys: () => ['release', 'none'].includes(element.getAttribute('keys') ?? ''),
});
const events: readonly (keyof Events)[] = ['ready', 'state-change', 'pick', 'step', 'error'];
for (const type of events) element.addEventListener(type, (event) => frame?.tell(type, (event as CustomEvent).detail));

adopt(document, styles);
follow();
document.body.replaceChildren(element);
window.addEventListener('hashchange', follow);
