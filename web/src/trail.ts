import type { Shape, Side, Smoothed } from './polylap.js';
import { sides } from './state.js';

/** Both surfaces after a step. */
export type Surfaces = Readonly<Record<Side, Smoothed>>;

/** What plots need of a step; kept of all of them. */
export type Marks = Readonly<Record<Side, Shape>>;

/** The surfaces that were on the way: to go back to any of them takes no computing. */
export class Trail {
  private readonly kept = new Map<number, Surfaces>();
  private readonly stats = new Map<number, Marks>();
  private readonly energies = new Map<number, Partial<Record<Side, number>>>();
  private bytes = 0;

  /** @param most bytes; beyond, every other surface is forgotten, the last one never */
  constructor(private readonly most: number) {}

  /** Forgets all that comes after a step. */
  cut(step: number): void {
    for (const later of [...this.kept.keys()]) if (later > step) this.forget(later);
    for (const known of [this.stats, this.energies])
      for (const later of [...known.keys()]) if (later > step) known.delete(later);
  }

  clear(): void {
    this.cut(-1);
  }

  add(step: number, surfaces: Surfaces): void {
    this.forget(step);
    this.kept.set(step, surfaces);
    this.stats.set(step, { a: surfaces.a.stats, b: surfaces.b.stats });
    this.bytes += sizeOf(surfaces);
    for (let every = 2; this.bytes > this.most && this.kept.size > 1; every *= 2)
      for (const other of [...this.kept.keys()]) if (other % every !== 0 && other !== step) this.forget(other);
  }

  at(step: number): Surfaces | undefined {
    return this.kept.get(step);
  }

  /** What comes after a step is measured, and told of later. */
  noteEnergy(step: number, side: Side, energy: number): void {
    this.energies.set(step, { ...this.energies.get(step), [side]: energy });
  }

  energy(step: number, side: Side): number | null {
    return this.energies.get(step)?.[side] ?? null;
  }

  marks(step: number): Marks | undefined {
    return this.stats.get(step);
  }

  /** The last step up to a given one whose surfaces are there; 0, the loaded mesh, always is. */
  lastUpTo(step: number): number {
    return Math.max(0, ...[...this.kept.keys()].filter((kept) => kept <= step));
  }

  private forget(step: number): void {
    const surfaces = this.kept.get(step);
    if (!surfaces) return;
    this.bytes -= sizeOf(surfaces);
    this.kept.delete(step);
  }
}

const sizeOf = (surfaces: Surfaces) =>
  sides.reduce((sum, side) => sum + surfaces[side].positions.byteLength + surfaces[side].coordinates.byteLength, 0);
