import { h } from '../dom.js';
import { exact, typed } from '../format.js';
import { focusedBy } from '../scope.js';
import { t, word } from '../words.js';

let ids = 0;
export const newId = (stem: string) => `${stem}-${++ids}`;

export interface NumberOptions {
  label: string;
  /** Which has that label: this one gets an addition. */
  besideSlider?: boolean;
  min?: number;
  max?: number | (() => number);
  integer?: boolean;
  /** What the arrow keys add. */
  step?: number;
  onChange: (value: number) => void;
  onEmpty?: () => void;
  /** @param why one sentence */
  onRefuse: (why: string) => void;
}

/**
 * A number field that takes what is valid as it is typed, and shows the last valid value again when left with something else.
 * A text field, because browsers drop the decimal comma from others and read 0,5 as 05.
 */
export function numberField(options: NumberOptions): {
  element: HTMLInputElement;
  set: (value: number | null) => void;
} {
  let held: number | null = null;
  const { label: subject, min = -Infinity, integer = false, step } = options;
  const label = options.besideSlider ? t('{name}, value', { name: subject }) : subject;
  const max = () => (typeof options.max === 'function' ? options.max() : (options.max ?? Infinity));
  const valid = (value: number) => value >= min && value <= max() && (!integer || Number.isInteger(value));
  const allowed = () => {
    const kind = t(integer ? word('whole numbers') : word('numbers'));
    const [low, high] = [exact(min), exact(max())];
    if (min === -Infinity && max() === Infinity) return kind;
    return max() === Infinity
      ? t('{kind} from {low}', { kind, low })
      : t('{kind} from {low} to {high}', { kind, low, high });
  };
  const write = (value: number | null) => {
    element.value = value === null ? '' : typed(value);
    element.removeAttribute('aria-invalid');
  };
  const take = (value: number) => {
    if (value === held) return;
    held = value;
    options.onChange(value);
  };
  const element = h('input', {
    type: 'text',
    class: 'number',
    autocomplete: 'off',
    // The keyboards of some phones have no minus among the decimals.
    inputmode: min >= 0 ? (integer ? 'numeric' : 'decimal') : undefined,
    'aria-label': label,
    onpointerenter: () => {
      element.title = `${subject}: ${allowed()}`;
    },
    oninput: () => {
      const value = parseNumber(element.value);
      if (valid(value)) take(value);
      if (valid(value) || element.value.trim() === '') element.removeAttribute('aria-invalid');
      else element.setAttribute('aria-invalid', 'true');
    },
    onchange: () => {
      const text = element.value.trim();
      if (text === '' && options.onEmpty) options.onEmpty();
      else if (text !== '' && !valid(parseNumber(text)))
        options.onRefuse(
          t('{name} takes {numbers}, not {text}.', { name: subject, numbers: allowed(), text: text.slice(0, 24) }),
        );
      if (text !== '' || !options.onEmpty) write(held);
    },
    onkeydown: (event: KeyboardEvent) => {
      const by = { ArrowUp: step, ArrowDown: step && -step }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      const value = Number(((held ?? 0) + by).toPrecision(12));
      if (!valid(value)) return;
      take(value);
      write(value);
    },
  });
  return {
    element,
    set: (value) => {
      held = value;
      // What is being typed ("1." on the way to "1.5") is left alone as long as it means the same.
      if (value === null || parseNumber(element.value) !== value) write(value);
    },
  };
}

/** With a decimal point or comma, and either minus; NaN if it is no number. */
export function parseNumber(text: string): number {
  const plain = text.trim().replaceAll('−', '-').replace(',', '.');
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : Number.NaN;
}

export function slider(options: {
  label: string;
  min: number;
  max: number;
  step: number | 'any';
  onInput: (value: number) => void;
}) {
  const element = h('input', {
    type: 'range',
    'aria-label': options.label,
    min: options.min,
    max: options.max,
    step: options.step,
    oninput: () => options.onInput(element.valueAsNumber),
  });
  const paint = () => {
    const share = (element.valueAsNumber - options.min) / (Number(element.max) - options.min || 1);
    element.style.setProperty('--share', `${100 * Math.min(1, Math.max(0, share))}%`);
  };
  element.addEventListener('input', paint);
  return {
    element,
    set: (value: number, text?: string) => {
      if (focusedBy(element) !== element || element.valueAsNumber !== value) element.value = String(value);
      if (text) element.setAttribute('aria-valuetext', text);
      paint();
    },
  };
}

export function button(text: string, onclick: () => void, properties: Record<string, unknown> = {}): HTMLButtonElement {
  return h('button', { type: 'button', onclick, ...properties }, text);
}

/** A native menu; `options` are [value, text]. */
export function menu(
  label: string,
  options: readonly (readonly [string, string])[],
  onPick: (value: string) => void,
  properties: Record<string, unknown> = {},
) {
  const element = h(
    'select',
    { 'aria-label': label, onchange: () => onPick(element.value), ...properties },
    ...options.map(([value, text]) => h('option', { value }, text)),
  );
  return element;
}
