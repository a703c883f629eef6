import type { OperatorInfo, ShapeSpec, Side } from './polylap.js';
import { operators } from './polylap.js';

export type Task = 'weights' | 'smooth' | 'harmonic';
export type Theme = 'auto' | 'light' | 'dark';
export const sides: readonly Side[] = ['a', 'b'];

export interface Pin {
  vertex: number;
  value: number;
}

/** An operator and the parameters that differ from the table's initial ones or were touched. */
export interface Choice {
  operator: string;
  parameters: Readonly<Record<string, number | string>>;
}

export type Source = { kind: 'preset'; id: string } | { kind: 'file'; name: string };

/** Everything a person has chosen; plain data, so that it can be stored and sent. What was computed from it is in results.ts. */
export interface State {
  version: 1;
  task: Task;
  source: Source;
  sides: Readonly<Record<Side, Choice>>;
  smooth: { timeH2: number; rebuild: boolean };
  harmonic: { pins: readonly Pin[]; value: number };
  /** In which tasks negative weights are drawn on the meshes. */
  negativeShown: Readonly<Record<Task, boolean>>;
  /** The vertex whose numbers are read. */
  selected: number | null;
  /** Which side is seen where there is room for one. */
  shown: Side;
  theme: Theme;
}

export interface Preset {
  id: string;
  label: string;
  shape: ShapeSpec;
}

export const presets: readonly Preset[] = [
  { id: 'noisy-torus', label: 'Noisy torus', shape: { shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 } },
  { id: 'torus', label: 'Torus', shape: { shape: 'torus', nu: 32, nv: 16 } },
  { id: 'noisy-saddle', label: 'Noisy saddle', shape: { shape: 'saddle', n: 16, height: 0.6, noise: 0.25, seed: 1 } },
  { id: 'saddle', label: 'Saddle', shape: { shape: 'saddle', n: 16, height: 0.6 } },
  { id: 'grid-8', label: 'Grid, 8 × 8', shape: { shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 } },
  { id: 'grid-2', label: 'Grid, 2 × 2', shape: { shape: 'grid', nx: 2, ny: 2, width: 2, height: 2 } },
];

/** What the page opens with: the only place that names operators. */
const openingPair: Readonly<Record<Side, string>> = { a: 'alexa-wardetzky', b: 'planar' };

export function initialState(): State {
  return {
    version: 1,
    task: 'weights',
    source: { kind: 'preset', id: 'noisy-torus' },
    sides: { a: initialChoice(openingPair.a), b: initialChoice(openingPair.b) },
    smooth: { timeH2: 0.02, rebuild: true },
    harmonic: { pins: [], value: 1 },
    negativeShown: { weights: true, smooth: true, harmonic: false },
    selected: null,
    shown: 'a',
    theme: 'auto',
  };
}

export function operatorOf({ operator }: { operator: string }): OperatorInfo {
  const entry = operators.find(({ id }) => id === operator) ?? operators[0];
  if (!entry) throw new Error('The operator table is empty.');
  return entry;
}

export function initialChoice(operator: string): Choice {
  const entry = operatorOf({ operator });
  const parameters: Record<string, number | string> = {};
  for (const { id, initial } of entry.parameters) parameters[id] = initial;
  return { operator: entry.id, parameters };
}

/** Sets, changes or (with null) removes the pin at a vertex. */
export function withPin(pins: readonly Pin[], vertex: number, value: number | null): Pin[] {
  const rest = pins.filter((pin) => pin.vertex !== vertex);
  if (value === null) return rest;
  const at = pins.findIndex((pin) => pin.vertex === vertex);
  if (at < 0) return [...rest, { vertex, value }];
  return pins.map((pin) => (pin.vertex === vertex ? { vertex, value } : pin));
}
