import type { App } from './app.js';
import { count, plural } from './format.js';
import { countFaces } from './mesh-text.js';
import { describe, explain, reportOf } from './messages.js';
import type { Client, ConversionSpec, Mesh, ShapeSpec, Side } from './polylap.js';
import { freshSide, type Message } from './results.js';
import { forAnotherMesh, type Made, nameOf, type Preset, presets, type Source, sides } from './state.js';
import { isCancelled, type Run } from './work.js';

const tooManyFaces = 1_000_000;
const tooManyBytes = 200e6;

/** How meshes come in: the mesh on screen stays until another one is there. */
export class Meshes {
  /** Meshes asked for and not there yet. */
  awaited = 0;
  private opening = 0;
  /** The file that was opened last: it can be opened again, repaired. */
  private file: { contents: Blob; name: string } | null = null;

  constructor(private readonly app: App) {}

  async preset(id: string): Promise<void> {
    const preset = presets.find((entry) => entry.id === id) ?? presets[0];
    if (!preset) return;
    await this.take({ kind: 'preset', id: preset.id }, async () => {
      const client = await this.app.client;
      return 'shape' in preset
        ? client.make(preset.shape)
        : this.app.work.run(`Loading ${preset.label}`, (run) => load(client, preset, run));
    });
  }

  /** @returns what was wrong, or null; the mesh on screen stays if something was */
  make(shape: Made): Promise<Message | null> {
    const spec = { shape: shape.id, ...shape.parameters } as ShapeSpec;
    return this.take({ kind: 'shape', shape }, async () => (await this.app.client).make(spec));
  }

  /** Makes another mesh of a side's surface. @returns as make */
  async convert(change: Made, side: Side): Promise<Message | null> {
    const { mesh } = this.app.results.get();
    if (!mesh) return null;
    const { source } = this.app.state.get();
    const spec = { conversion: change.id, ...change.parameters } as ConversionSpec;
    return this.take({ ...source, changes: [...(source.changes ?? []), change] }, () =>
      this.app.work.run('Making another mesh', (run) => mesh.convert(spec, { side, ...run }), side),
    );
  }

  /** @returns as make */
  async open(contents: Blob, name: string, repair = false): Promise<Message | null> {
    if (contents.size > tooManyBytes) {
      return this.refuse(
        name,
        `It has ${count(contents.size / 1e6)} MB; this page takes up to ${count(tooManyBytes / 1e6)} MB.`,
      );
    }
    const faces = await countFaces(contents, name);
    if (faces > tooManyFaces) {
      return this.refuse(
        name,
        `It has ${plural(faces, 'face')}; this page takes up to ${count(tooManyFaces)}. The command line takes more.`,
      );
    }
    return this.take(
      { kind: 'file', name, ...(repair && { repaired: true }) },
      () =>
        this.app.work.run(`Opening ${name}`, async (run) =>
          (await this.app.client).open(contents, name, { ...run, repair }),
        ),
      { contents, name },
    );
  }

  /** The opened file once more, repaired; null if the mesh on screen is no file, or is repaired already. */
  get repair(): (() => Promise<Message | null>) | null {
    const { source } = this.app.state.get();
    const { file } = this;
    return source.kind === 'file' && !source.repaired && file ? () => this.open(file.contents, file.name, true) : null;
  }

  /** Finds out whether repair would help before it is offered beside the error. */
  private async offerRepair(file: NonNullable<Meshes['file']>, error: Message): Promise<void> {
    const { app } = this;
    try {
      const repaired = await app.work.run(`Trying to repair ${file.name}`, async (run) =>
        (await app.client).open(file.contents, file.name, { ...run, repair: true }),
      );
      void repaired.close();
    } catch {
      return;
    }
    const act = () => this.open(file.contents, file.name, true);
    if (app.results.get().error === error)
      app.results.set({ error: { ...error, offer: { label: 'Repair and open', act } } });
  }

  private refuse(name: string, text: string): Message {
    const error = { title: `${name} is too large`, text };
    this.app.results.set({ error, notice: error.title });
    return error;
  }

  /** @param file what was opened, which might be repaired */
  private async take(
    source: Source,
    make: () => Promise<Mesh>,
    file: Meshes['file'] = this.file,
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
      mesh = await make();
    } catch (reason) {
      this.awaited--;
      app.answers.again();
      if (turn !== this.opening) return null;
      if (isCancelled(reason)) {
        app.say(`Opening ${label} was cancelled; the mesh is as it was.`);
        return null;
      }
      const opened = source.kind === 'file' && !source.changes;
      const title = opened ? `${label} could not be opened` : `${label} could not be made`;
      const error: Message = { title, text: explain(reason) };
      app.results.set({ error, notice: title });
      if (opened && !source.repaired && file) void this.offerRepair(file, error);
      return error;
    }
    this.awaited--;
    if (turn !== this.opening) {
      await mesh.close();
      return null;
    }
    app.smoothing.loadedArea = 0;
    this.file = file;
    const { mesh: before, a, b } = app.results.get();
    app.state.set({ source, ...forAnotherMesh(app.state.get()) });
    const { positions } = mesh.geometry;
    app.results.set({
      mesh,
      // Studies are about the operators alone.
      a: { ...freshSide(positions), study: a.study },
      b: { ...freshSide(positions), study: b.study },
      error: null,
      report: reportOf(mesh, label),
      hovered: null,
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
}

/** A mesh that lies beside the page. */
async function load(client: Client, { file, change }: Extract<Preset, { file: string }>, run: Run): Promise<Mesh> {
  const answer = await fetch(new URL(file, document.baseURI), { signal: run.signal });
  if (!answer.ok) throw new Error(`${file} could not be loaded: the server says ${answer.status}`);
  const mesh = await client.open(await answer.blob(), file, run);
  if (!change) return mesh;
  try {
    return await mesh.convert(change, run);
  } finally {
    void mesh.close();
  }
}
