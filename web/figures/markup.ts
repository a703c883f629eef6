/** A figure as HTML: the same when the site is built and in an embed. Nothing in it is inline: no styles, no handlers. */
import { exact } from '../src/format.js';
import { digitsIn } from './digits.js';
import type { Control, Figure, Reading, Setting, Settings } from './figure.js';
import type { Loaded } from './list.js';
import { escapeText, tag } from './svg.js';
import { type Lang, plain, sayer } from './words.js';

/** A figure as it stands, ready to be written down. */
export interface Shown extends Loaded {
  readonly lang: Lang;
  readonly settings: Settings;
  /** SVG, or what stands in its place. */
  readonly drawing: string;
  readonly readings: readonly Reading[];
  /** Address of the full page with the same state. */
  readonly permalink: string;
}

export const readingText = ({ text, value }: Reading): string => text ?? exact(value);

/** What the runtime has to know of controls before the figure itself is loaded. */
const controlData = ({ controls }: Figure): string => JSON.stringify(controls);

function controlHtml(control: Control, setting: Setting, { words, lang }: Shown): string {
  const { id, kind } = control;
  const name = words.controls[id] ?? id;
  if (kind === 'slider') {
    const input = tag('input', {
      type: 'range',
      name: id,
      // Its label may be a formula.
      'aria-label': plain(name),
      min: String(control.min),
      max: String(control.max),
      step: String(control.step),
      value: String(setting),
      autocomplete: 'off',
    });
    const output = tag('output', { 'data-of': id }, digitsIn(lang, exact(Number(setting))));
    return tag('label', { class: 'slider' }, tag('span', { class: 'name' }, name), input, output);
  }
  if (kind !== 'choice') return '';
  const options = control.choices.map((choice) => {
    const radio = tag('input', {
      type: 'radio',
      name: id,
      value: choice,
      checked: choice === setting,
      autocomplete: 'off',
    });
    return tag('label', {}, radio, tag('span', {}, escapeText(words.choices?.[id]?.[choice] ?? choice)));
  });
  return tag('fieldset', { class: 'choice' }, tag('legend', {}, name), tag('div', { class: 'choices' }, ...options));
}

export const readingHtml = (reading: Reading): string =>
  tag(
    'dd',
    { 'data-reading': reading.id, 'data-value': String(reading.value), class: reading.bad ? 'bad' : undefined },
    escapeText(readingText(reading)),
  );

const readingsHtml = (readings: readonly Reading[], { words }: Loaded): string =>
  tag(
    'dl',
    { class: 'readings' },
    ...readings.map((reading) =>
      tag('div', {}, tag('dt', {}, words.readings[reading.id] ?? reading.id), readingHtml(reading)),
    ),
  );

/** The picture in place of the views, which start when they are asked for. */
const comparedHtml = ({ words, shared, drawing }: Shown): string =>
  tag(
    'div',
    { class: 'drawing compared', role: 'group', 'aria-label': words.alt },
    tag('div', { class: 'still', 'aria-hidden': 'true' }, drawing),
    tag('button', { type: 'button', class: 'start' }, sayer(shared)('start')),
  );

/** The drawing; one that can be turned takes the keys itself. */
function drawingHtml(shown: Shown): string {
  const { figure, words, drawing, settings } = shown;
  if (figure.kind === 'compared') return comparedHtml(shown);
  const turn = figure.controls.find(({ kind }) => kind === 'turn');
  const handles = figure.controls.some(({ kind }) => kind === 'handle');
  const inner = turn
    ? tag(
        'div',
        {
          class: 'turned',
          'data-turn': turn.id,
          tabindex: '0',
          role: 'slider',
          'aria-label': plain(words.controls[turn.id] ?? turn.id),
          'aria-valuemin': '-180',
          'aria-valuemax': '180',
          ...turnValues(settings[turn.id]),
        },
        drawing,
      )
    : drawing;
  const several = drawing.split('<svg').length - 1;
  return tag(
    'div',
    {
      class: 'drawing',
      'data-several': several > 1 ? several : undefined,
      role: handles || turn ? 'group' : 'img',
      'aria-label': words.alt,
    },
    inner,
  );
}

/** Where a turned drawing stands, for those who hear it. */
export function turnValues(setting: Setting | undefined): Record<'aria-valuenow' | 'aria-valuetext', string> {
  const [azimuth = 0, elevation = 0] = Array.isArray(setting) ? (setting as number[]) : [];
  return {
    'aria-valuenow': String(Math.round(azimuth)),
    'aria-valuetext': `${Math.round(azimuth)}°, ${Math.round(elevation)}°`,
  };
}

/** The figure itself: drawing, controls, readings, caption. */
export function figureHtml(shown: Shown): string {
  const { figure, words, lang, permalink } = shown;
  const say = sayer(shown.shared);
  const controls = figure.controls.map((control) =>
    controlHtml(control, shown.settings[control.id] ?? control.initial, shown),
  );
  const hint = ['handle', 'turn'].find((kind) => figure.controls.some((control) => control.kind === kind));
  if (hint) controls.push(tag('p', { class: 'hint' }, say(hint)));
  const reset = tag('button', { type: 'reset' }, say('reset'));
  const numbered = say('figure', { number: figure.number });
  const name = tag('b', {}, numbered);
  // Several figures on one page are told apart.
  const controlsName = `${say('controls')}, ${numbered}`;
  return tag(
    'figure',
    {
      class: 'live-figure',
      id: `figure-${figure.id}`,
      'data-figure': figure.id,
      'data-kind': figure.kind,
      'data-controls': controlData(figure),
      'data-state': 'asleep',
      lang,
    },
    drawingHtml(shown),
    tag('form', { class: 'controls', 'aria-label': controlsName, autocomplete: 'off' }, ...controls, reset),
    readingsHtml(shown.readings, shown),
    tag('p', { class: 'note', role: 'status', 'data-loading': say('loading'), 'data-failed': say('failed') }, ''),
    tag(
      'figcaption',
      {},
      tag('p', { class: 'caption' }, name, ' ', words.caption),
      tag('p', { class: 'links' }, tag('a', { class: 'permalink', href: permalink }, say('open'))),
    ),
  );
}

/** What is to be read beside a figure: what to try, why it is so, and where that is from. */
export function textHtml({ words, shared }: Loaded): string {
  const say = sayer(shared);
  const items = (entries: readonly string[]) => entries.map((entry) => tag('li', {}, entry));
  return [
    tag('section', { class: 'try' }, tag('h2', {}, say('try')), tag('ol', {}, ...items(words.try))),
    tag('section', { class: 'why' }, tag('h2', {}, say('why')), ...words.why.map((entry) => tag('p', {}, entry))),
    tag('section', { class: 'sources' }, tag('h2', {}, say('sources')), tag('ul', {}, ...items(words.sources))),
  ].join('');
}
