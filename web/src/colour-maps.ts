import { DataTexture, LinearFilter, RGBAFormat } from 'three';
import { word } from './words.js';

/** Colours at equal distances; between them linear. */
const stops = {
  /** Viridis (Smith & van der Walt, CC0) at every tenth. */
  viridis: '440154 482576 414487 35608d 2a788e 21908c 22a884 43bf71 7ad151 bbdf27 fde725',
  /** Cividis (Nuñez, Anderton & Renslow 2018) at every tenth: made for colour-blind eyes. */
  cividis: '00224e 083370 35456c 4f576c 666970 7d7c78 948e77 aea371 c8b866 e5cf52 fee838',
  /** Negative red, zero pale, positive blue; equally light at equal distances from zero. */
  'red-blue': '7d1d12 b03a26 d4694e eb9f86 f5d0c1 f5f3ee c6d9ec 93b8dd 5b93c8 2f6aa9 173f73',
};
export type ColourMap = keyof typeof stops;

/** Those that one can choose, with their names. */
export const colourMaps: readonly (readonly [ColourMap, string])[] = [
  ['viridis', word('Viridis')],
  ['cividis', word('Cividis')],
  ['red-blue', word('Red – blue')],
];

/** 256 colours, four bytes each. */
export function colourMap(name: ColourMap): Uint8Array<ArrayBuffer> {
  const given = stops[name].split(' ').map((hex) => [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)));
  const colours = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) {
    const at = (i / 255) * (given.length - 1);
    const low = Math.min(Math.floor(at), given.length - 2);
    for (let k = 0; k < 3; k++) {
      const from = given[low]?.[k] ?? 0;
      const to = given[low + 1]?.[k] ?? 0;
      colours[4 * i + k] = Math.round(from + (to - from) * (at - low));
    }
    colours[4 * i + 3] = 255;
  }
  return colours;
}

export function colourTexture(name: ColourMap): DataTexture {
  const texture = new DataTexture(colourMap(name), 256, 1, RGBAFormat);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
