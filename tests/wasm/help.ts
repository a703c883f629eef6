import { expect } from 'vitest';
import { PolylapError } from '../../wasm/src/node.js';

/** What a call throws, which must be one of our own errors. */
export function failure(work: () => unknown): PolylapError {
  try {
    work();
  } catch (error) {
    expect(error).toBeInstanceOf(PolylapError);
    return error as PolylapError;
  }
  throw new Error('nothing was thrown');
}

export const sum = (values: ArrayLike<number>) => Array.from(values).reduce((total, value) => total + value, 0);
