import { h } from '../dom.js';

let ids = 0;
export const newId = (stem: string) => `${stem}-${++ids}`;

export interface NumberOptions {
  label: string;
  min?: number;
  max?: number;
  step?: number | 'any';
  onChange: (value: number) => void;
  onEmpty?: () => void;
}

/** A number field that takes what is valid as it is typed, and shows the last valid value again when left with something else. */
export function numberField(options: NumberOptions): {
  element: HTMLInputElement;
  set: (value: number | null) => void;
} {
  let held: number | null = null;
  const element = h('input', {
    type: 'number',
    class: 'number',
    'aria-label': options.label,
    min: options.min,
    max: options.max,
    step: options.step ?? 'any',
    oninput: () => {
      const value = element.valueAsNumber;
      const inside = value >= (options.min ?? -Infinity) && value <= (options.max ?? Infinity);
      if (!Number.isFinite(value) || !inside || value === held) return;
      held = value;
      options.onChange(value);
    },
    onchange: () => {
      if (element.value === '' && !element.validity.badInput && options.onEmpty) options.onEmpty();
      else if (element.valueAsNumber !== held) element.value = held === null ? '' : String(held);
    },
  });
  return {
    element,
    set: (value) => {
      held = value;
      // What is being typed ("1." on the way to "1.5") is left alone as long as it means the same.
      if (element.valueAsNumber !== value) element.value = value === null ? '' : String(value);
    },
  };
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
    const share = (element.valueAsNumber - options.min) / (options.max - options.min || 1);
    element.style.setProperty('--share', `${100 * Math.min(1, Math.max(0, share))}%`);
  };
  element.addEventListener('input', paint);
  return {
    element,
    set: (value: number, text?: string) => {
      if (document.activeElement !== element || element.valueAsNumber !== value) element.value = String(value);
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
