/** The quad bunnies that figures compare operators on. */
import type { Client, Mesh } from '../src/polylap.js';
import { publicFile } from '../src/public-file.js';
import { presets } from '../src/state.js';

/** Whoever opens a bunny closes it. @param id of a preset that is a file */
export async function openBunny(client: Client, id: 'bunny' | 'noisy-bunny'): Promise<Mesh> {
  const preset = presets.find((entry) => entry.id === id);
  if (!preset || !('file' in preset)) throw new Error(`there is no file ${id}`);
  const mesh = await client.open(await publicFile(preset.file), preset.file);
  if (!preset.change) return mesh;
  const changed = await mesh.convert(preset.change);
  await mesh.close();
  return changed;
}
