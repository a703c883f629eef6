// RESULTS.md and the README's lines about speed, made from tests/bench/results.json.
import { lookUp, metrics, sizeName, targets, verdict } from './targets.mjs';

const row = (cells) => `| ${cells.map((cell) => String(cell).replaceAll('|', '\\|')).join(' | ')} |\n`;
const table = (head, rows) => row(head) + row(head.map(() => '---')) + rows.map(row).join('');

/** Three digits that mean something. */
export function digits(value) {
  if (value === undefined || Number.isNaN(value)) return '';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6) return `${digits(value / 1e6)}M`;
  if (size >= 100) return value.toFixed(0);
  return value.toPrecision(size < 1 ? 2 : 3);
}
const milliseconds = (value) =>
  value === undefined ? '' : value >= 10_000 ? `${digits(value / 1000)} s` : `${digits(value)} ms`;
const times = (value) => (Number.isFinite(value) ? `${digits(value)}×` : '');
const shown = (value, unit) => {
  if (unit === 'ms') return milliseconds(value);
  return unit === '×' ? times(value) : `${digits(value)} ${unit}`.trim();
};

const marks = { met: '✓', missed: '✗', 'not measured': '–' };

/** Why targets were missed, where that is known. */
const misses = (find) =>
  targets
    .filter(({ why, measure }) => why && measure(find).some((line) => verdict(line) === 'missed'))
    .map(({ what, why }) => `\nMissed: ${what}: ${why}\n`)
    .join('');

/** One row per target; each of its numbers with its own mark, so that a row says what is missing. */
function targetTable(find) {
  const rows = targets.map(({ what, target, measure }) => {
    const lines = measure(find).map((line) => ({ ...line, verdict: verdict(line) }));
    const texts = lines.map(({ label, value, unit, verdict }) => {
      const number = verdict === 'not measured' ? verdict : shown(value, unit);
      return `${label} ${number}${verdict === 'missed' ? ' ✗' : ''}`.trim();
    });
    const verdicts = lines.map((line) => line.verdict);
    const overall = ['missed', 'not measured'].find((name) => verdicts.includes(name)) ?? 'met';
    return [what, target, texts.join('; '), `${marks[overall]} ${overall}`];
  });
  return table(['', 'target', 'measured', ''], rows) + misses(find);
}

const groupBy = (rows, key) => {
  const groups = new Map();
  for (const item of rows) groups.set(key(item), [...(groups.get(key(item)) ?? []), item]);
  return groups;
};

/** A line per mesh and contender, a column per metric. */
function pivot(rows) {
  const columns = [...new Set(rows.map(({ metric }) => metric))];
  const lines = [...groupBy(rows, ({ shape, n, item }) => `${shape}\t${n}\t${item}`)].map(([key, cells]) => [
    ...key.split('\t'),
    ...columns.map((metric) => {
      const cell = cells.find((candidate) => candidate.metric === metric);
      return cell ? shown(cell.value, cell.unit) : '';
    }),
  ]);
  return table(['mesh', 'vertices', '', ...columns], lines);
}

/** Every factorisation of one shape, with the time from scratch and what that is of polylap's. */
function factorTable(find, rows) {
  const head = [
    'vertices',
    '',
    'from scratch',
    'over polylap',
    'analyse',
    'numbers',
    'solve 1',
    'solve 3',
    'nnz(L)',
    'Gflop/s',
  ];
  const lines = [...groupBy(rows, ({ n, item }) => `${n}\t${item}`)].map(([key, cells]) => {
    const [n, item] = key.split('\t');
    const { shape } = cells[0];
    const value = (metric) => cells.find((cell) => cell.metric === metric)?.value;
    const whole = metrics.whole(find, shape, Number(n), item);
    const ours = metrics.whole(find, shape, Number(n), 'polylap');
    return [
      n,
      item,
      milliseconds(whole),
      times(whole / ours),
      ...['analyse', 'numeric', 'solve 1', 'solve 3'].map((metric) => milliseconds(value(metric))),
      digits(value('nnz(L)')),
      digits(value('flops') / value('numeric') / 1e6),
      shown(value('peak memory'), 'MB'),
    ];
  });
  return table([...head, 'peak memory'], lines);
}

/** Where a factor wins and where conjugate gradients do, and what was chosen. Items are `t = …, who`. */
function iterativeTable(rows) {
  const lines = [...groupBy(rows, ({ n, item }) => `${n}\t${item.split(', ')[0]}`)].map(([key, cells]) => {
    const value = (who, metric) =>
      cells.find((cell) => cell.item.endsWith(`, ${who}`) && cell.metric === metric)?.value;
    const steps = ['factor', 'conjugate gradients', 'automatic'].flatMap((who) =>
      ['first step', 'next step'].map((metric) => milliseconds(value(who, metric))),
    );
    const chosen = ['first iterations', 'iterations'].map((metric) =>
      value('automatic', metric) > 0 ? 'conjugate gradients' : 'factor',
    );
    return [...key.split('\t'), ...steps, value('conjugate gradients', 'iterations'), chosen.join(', ')];
  });
  const head = ['factor', 'conjugate gradients', 'automatic'].flatMap((who) => [
    `${who}: first step`,
    'next, analysis known',
  ]);
  return table(['vertices', 'time', ...head, 'iterations', 'chosen'], lines);
}

/** The slope of log y over log x, by least squares. */
export function exponent(points) {
  const logs = points.map(([x, y]) => [Math.log(x), Math.log(y)]);
  const mean = (k) => logs.reduce((sum, point) => sum + point[k], 0) / logs.length;
  const [mx, my] = [mean(0), mean(1)];
  const above = logs.reduce((sum, [x, y]) => sum + (x - mx) * (y - my), 0);
  return above / logs.reduce((sum, [x]) => sum + (x - mx) ** 2, 0);
}

/** How time, fill and memory grow with the vertices. */
function scalingTable(rows) {
  const quantities = {
    'from scratch': ['analyse', 'numeric'],
    'solve 3': ['solve 3'],
    'nnz(L)': ['nnz(L)'],
    'peak memory': ['peak memory'],
  };
  const lines = [];
  for (const [key, cells] of groupBy(rows, ({ shape, item }) => `${shape}\t${item}`)) {
    const sizes = [...new Set(cells.map(({ n }) => n))].sort((a, b) => a - b);
    const points = (names) =>
      sizes.map((n) => [
        n,
        cells.filter((cell) => cell.n === n && names.includes(cell.metric)).reduce((sum, { value }) => sum + value, 0),
      ]);
    const times = points(quantities['from scratch']).map(([n, value]) => `${n}: ${milliseconds(value)}`);
    const exponents = Object.values(quantities).map((names) => {
      const known = points(names).filter(([, value]) => value > 0);
      return known.length > 2 ? exponent(known).toFixed(2) : '';
    });
    lines.push([...key.split('\t'), times.join(', '), ...exponents]);
  }
  return table(['mesh', '', 'from scratch', ...Object.keys(quantities).map((name) => `exponent, ${name}`)], lines);
}

const provenance = ({ date, commit, minutes }) =>
  `${date.slice(0, 10)}, commit ${commit}${minutes === undefined ? '' : `, ${digits(minutes)} minutes`}`;

const machineLines = ({ native, browser }) => {
  const { processor, cores, memory, compiler, flags, kernels, libraries } = native.machine;
  return [
    `- Native: ${provenance(native)}; ${compiler}, \`${flags}\`, kernels: ${kernels}; ${libraries.join('; ')}`,
    ...(browser ? [`- Browser: ${provenance(browser)}${browser.machine ? `; ${browser.machine.browser}` : ''}`] : []),
    `- Machine: ${processor}, ${cores} cores, ${memory} GB; everything on one thread`,
  ].join('\n');
};

const titles = {
  assembly: 'Assembly: stiffness and lumped mass',
  loading: 'Loading',
  smoothing: 'Smoothing step from scratch: assemble, analyse, factor, solve for three coordinates',
  iterative: 'Smoothing step: factor or conjugate gradients',
  harmonic: 'Harmonic interpolation from scratch: assemble, factor, solve',
  pins: 'Pins',
  eigenpairs: 'Eigenpairs',
};

/** Groups that have a table of their own. */
const tables = { iterative: iterativeTable };

/** RESULTS.md. @param results what tests/bench/results.json holds */
export function resultsMarkdown(results) {
  const find = lookUp(results);
  const { rows } = results.native;
  const factor = rows.filter(({ group }) => group === 'factor');
  const details = Object.entries(titles)
    .map(([group, title]) => [title, rows.filter((item) => item.group === group)])
    .filter(([, cells]) => cells.length > 0)
    .map(([title, cells]) => `## ${title}\n\n${(tables[cells[0].group] ?? pivot)(cells)}`);
  const factors = [...groupBy(factor, ({ shape }) => shape)].map(
    ([shape, cells]) => `## Factor: ${shape}\n\n${factorTable(find, cells)}`,
  );
  const browser = results.browser
    ? [
        `## Browser\n\n${table(
          ['', 'vertices', ''],
          results.browser.rows.map(({ name, n, unit, value }) => [name, n, shown(value, unit)]),
        )}`,
      ]
    : [];
  return `# Benchmarks

<!-- Made by npm run bench from results.json beside it. -->

${machineLines(results)}

Times are CPU time, the least of a few rounds; contenders take turns within a round, each in a process of its own, whose growth is its peak memory. All factor \`M + tS\` of the Alexa–Wardetzky operator, \`t\` the
mean squared edge; every solution is checked by its residual before its time counts. The peers are linked into the benchmark alone. OpenBLAS and polylap choose their
kernels by the processor; everything else, and polylap with its baseline kernels, is compiled with the flags above.

## Targets

${targetTable(find)}
${[...details, ...factors].join('\n')}
## Growth with the number of vertices

The exponents are least squares of the logarithms over all sizes.

${scalingTable(factor)}
${browser.join('\n')}`.replace(/\n+$/, '\n');
}

const speedMarks = /(<!-- speed: made by npm run bench -->\n)[\s\S]*?(<!-- end of speed -->)/;

/** The README with its lines about speed as they should be. */
export function withSpeed(readme, results) {
  if (!speedMarks.test(readme)) throw new Error('the README has no marks around the speed');
  const find = lookUp(results);
  const ours = (n) => metrics.whole(find, 'torus', n, 'polylap');
  const over = (n, item) => times(metrics.whole(find, 'torus', n, item) / ours(n));
  const sizes = [100e3, 250e3, 1e6].filter((n) => ours(n) !== undefined);
  const rows = sizes.map((n) => [
    sizeName(n),
    milliseconds(ours(n)),
    over(n, 'Eigen LDLT, AMD'),
    over(n, 'CHOLMOD supernodal, AMD'),
    over(n, 'CHOLMOD supernodal, METIS'),
    milliseconds(find.native('smoothing', 'torus', n, 'polylap', 'total')),
    milliseconds(find.native('harmonic', 'torus', n, 'two pins', 'total')),
  ]);
  const head = ['vertices', 'factor', 'Eigen LDLT, AMD', 'CHOLMOD, AMD', 'CHOLMOD, METIS', 'smoothing', 'harmonic'];
  const { machine, date, commit } = results.native;
  const text = `
${table(head, rows)}
Quad torus, one thread of an ${machine.processor}, from scratch; the peers' times are multiples of polylap's. ${provenance({ date, commit })}.
`;
  return readme.replace(speedMarks, (_, open, close) => `${open}${text}\n${close}`);
}
