import { type ColourMap, colourMap } from '../colour-maps.js';
import { h } from '../dom.js';

/** A strip of the colours of a map, least to most; `single` paints the middle one only. */
export function ramp(): { element: HTMLCanvasElement; paint: (map: ColourMap, single?: boolean) => void } {
  const element = h('canvas', { width: 256, height: 1, class: 'ramp', 'aria-hidden': 'true' });
  const paint = (map: ColourMap, single = false) => {
    const colours = colourMap(map);
    const middle = colours.subarray(4 * 128, 4 * 129);
    const shown = single ? Uint8ClampedArray.from(colours, (_, k) => middle[k % 4] as number) : colours;
    element.getContext('2d')?.putImageData(new ImageData(new Uint8ClampedArray(shown), 256, 1), 0, 0);
  };
  return { element, paint };
}
