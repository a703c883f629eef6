import type { ErrorCode } from './generated.js';

/** An error of the core (`code` from its list), of the worker that hosts it (`worker-failed`), or a bug (`internal`). */
export class PolylapError extends Error {
  override readonly name = 'PolylapError';
  constructor(
    readonly code: ErrorCode | 'worker-failed' | 'internal',
    message: string,
    /** Face, edge or vertex, counted from 0 (the message says which); -1: none. */
    readonly element = -1,
    /** Line of the file, counted from 1; -1: not from a file. */
    readonly line = -1,
  ) {
    super(message);
  }
}

/** The core trapped: its memory is in no known state, and only a new instance will do. */
export class CoreStopped extends PolylapError {
  constructor(why: string) {
    super('internal', `the core stopped: ${why}`);
  }
}
