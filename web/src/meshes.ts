import { specOf } from './answers.js';
import type { App } from './app.js';
import { count } from './format.js';
import { countFaces } from './mesh-text.js';
import { describe, explain, reportOf } from './messages.js';
import { optionsOf, upTo } from './moves.js';
import type { Client, ConversionSpec, Mesh, ShapeSpec, Side } from './polylap.js';
import { publicFile } from './public-file.js';
import { freshSide, type Message } from './results.js';
import {
  belongings,
  forAnotherMesh,
  type Made,
  nameOf,
  type Preset,
  presets,
  type Source,
  type State,
  sides,
} from './state.js';
import { t, word } from './words.js';
import { isCancelled, type Run } from './work.js';

const tooManyFaces = 1_000_000;
const tooManyBytes = 200e6;

/** How meshes come in: the mesh on screen stays until another one is there. */
export class Meshes {
  /** Meshes asked for and not there yet. */
  awaited = 0;
  private opening = 0;
  private readonly files: Blob[] = [];
  private expected: State | null = null;
  private closed = false;

  constructor(private readonly app: App) {}

  preset(id: string): Promise<Message | null> {
    const preset = presets.find((entry) => entry.id === id) ?? (presets[0] as Preset);
    return this.take({ kind: 'preset', id: preset.id });
  }

  /** @returns what was wrong, or null; the mesh on screen stays if something was */
  make(shape: Made): Promise<Message | null> {
    return this.take({ kind: 'shape', shape });
  }

  /** Makes another mesh of a side's surface. @returns as make */
  async convert(made: Made, side: Side): Promise<Message | null> {
    const { mesh } = this.app.results.get();
    if (!mesh) return null;
    const { source, moves, step } = this.app.state.get();
    const change = { ...made, side, moves: upTo(moves, step) };
    return this.take({ ...source, changes: [...(source.changes ?? []), change] }, {}, (run) =>
      mesh.convert(conversionOf(made), { side, ...run }),
    );
  }

  /** @returns as make */
  async open(contents: Blob, name: string): Promise<Message | null> {
    if (contents.size > tooManyBytes) {
      return this.refuse(
        name,
        t('It has {size} MB; this page takes up to {most} MB.', {
          size: count(contents.size / 1e6),
          most: count(tooManyBytes / 1e6),
        }),
      );
    }
    const faces = await countFaces(contents, name);
    if (faces > tooManyFaces) {
      return this.refuse(name, `${tooMany(faces)} ${t('The command line takes more.')}`);
    }
    const source: Source = { kind: 'file', name, file: this.keep(contents) };
    const { expected } = this;
    if (expected?.source.kind !== 'file' || expected.source.name !== name) return this.take(source);
    this.expected = null;
    await this.app.goTo({ ...expected, source: { ...expected.source, file: source.file } });
    return this.app.results.get().error;
  }

  /** A link without its file: what it says is done when a file of that name is opened. */
  expect(state: State): void {
    this.expected = state;
    const { name } = state.source as FileSource;
    this.app.results.set({
      error: {
        title: t('The link needs {name}', { name }),
        text: t(
          'It was too large to be part of the link. Open the file here, and everything else is set as the link says.',
        ),
      },
    });
  }

  /** Keeps what was opened, so that it can be opened again. @returns its number */
  keep(contents: Blob): number {
    return this.files.push(contents) - 1;
  }

  /** Takes no more, and lets go of what it has. */
  close(): void {
    this.closed = true;
    this.opening++;
    void this.app.results.get().mesh?.close();
  }

  /** What was opened under a number. */
  contents(file: number): Blob | undefined {
    return this.files[file];
  }

  /** Makes the mesh of a state again, with all that belongs to it. @returns as make */
  again(state: State): Promise<Message | null> {
    return this.take(state.source, belongings(state));
  }

  /** The opened file once more, repaired; null if the mesh on screen is no file, or is repaired already. */
  get repair(): (() => Promise<Message | null>) | null {
    const { source } = this.app.state.get();
    return source.kind === 'file' && !source.repaired ? () => this.take(repaired(source)) : null;
  }

  /** Finds out whether repair would help before it is offered beside the error. */
  private async offerRepair(source: FileSource, error: Message): Promise<void> {
    const { app } = this;
    try {
      const mesh = await app.work.run(t('Trying to repair {name}', { name: source.name }), (run) =>
        this.origin(repaired(source), run),
      );
      void mesh.close();
    } catch {
      return;
    }
    const act = () => this.take(repaired(source));
    if (app.results.get().error === error)
      app.results.set({ error: { ...error, offer: { label: t('Repair and open'), act } } });
  }

  private refuse(name: string, text: string): Message {
    const error = { title: t('{name} is too large', { name }), text };
    this.app.results.set({ error, notice: error.title });
    return error;
  }

  /**
   * Makes a mesh and shows it.
   * @param belonging the part of the state that belongs to it, where it is not that of a fresh mesh
   */
  private async take(
    source: Source,
    belonging: Partial<State> = {},
    make: (run: Run) => Promise<Mesh> = (run) => this.remake(source, run),
  ): Promise<Message | null> {
    const { app } = this;
    const label = nameOf(source);
    const turn = ++this.opening;
    app.smoothing.pause();
    this.awaited++;
    // The new mesh does not wait for answers about the old one.
    app.work.makeWay();
    let mesh: Mesh;
    try {
      mesh = await app.work.run(
        t(source.kind === 'file' ? word('Opening {name}') : word('Making {name}'), { name: label }),
        make,
      );
      if (mesh.faces > tooManyFaces) {
        void mesh.close();
        throw new Error(tooMany(mesh.faces));
      }
    } catch (reason) {
      this.awaited--;
      app.answers.again();
      if (turn !== this.opening) return null;
      if (isCancelled(reason)) {
        app.say(t('Opening {name} was cancelled; the mesh is as it was.', { name: label }));
        return null;
      }
      const opened = source.kind === 'file' && !source.changes;
      const title = t(opened ? word('{name} could not be opened') : word('{name} could not be made'), { name: label });
      const error: Message = { title, text: explain(reason) };
      app.results.set({ error, notice: title });
      if (opened && !source.repaired) void this.offerRepair(source, error);
      return error;
    }
    this.awaited--;
    if (turn !== this.opening || this.closed) {
      await mesh.close();
      return null;
    }
    app.smoothing.begin();
    const { mesh: before, a, b } = app.results.get();
    app.state.set({ source, ...forAnotherMesh(app.state.get()), ...belonging });
    const { positions } = mesh.geometry;
    app.results.set({
      mesh,
      // Studies are about the operators alone.
      a: { ...freshSide(positions), study: a.study },
      b: { ...freshSide(positions), study: b.study },
      error: null,
      report: reportOf(mesh, label),
      hovered: null,
      hoveredFace: null,
      edge: null,
      place: null,
      notice: describe(mesh, label),
    });
    void before?.close();
    for (const side of sides) {
      void app.answers.measure(mesh, side);
      app.answers.update(side);
    }
    return null;
  }

  /** Makes the mesh of a source from its beginning. */
  private async remake(source: Source, run: Run): Promise<Mesh> {
    let mesh = await this.origin(source, run);
    for (const { side, moves, ...made } of source.changes ?? []) {
      const before = mesh;
      try {
        for (const move of moves) {
          const spec = specOf(move.sides[side], move.vertexWeights[side], mesh.vertices);
          await mesh.smooth(spec, optionsOf(move, side, mesh), { side, ...run });
        }
        mesh = await mesh.convert(conversionOf(made), { side, ...run });
      } finally {
        void before.close();
      }
    }
    return mesh;
  }

  private async origin(source: Source, run: Run): Promise<Mesh> {
    const client = await this.app.client;
    if (source.kind === 'shape')
      return client.make({ shape: source.shape.id, ...source.shape.parameters } as ShapeSpec, run);
    if (source.kind === 'preset') {
      const preset = presets.find(({ id }) => id === source.id) ?? (presets[0] as Preset);
      return 'shape' in preset ? client.make(preset.shape, run) : load(client, preset, run);
    }
    const contents = this.contents(source.file);
    if (!contents) throw new Error(t('The file is not here any more'));
    return client.open(contents, source.name, { ...run, repair: source.repaired ?? false });
  }
}

const tooMany = (faces: number) =>
  t('It has {n} face; this page takes up to {most}.|It has {n} faces; this page takes up to {most}.', {
    n: faces,
    most: count(tooManyFaces),
  });

type FileSource = Extract<Source, { kind: 'file' }>;

const repaired = ({ name, file }: FileSource): Source => ({ kind: 'file', name, file, repaired: true });

const conversionOf = ({ id, parameters }: Made) => ({ conversion: id, ...parameters }) as ConversionSpec;

/** A mesh that lies beside the page. */
async function load(client: Client, { file, change }: Extract<Preset, { file: string }>, run: Run): Promise<Mesh> {
  const mesh = await client.open(await publicFile(file, run.signal), file, run);
  if (!change) return mesh;
  try {
    return await mesh.convert(change, run);
  } finally {
    void mesh.close();
  }
}
