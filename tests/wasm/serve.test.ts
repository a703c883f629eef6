/** The worker's side on a port of our own: what it says, and what it hands over. */
import { expect, it, vi } from 'vitest';
import { load } from '../../wasm/src/node.js';
import type { FromWorker, Request, ToWorker } from '../../wasm/src/protocol.js';
import { type Port, serve } from '../../wasm/src/serve.js';
import { Polylap } from '../../wasm/src/session.js';

interface Said {
  message: FromWorker;
  transfer: Transferable[];
}

async function start(loading: () => Promise<Polylap> = load) {
  const said: Said[] = [];
  const port: Port = { onmessage: null, postMessage: (message, transfer) => said.push({ message, transfer }) };
  serve(port, loading);
  const say = (data: ToWorker) => port.onmessage?.({ data } as MessageEvent<ToWorker>);
  say({ kind: 'start', module: undefined, whole: true, warmUp: true });
  await vi.waitUntil(() => said.length > 0);
  let id = 0;
  const ask = async (request: Request): Promise<Said> => {
    const mine = ++id;
    say({ kind: 'request', id: mine, request });
    const isReply = ({ message: m }: Said) => (m.kind === 'done' || m.kind === 'error') && m.id === mine;
    return vi.waitUntil(() => said.find(isReply));
  };
  return { said, ask };
}

function arraysIn(value: unknown): ArrayBufferView[] {
  if (ArrayBuffer.isView(value)) return [value];
  return value && typeof value === 'object' ? Object.values(value).flatMap(arraysIn) : [];
}

const open: Request = { call: 'open', takes: { mesh: 0, source: { spec: { shape: 'torus', nu: 8, nv: 6 } } } };
const side = { mesh: 0, side: 'a' } as const;
const spec = { id: 'alexa-wardetzky' } as const;

it('says ready first, then hands over the memory of every array in a reply, each once', async () => {
  const { said, ask } = await start();
  expect(said[0]?.message).toEqual({ kind: 'ready' });
  const requests: [Request, number][] = [
    [open, 10],
    [{ call: 'weights', takes: { ...side, spec } }, 5],
    [{ call: 'harmonic', takes: { ...side, spec, fixed: { vertices: [0, 9], values: [0, 1] } } }, 2],
    [{ call: 'matrices', takes: { ...side, spec } }, 6],
    [{ call: 'check', takes: { ...side, spec } }, 1],
    [{ call: 'dual', takes: { ...side, options: {} } }, 7],
    [{ call: 'file', takes: { ...side, format: 'ply' } }, 1],
    [{ call: 'convert', takes: { ...side, conversion: { conversion: 'dual' }, made: 1 } }, 10],
    [{ call: 'smooth', takes: { ...side, spec, options: { time: 0.01 }, showSteps: false } }, 2],
  ];
  for (const [request, count] of requests) {
    const { message, transfer } = await ask(request);
    expect(message.kind).toBe('done');
    const arrays = arraysIn(message);
    expect(arrays.length).toBe(count);
    expect(new Set(transfer)).toEqual(new Set(arrays.map(({ buffer }) => buffer)));
    expect(transfer.length).toBe(count);
    for (const { byteLength, buffer } of arrays) expect(byteLength).toBe(buffer.byteLength);
  }
});

it('warms the solver up with every operator when nothing is asked, once', async () => {
  const polylap = await load();
  const make = vi.spyOn(polylap, 'make');
  const { ask } = await start(async () => polylap);
  await ask(open);
  const operators = polylap.operators().length;
  await vi.waitUntil(() => make.mock.calls.length === 1 + operators, { timeout: 10_000 });
  await ask({ call: 'shape', takes: side });
  await new Promise((resolve) => setTimeout(resolve, 200));
  expect(make).toHaveBeenCalledTimes(1 + operators);
});

it('says that it failed when the core cannot be loaded', async () => {
  const { said } = await start(() => Promise.reject(new Error('no such file')));
  expect(said.map(({ message }) => message)).toEqual([{ kind: 'failed', message: 'no such file' }]);
});

it('says that it failed when the core traps, and restores nothing in it', async () => {
  const trap = () => {
    throw new WebAssembly.RuntimeError('unreachable');
  };
  const { said, ask } = await start(
    async () => new Polylap({ operatorIds: () => ({ ok: [] }), make: trap, Side: {} } as never),
  );
  void ask(open).catch(() => {});
  await vi.waitUntil(() => said.length > 1);
  expect(said[1]?.message).toEqual({ kind: 'failed', message: 'the core stopped: unreachable' });
});

it('answers a failure that is no trap, even one of another kind, and goes on', async () => {
  const polylap = await load();
  const { said, ask } = await start(async () => polylap);
  await ask(open);
  const make = vi.spyOn(polylap, 'make').mockImplementation(() => {
    throw new TypeError('a slip');
  });
  const { message } = await ask(open);
  expect(message).toMatchObject({ kind: 'error', error: { code: 'internal', message: 'a slip' } });
  make.mockRestore();
  expect((await ask({ call: 'shape', takes: side })).message.kind).toBe('done');
  expect(said.some(({ message }) => message.kind === 'failed')).toBe(false);
});
