import type { App } from '../app.js';
import { h } from '../dom.js';
import { words } from '../format.js';
import type { Side } from '../polylap.js';
import { operatorOf } from '../state.js';
import { menu, numberField, slider } from './controls.js';

/** The parameters of a side's operator, one row each, as the operator table describes them. */
export function parameterControls(app: App, side: Side): HTMLElement {
  const element = h('div', { class: 'parameters' });
  let setters: Record<string, (value: number | string) => void> = {};
  app.state.watch(
    (state) => [state.sides[side].operator],
    () => {
      setters = {};
      element.replaceChildren(...operatorOf(app.state.get().sides[side]).parameters.map(row));
    },
  );
  app.state.watch(
    (state) => [state.sides[side].parameters],
    (parameters) => {
      for (const [id, value] of Object.entries(parameters)) setters[id]?.(value);
    },
  );
  return element;

  type Parameter = ReturnType<typeof operatorOf>['parameters'][number];
  function row(parameter: Parameter): HTMLElement {
    const { id, label, hint } = parameter;
    const name = `${label} of ${side.toUpperCase()}`;
    const set = (value: number | string) => app.setParameter(side, id, value);
    const hintElement = hint ? h('span', { class: 'hint', title: hint }, hint) : null;
    const rowOf = (...controls: HTMLElement[]) =>
      h(
        'div',
        { class: 'parameter', 'data-parameter': id },
        h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, label),
        ...controls,
        hintElement,
      );
    if (parameter.kind === 'choice') {
      const choice = menu(
        name,
        parameter.choices.map((value) => [value, words(value)] as const),
        set,
      );
      setters[id] = (value) => {
        choice.value = String(value);
      };
      setters[id](app.state.get().sides[side].parameters[id] ?? '');
      return rowOf(choice);
    }
    const { min, max, sliderMax, step } = parameter;
    const track = slider({ label: name, min, max: sliderMax, step, onInput: set });
    const field = numberField({
      label: `${name}, value`,
      min,
      max,
      step,
      onChange: set,
      onRefuse: (why) => app.say(why),
    });
    setters[id] = (value) => {
      track.set(Number(value), String(value));
      field.set(Number(value));
    };
    setters[id](app.state.get().sides[side].parameters[id] ?? parameter.initial);
    return rowOf(track.element, field.element);
  }
}
