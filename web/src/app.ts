import { Answers } from './answers.js';
import { hear } from './client-news.js';
import { compare } from './compare.js';
import { exact } from './format.js';
import { History } from './history.js';
import { Meshes } from './meshes.js';
import { describe, explain, reportOf } from './messages.js';
import { sameMoves } from './moves.js';
import { ownAddress } from './place.js';
import type { Client, Mesh, Side } from './polylap.js';
import { noResults, type Place, type Results, type SideResults } from './results.js';
import { readLink } from './share.js';
import { Smoothing } from './smoothing.js';
import { type Choice, initialState, nameOf, type State, sides, withPin, withWeight } from './state.js';
import { Store } from './store.js';
import { t, told } from './words.js';
import { isCancelled, Work } from './work.js';

/** What the page can do. Holds what was chosen (`state`) and what came of it (`results`); knows nothing of the document. */
export class App {
  readonly state = new Store<State>(initialState());
  readonly results = new Store<Results>(noResults());
  readonly work = new Work((busy) => this.results.set({ busy }));
  readonly answers = new Answers(this);
  readonly meshes = new Meshes(this);
  readonly smoothing = new Smoothing(this);
  readonly history = new History(this);

  private spoken: { notice: string; of: (state: State) => readonly unknown[]; when: readonly unknown[] } | null = null;

  private deaf = () => {};
  private closed = false;

  /** Of the page that opens links; null where there is none to be known. */
  address: () => string | null = ownAddress;
  /** The vertex that faces the eye; the viewer tells. */
  front: () => number = () => 0;

  /** @param client the page is there before the worker is */
  constructor(readonly client: Promise<Client>) {
    compare(this);
    this.state.watch(
      (state) => [state],
      () => this.forgetStale(),
    );
    void client.then(
      (ready) => {
        if (this.closed) return;
        this.deaf = hear(ready, {
          // What was cancelled is told of by whoever asked for it.
          restarted: (reason) =>
            reason === 'cancelled' ||
            this.say(
              t('The worker was started again: {why}. The mesh is as it was.', {
                why: told(reason.replace(/\.$/, '')),
              }),
            ),
          loading: (loading) => {
            this.work.loading = loading;
          },
        });
      },
      // Told by the first mesh that cannot be made.
      () => {},
    );
  }

  // --- sides --------------------------------------------------------------------------------------------------------------

  setChoice(side: Side, choice: Choice): void {
    const { sides: choices, mode } = this.state.get();
    const results = this.results.get();
    // Figures of another operator would stand beside the new one's claims.
    if (choices[side].operator !== choice.operator) {
      this.state.set({ mode: { ...mode, [side]: null } });
      this.results.set({ [side]: { ...results[side], check: null, study: null } });
    } else if (results[side].study) this.results.set({ [side]: { ...results[side], study: null } });
    this.state.set({ sides: { ...choices, [side]: choice } });
    this.answers.update(side);
  }

  setParameter(side: Side, id: string, value: number | string): void {
    const choice = this.state.get().sides[side];
    this.setChoice(side, { ...choice, parameters: { ...choice.parameters, [id]: value } });
  }

  setWeight(side: Side, vertex: number, weight: number): void {
    const { vertexWeights } = this.state.get();
    this.setWeights(side, withWeight(vertexWeights[side], vertex, weight));
  }

  setWeights(side: Side, weights: State['vertexWeights'][Side]): void {
    this.state.set({ vertexWeights: { ...this.state.get().vertexWeights, [side]: weights } });
    this.answers.update(side);
  }

  // --- tasks --------------------------------------------------------------------------------------------------------------

  setTask(task: State['task']): void {
    if (task !== 'smooth') this.smoothing.pause();
    this.state.set({ task });
    this.answers.updateBoth();
  }

  pin(vertex: number, value: number | null): void {
    this.setPins(withPin(this.state.get().harmonic.pins, vertex, value));
  }

  /** Pins to the current value; touching a pin that has it already removes it. */
  touchPin(vertex: number): void {
    const { pins, value } = this.state.get().harmonic;
    const there = pins.find((pin) => pin.vertex === vertex);
    this.pin(vertex, there?.value === value ? null : value);
    this.sayOfPins(
      there?.value === value
        ? t('The pin at vertex {vertex} is removed.', { vertex })
        : t('Pinned vertex {vertex} to {value}.', { vertex, value: exact(value) }),
    );
  }

  /** As long as they are as they are. */
  sayOfPins(notice: string): void {
    this.say(notice, ({ task, harmonic: { pins } }) => [task, pins]);
  }

  setPins(pins: State['harmonic']['pins']): void {
    this.state.set({ harmonic: { ...this.state.get().harmonic, pins } });
    for (const side of sides) this.answers.harmonic(side);
  }

  /** Takes a pin to another vertex. @returns whether that one is free */
  movePin(from: number, to: number): boolean {
    const { pins } = this.state.get().harmonic;
    if (pins.some(({ vertex }) => vertex === to)) return false;
    this.setPins(pins.map((pin) => (pin.vertex === from ? { ...pin, vertex: to } : pin)));
    return true;
  }

  setDual(patch: Partial<State['dual']>): void {
    this.state.set({ dual: { ...this.state.get().dual, ...patch } });
    if ('mu' in patch) this.answers.updateBoth();
  }

  setMode(side: Side, mode: number | null): void {
    this.state.set({ mode: { ...this.state.get().mode, [side]: mode } });
  }

  // --- vertices -----------------------------------------------------------------------------------------------------------

  select(vertex: number | null): void {
    if (this.results.get().place) this.results.set({ place: null });
    if (vertex === this.state.get().selected) return;
    this.state.set({ selected: vertex });
    for (const side of sides) this.answers.row(side);
  }

  selectFace(face: number | null): void {
    if (face === this.state.get().selectedFace) return;
    this.state.set({ selectedFace: face });
    for (const side of sides) this.answers.face(side);
  }

  /** Selects where something is wrong, and has the camera turned to it. */
  show(place: Place): void {
    const [vertex] = place.vertices;
    if (vertex === undefined) return;
    this.select(vertex);
    this.state.set({ shown: place.side });
    this.results.set({ place });
  }

  hover(vertex: number | null, face: number | null = null): void {
    const { hovered, hoveredFace } = this.results.get();
    if (vertex !== hovered || face !== hoveredFace) this.results.set({ hovered: vertex, hoveredFace: face });
  }

  readEdge(edge: number | null): void {
    if (edge !== this.results.get().edge) this.results.set({ edge });
  }

  /** To the next vertex, or the one before. */
  walk(by: number): void {
    const { mesh } = this.results.get();
    if (!mesh) return;
    const { selected } = this.state.get();
    this.select(selected === null ? 0 : (selected + by + mesh.vertices) % mesh.vertices);
  }

  walkFaces(by: number): void {
    const { mesh } = this.results.get();
    if (!mesh) return;
    const { selectedFace } = this.state.get();
    this.selectFace(selectedFace === null ? 0 : (selectedFace + by + mesh.faces) % mesh.faces);
  }

  // --- whole states -------------------------------------------------------------------------------------------------------

  /** Makes everything as a state says. @returns whether it could be; otherwise the mesh on screen stays */
  async goTo(state: State): Promise<boolean> {
    const now = this.state.get();
    this.smoothing.pause();
    const elsewhere = JSON.stringify(state.source) !== JSON.stringify(now.source) || !this.results.get().mesh;
    if (elsewhere && (await this.meshes.again(state))) return false;
    // The surfaces move when they are there.
    const { moves: _, step: __, sides: choices, selected, selectedFace, ...rest } = state;
    const { vertices = 0, faces = 0 } = this.results.get().mesh ?? {};
    // A link's file may be another one of that name.
    const there = (number: number | null, count: number) => (number !== null && number < count ? number : null);
    this.state.set({ ...rest, selected: there(selected, vertices), selectedFace: there(selectedFace, faces) });
    for (const side of sides)
      if (JSON.stringify(choices[side]) !== JSON.stringify(this.state.get().sides[side]))
        this.setChoice(side, choices[side]);
    // Another operator has put away what was shown of the one before.
    this.state.set({ mode: state.mode });
    const { moves, step } = this.state.get();
    if (step !== state.step || !sameMoves(moves, state.moves)) await this.smoothing.goTo(state.moves, state.step);
    this.answers.updateBoth();
    return true;
  }

  /** What a link says, if the hash of the address is one. @returns whether it was */
  async follow(hash: string): Promise<boolean> {
    let link: Awaited<ReturnType<typeof readLink>>;
    try {
      link = await readLink(hash);
    } catch (reason) {
      this.results.set({ error: { title: t('The link cannot be opened'), text: explain(reason) } });
      return false;
    }
    if (!link) return false;
    const { state, file } = link;
    if (state.source.kind === 'file') {
      if (!file) {
        this.meshes.expect(state);
        return false;
      }
      state.source = { ...state.source, file: this.meshes.keep(file) };
    }
    return this.goTo(state);
  }

  // --- the rest -----------------------------------------------------------------------------------------------------------

  cancel(): void {
    this.results.set({ playing: false });
    this.work.cancel();
  }

  /** Takes from the client what it holds for this page. */
  close(): void {
    this.closed = true;
    this.deaf();
    this.results.set({ playing: false });
    this.meshes.close();
    this.work.makeWay();
  }

  /** Says in the language that is spoken now what was said in another one; what only told of something past goes. */
  translate(): void {
    const { mesh, report, ...results } = this.results.get();
    for (const side of sides) {
      const unsaid = Object.entries(results[side]).flatMap(([kind, why]) =>
        typeof why === 'string' ? [[kind, null]] : [],
      );
      this.results.set({ [side]: { ...results[side], ...Object.fromEntries(unsaid) } });
    }
    const label = nameOf(this.state.get().source);
    this.results.set({
      notice: mesh ? describe(mesh, label) : '',
      report: mesh && report && reportOf(mesh, label),
      error: null,
    });
    this.answers.updateBoth();
  }

  /** Whether nothing is under way. */
  get idle(): boolean {
    return this.work.idle && !this.results.get().playing;
  }

  /** @param of what it speaks of: when any of that changes, it goes */
  say(notice: string, of?: (state: State) => readonly unknown[]): void {
    this.spoken = of ? { notice, of, when: of(this.state.get()) } : null;
    this.results.set({ notice });
  }

  /** Says why something was not taken, until something is. */
  refuse(why: string): void {
    // A step that is played, or a camera that comes to rest, is no answer to it.
    this.say(why, ({ step: _, moves: __, camera: ___, ...chosen }) => Object.values(chosen));
  }

  private forgetStale(): void {
    const { spoken } = this;
    if (!spoken) return;
    const now = spoken.of(this.state.get());
    if (now.every((part, k) => Object.is(part, spoken.when[k]))) return;
    this.spoken = null;
    if (this.results.get().notice === spoken.notice) this.results.set({ notice: '' });
  }

  patch(mesh: Mesh, side: Side, patch: Partial<SideResults>): void {
    const results = this.results.get();
    if (results.mesh === mesh) this.results.set({ [side]: { ...results[side], ...patch } });
  }

  fail(mesh: Mesh, title: string, reason: unknown): void {
    if (this.results.get().mesh !== mesh || isCancelled(reason)) return;
    this.results.set({ error: { title, text: explain(reason) } });
  }
}
