/** A soap film between two rings, by Pinkall and Polthier's iteration, beside the catenoid (the subject of Herholz 2012, Fig. 2.1). */
import { moveOf } from '../../src/moves.js';
import type { Client, OperatorSpec } from '../../src/polylap.js';
import { initialState, type State } from '../../src/state.js';
import { drawn, type Reading, type Settings } from '../figure.js';
import { fixed } from '../svg.js';
import { areaOf, radiusAt, waist } from './catenoid.js';
import { drawFilm } from './draw.js';
import { cylinderOf, type Film, relaxBoth, smoothOptions } from './film.js';

export interface FilmData {
  readonly h: number;
  /** Of the planar operator, from the cylinder on; fewer than there are steps if it pinched off. */
  readonly films: readonly Film[];
  /** After each step, how far Alexa and Wardetzky's film is from it at most. */
  readonly apart: readonly number[];
  readonly offsets: Int32Array;
  readonly corners: Int32Array;
  /** Vertices around. */
  readonly around: number;
  /** Of the catenoid; NaN where there is none. */
  readonly waist: number;
}

export const resolution = { around: 48, along: 12 };
const mostSteps = 60;
const operators: Record<'a' | 'b', OperatorSpec> = { a: { id: 'alexa-wardetzky' }, b: { id: 'planar' } };

async function compute(client: Client, settings: Settings): Promise<FilmData> {
  const h = settings.distance as number;
  const { films, mesh } = await relaxBoth(client, operators, { h, steps: mostSteps, ...resolution });
  const apart = films.b.flatMap(({ coordinates }, step) => {
    const other = films.a[step]?.coordinates;
    return other ? [farthest(coordinates, other)] : [];
  });
  const { offsets, corners } = mesh.geometry;
  return { h, films: films.b, apart, offsets, corners, around: resolution.around, waist: waist(h) };
}

function farthest(one: Float64Array, other: Float64Array): number {
  let most = 0;
  for (let k = 0; k < one.length; k += 3) {
    const along = (c: number) => (one[k + c] as number) - (other[k + c] as number);
    most = Math.max(most, Math.hypot(along(0), along(1), along(2)));
  }
  return most;
}

/** Radius and height of each ring of the film, from below. */
export function profile({ coordinates }: Film, around: number): [number, number][] {
  const rings: [number, number][] = [];
  for (let k = 0; k < coordinates.length; k += 3 * around)
    rings.push([Math.hypot(coordinates[k] as number, coordinates[k + 1] as number), coordinates[k + 2] as number]);
  return rings;
}

/** The film after so many steps, or the last one there was; and whether it pinched off before. */
export function shown({ films }: FilmData, { steps }: Settings): { film: Film; step: number; pinched: boolean } {
  const step = Math.min(steps as number, films.length - 1);
  return { film: films[step] as Film, step, pinched: step < (steps as number) };
}

/** How far a film is from the catenoid at most, along the radius. */
export const deviation = (film: Film, around: number, c: number): number =>
  Math.max(...profile(film, around).map(([r, z]) => Math.abs(r - radiusAt(c, z))));

function read(data: FilmData, settings: Settings): Reading[] {
  const { film, step, pinched } = shown(data, settings);
  const { waist: c, h, around } = data;
  const neck = Math.min(...profile(film, around).map(([r]) => r));
  const plain = (id: string, value: number, decimals = 4): Reading => ({
    id,
    value,
    text: Number.isNaN(value) ? '–' : fixed(value, decimals),
  });
  return [
    plain('area', film.area),
    plain('catenoid', areaOf(c, h)),
    plain('discs', 2 * Math.PI),
    { ...plain('neck', neck), bad: pinched },
    plain('waist', c),
    plain('deviation', deviation(film, around, c), 6),
    plain('apart', data.apart[step] ?? Number.NaN, 6),
  ];
}

function state({ distance, steps }: Settings): State {
  const start = initialState();
  const { shape, ...parameters } = cylinderOf(distance as number, resolution);
  const smoothing: State = {
    ...start,
    task: 'smooth',
    source: { kind: 'shape', shape: { id: shape, parameters } },
    smooth: { ...start.smooth, ...smoothOptions },
  };
  // Where a film pinches off the page would say that it cannot go on.
  const taken = Number.isNaN(waist(distance as number)) ? Math.min(steps as number, 5) : (steps as number);
  return taken === 0 ? smoothing : { ...smoothing, moves: [{ ...moveOf(smoothing), steps: taken }], step: taken };
}

export const figure = drawn<FilmData>({
  id: 'soap-film',
  number: 12,
  controls: [
    { kind: 'slider', id: 'distance', min: 0.2, max: 0.8, step: 0.01, initial: 0.6 },
    { kind: 'slider', id: 'steps', view: true, min: 0, max: mostSteps, step: 1, initial: 1 },
    { kind: 'turn', id: 'view', view: true, initial: [20, 22] },
  ],
  compute,
  draw: drawFilm,
  read,
  state,
});
