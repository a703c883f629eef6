import { DataTexture, LinearFilter, RGBAFormat } from 'three';

/** Viridis (Smith & van der Walt, CC0) at every tenth; between them linear. */
const viridisStops = '440154 482576 414487 35608d 2a788e 21908c 22a884 43bf71 7ad151 bbdf27 fde725'.split(' ');

/** 256 colours, four bytes each. */
export function viridis(): Uint8Array<ArrayBuffer> {
  const stops = viridisStops.map((hex) => [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)));
  const colours = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) {
    const at = (i / 255) * (stops.length - 1);
    const low = Math.min(Math.floor(at), stops.length - 2);
    for (let k = 0; k < 3; k++) {
      const from = stops[low]?.[k] ?? 0;
      const to = stops[low + 1]?.[k] ?? 0;
      colours[4 * i + k] = Math.round(from + (to - from) * (at - low));
    }
    colours[4 * i + 3] = 255;
  }
  return colours;
}

export function viridisTexture(): DataTexture {
  const texture = new DataTexture(viridis(), 256, 1, RGBAFormat);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
