import type { App } from '../app.js';
import { h } from '../dom.js';
import { typed, words } from '../format.js';
import type { Parameter, Side } from '../polylap.js';
import { operatorOf, type Parameters } from '../state.js';
import { t } from '../words.js';
import { menu, numberField, slider } from './controls.js';

interface Rows {
  elements: HTMLElement[];
  show: (values: Parameters) => void;
}

/**
 * One row for each parameter, as its table describes it.
 * @param nameOf makes a label the spoken name, e.g. "λ of A"
 */
export function parameterRows(
  parameters: readonly Parameter[],
  nameOf: (label: string) => string,
  set: (id: string, value: number | string) => void,
  refuse: (why: string) => void,
): Rows {
  const setters: Record<string, (value: number | string) => void> = {};
  const row = (parameter: Parameter): HTMLElement => {
    const { id } = parameter;
    const [label, hint] = [t(parameter.label), parameter.hint && t(parameter.hint)];
    const name = nameOf(label);
    const take = (value: number | string) => set(id, value);
    const hintElement = hint ? h('span', { class: 'hint', title: hint }, hint) : null;
    const rowOf = (...controls: HTMLElement[]) =>
      h(
        'div',
        { class: `parameter ${parameter.kind}`, 'data-parameter': id },
        h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, label),
        ...controls,
        hintElement,
      );
    if (parameter.kind === 'choice') {
      const choice = menu(
        name,
        parameter.choices.map((value) => [value, t(words(value))] as const),
        take,
      );
      setters[id] = (value) => {
        choice.value = String(value);
      };
      return rowOf(choice);
    }
    const { min, max, sliderMax, step } = parameter;
    const track = slider({ label: name, min, max: sliderMax, step, onInput: take });
    const field = numberField({
      label: name,
      besideSlider: true,
      min,
      max,
      step,
      integer: parameter.kind === 'integer',
      onChange: take,
      onRefuse: refuse,
    });
    setters[id] = (value) => {
      track.set(Number(value), typed(Number(value)));
      field.set(Number(value));
    };
    return rowOf(track.element, field.element);
  };
  const elements = parameters.map(row);
  return {
    elements,
    show: (values) => {
      for (const { id, initial } of parameters) setters[id]?.(values[id] ?? initial);
    },
  };
}

/** The parameters of a side's operator. */
export function parameterControls(app: App, side: Side): HTMLElement {
  const element = h('div', { class: 'parameters' });
  let rows: Rows | null = null;
  app.state.watch(
    (state) => [state.sides[side].operator],
    () => {
      const { parameters } = operatorOf(app.state.get().sides[side]);
      rows = parameterRows(
        parameters,
        (name) => t('{name} of {side}', { name, side: side.toUpperCase() }),
        (id, value) => app.setParameter(side, id, value),
        (why) => app.refuse(why),
      );
      element.replaceChildren(...rows.elements);
    },
  );
  app.state.watch(
    (state) => [state.sides[side].parameters],
    (parameters) => rows?.show(parameters),
  );
  return element;
}
