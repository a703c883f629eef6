/**
 * What a figure is. Its numbers come from the core, its picture from those: the same code runs when the site is built, where it makes the page that is
 * read without scripts, and in that page from the first touch on.
 */
import type { Client } from '../src/polylap.js';
import type { State } from '../src/state.js';

export type Point = readonly [number, number];
export type Setting = number | string | Point;
/** By the id of the control. */
export type Settings = Readonly<Record<string, Setting>>;

interface ControlBase {
  readonly id: string;
  /** It changes what is drawn and nothing that is computed. */
  readonly view?: true;
}

export interface Slider extends ControlBase {
  readonly kind: 'slider';
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly initial: number;
}

export interface Choice extends ControlBase {
  readonly kind: 'choice';
  /** Their names are words of the figure, `choices.<control>.<choice>`. */
  readonly choices: readonly string[];
  readonly initial: string;
}

/** A point of the drawing that is dragged, or moved with the arrow keys, in the coordinates of its plane (see svg.ts). */
export interface Handle extends ControlBase {
  readonly kind: 'handle';
  readonly initial: Point;
  /** Of an arrow key. */
  readonly step: number;
  readonly min: Point;
  readonly max: Point;
}

/** From where a surface is seen: azimuth and elevation in degrees, turned by dragging the drawing or with the arrow keys. */
export interface Turn extends ControlBase {
  readonly kind: 'turn';
  readonly view: true;
  readonly initial: Point;
}

export type Control = Slider | Choice | Handle | Turn;

/** A number that the page shows under the drawing. */
export interface Reading {
  /** Its label is the word `readings.<id>` of the figure. */
  readonly id: string;
  readonly value: number;
  /** As it is to be shown, where the usual six digits will not do. */
  readonly text?: string;
  /** It is a fault: drawn in vermilion, and marked. */
  readonly bad?: boolean;
}

/** The figure's words in the language of the page, by their path in en.json and de.json; `{name}` in them takes a value. */
export type Say = (path: string, values?: Readonly<Record<string, string | number>>) => string;

interface FigureBase {
  /** Its folder, and its address: never change it. */
  readonly id: string;
  /** The article shows the figures in this order. */
  readonly number: number;
  /** One or two, and handles. */
  readonly controls: readonly Control[];
  /** The state of the full page that shows the same. */
  readonly state: (settings: Settings) => State;
  /** The mesh as OBJ, where the source of that state is a file: the link carries it (see share.ts). */
  readonly file?: (settings: Settings) => string;
}

/** Drawn as SVG. */
export interface Drawn<Data> extends FigureBase {
  readonly kind: 'drawn';
  /** @throws PolylapError, which is told; what was drawn before stays */
  readonly compute: (client: Client, settings: Settings) => Promise<Data>;
  /** A whole `<svg>` element, see svg.ts. Colours are the classes of figure.css, never literal. */
  readonly draw: (data: Data, settings: Settings, say: Say) => string;
  readonly read: (data: Data, settings: Settings) => readonly Reading[];
}

/** The page itself with two operators on a surface; until it is started, a picture of the mesh stands there with its numbers. */
export interface Compared extends FigureBase {
  readonly kind: 'compared';
  /** What is shown of the two sides in `state`, computed without a page. */
  readonly compute: (client: Client, settings: Settings) => Promise<readonly Reading[]>;
}

// biome-ignore lint/suspicious/noExplicitAny: what one figure computes only it can read.
export type Figure = Drawn<any> | Compared;

/** Lets the compiler find Data. */
export const drawn = <Data>(figure: Omit<Drawn<Data>, 'kind'>): Drawn<Data> => ({ kind: 'drawn', ...figure });

export const compared = (figure: Omit<Compared, 'kind'>): Compared => ({ kind: 'compared', ...figure });

export const initialSettings = ({ controls }: Pick<FigureBase, 'controls'>): Settings =>
  Object.fromEntries(controls.map(({ id, initial }) => [id, initial]));
