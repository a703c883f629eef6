import { Vector3 } from 'three';
import type { Colours } from './surface.js';

const names = {
  lit: '--mesh-lit',
  shade: '--mesh-shade',
  edge: '--mesh-edge',
  spoke: '--mesh-spoke',
  negative: '--negative',
  ink: '--ink',
  card: '--card',
  accent: '--accent',
};

/** The style sheet's colours as the screen shows them (sRGB, 0 … 1): light, dark and forced colours come from there alone. */
export function readColours(within: HTMLElement): Colours {
  const probe = document.createElement('span');
  probe.style.forcedColorAdjust = 'none';
  probe.hidden = true;
  within.append(probe);
  const read = (property: string) => {
    probe.style.color = `var(${property})`;
    const text = getComputedStyle(probe).color;
    const [r = 0, g = 0, b = 0] = (text.match(/[\d.]+/g) ?? []).map(Number);
    // rgb(…) counts to 255, color(srgb …), which mixed colours come out as, to 1.
    return new Vector3(r, g, b).divideScalar(text.startsWith('rgb') ? 255 : 1);
  };
  const colours = Object.fromEntries(
    Object.entries(names).map(([name, property]) => [name, read(property)]),
  ) as Colours;
  probe.remove();
  return colours;
}
