// Runs the kernels where the page runs the core: in a worker.
import createModule from './kernels.js';

const module = createModule();
onmessage = async ({ data: { nu, nv, repeats, peer } }) => {
  const kernels = await module;
  const measure = kernels.cwrap('measure_torus', 'string', ['number', 'number', 'number', 'number']);
  const rows = JSON.parse(measure(nu, nv, repeats, Number(peer)));
  postMessage({ rows, heap: kernels.HEAPU8.length / 1e6 });
};
