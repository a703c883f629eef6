// Runs the kernels where the page runs the core: in a worker.
import createModule from '/build/wasm/tests/bench/browser/kernels.js';

const module = createModule();
addEventListener('message', async ({ data: { nu, nv, repeats, peer } }) => {
  const kernels = await module;
  const measure = kernels.cwrap('measure_torus', 'string', ['number', 'number', 'number', 'number']);
  postMessage(JSON.parse(measure(nu, nv, repeats, Number(peer))));
});
