import type { App } from './app.js';
import type { State } from './state.js';
import { t, word } from './words.js';

/** At least so many changes can be undone. */
const depth = 200;
/** Changes of one thing within this time, in ms, are one: a slider's. */
const breath = 700;

/** The parts of the state that decide what is computed, and what they are called; `t` is due where that is shown. */
const parts: readonly (readonly [string, (state: State) => unknown])[] = [
  [word('the mesh'), ({ source }) => source],
  [word('the operator of A'), ({ sides }) => sides.a.operator],
  [word('the operator of B'), ({ sides }) => sides.b.operator],
  [word('the parameters of A'), ({ sides }) => sides.a.parameters],
  [word('the parameters of B'), ({ sides }) => sides.b.parameters],
  [word('the vertex weights of A'), ({ vertexWeights }) => vertexWeights.a],
  [word('the vertex weights of B'), ({ vertexWeights }) => vertexWeights.b],
  [word('the smoothing'), ({ moves }) => moves],
  [word('the step shown'), ({ step }) => step],
  [word('the flow of A'), ({ smooth }) => smooth.flow.a],
  [word('the flow of B'), ({ smooth }) => smooth.flow.b],
  [word('how steps are taken'), ({ smooth }) => smooth],
  [word('the pins'), ({ harmonic }) => harmonic.pins],
  [word('the compromise μ'), ({ dual }) => dual.mu],
];
const stepwise = ['the mesh', 'the smoothing'];

const same = (one: unknown, other: unknown) => one === other || JSON.stringify(one) === JSON.stringify(other);
const changes = (one: State, other: State) => parts.filter(([, pick]) => !same(pick(one), pick(other)));

interface Entry {
  /** As it was before. */
  state: State;
  /** What was changed then, in English. */
  what: string;
  /** Whether it was all that is on screen, task and view included. */
  whole?: boolean;
}

/** Undo and redo, over everything that decides what is computed. */
export class History {
  private done: Entry[] = [];
  private undone: Entry[] = [];
  private now: State;
  private last = { what: '', at: 0 };
  private travelling = 0;
  /** While something is dragged: how many changes there were before. */
  private held: number | null = null;

  constructor(private readonly app: App) {
    this.now = app.state.get();
    app.state.watch(
      (state) => [state],
      (state) => this.note(state),
    );
  }

  /** What the next undo would take back, in English, or null. */
  get undoes(): string | null {
    return this.done.at(-1)?.what ?? null;
  }

  get redoes(): string | null {
    return this.undone.at(-1)?.what ?? null;
  }

  undo(): Promise<void> {
    return this.travel(this.done, this.undone, word('Undone: {what}.'));
  }

  redo(): Promise<void> {
    return this.travel(this.undone, this.done, word('Done again: {what}.'));
  }

  /** From here on: what a page opens with cannot be undone. */
  begin(): void {
    this.done = [];
    this.undone = [];
    this.tell();
  }

  /** Whatever `work` changes is one change. */
  async asOne(what: string, work: () => Promise<unknown>): Promise<void> {
    const { app } = this;
    const before = app.state.get();
    this.travelling++;
    try {
      await work();
    } finally {
      this.travelling--;
      this.now = app.state.get();
      if (changes(before, this.now).length > 0) this.add({ state: before, what, whole: true });
    }
  }

  private add(entry: Entry): void {
    this.done.push(entry);
    if (this.done.length > depth) this.done.shift();
    this.undone = [];
    this.last = { what: entry.what, at: performance.now() };
    this.tell();
  }

  /** From now on all changes are one, until they are let go. */
  hold(): void {
    this.last = { what: '', at: 0 };
    this.held = this.done.length;
  }

  /** What came to nothing leaves no trace. */
  release(): void {
    const began = this.held !== null ? this.done[this.held] : undefined;
    this.held = null;
    this.last = { what: '', at: 0 };
    if (!began || changes(began.state, this.now).length > 0) return;
    this.done.pop();
    this.tell();
  }

  private note(state: State): void {
    const before = this.now;
    this.now = state;
    if (this.travelling > 0 || before === state) return;
    const [first] = changes(before, state);
    if (!first) return;
    const [what] = first;
    const at = performance.now();
    const goesOn =
      what === this.last.what &&
      (this.held !== null || (at - this.last.at < breath && this.flows(what, before, state)));
    if (goesOn && this.done.length > 0) this.last = { what, at };
    else this.add({ state: before, what });
  }

  /** Whether a quick second change goes on with the first one: a value being dragged does, another pin or mesh does not. */
  private flows(what: string, before: State, state: State): boolean {
    if (what === 'the smoothing') return this.app.results.get().playing;
    if (what !== 'the pins') return !stepwise.includes(what);
    const where = ({ harmonic }: State) => harmonic.pins.map(({ vertex }) => vertex).join();
    return where(before) === where(state);
  }

  private async travel(from: Entry[], to: Entry[], notice: string): Promise<void> {
    const { app } = this;
    const entry = from.pop();
    if (!entry) return;
    const here = app.state.get();
    to.push({ ...entry, state: here });
    this.travelling++;
    this.last = { what: '', at: 0 };
    this.tell();
    try {
      const there = entry.whole ? { ...entry.state, theme: here.theme } : { ...here, ...decisive(entry.state) };
      if (await app.goTo(there)) app.say(t(notice, { what: t(entry.what) }));
      else {
        to.pop();
        from.push(entry);
      }
    } finally {
      this.travelling--;
      this.now = app.state.get();
      this.tell();
    }
  }

  private tell(): void {
    this.app.results.set({ undoes: this.undoes, redoes: this.redoes });
  }
}

/** The parts that history is about; the task, the theme and what is drawn stay as they are. */
const decisive = ({ source, sides, vertexWeights, moves, step, smooth, harmonic, dual }: State) => ({
  source,
  sides,
  vertexWeights,
  moves,
  step,
  smooth,
  harmonic,
  dual,
});
