// The rules of the house that a compiler does not hold. Each takes files as {path: text} and returns what breaks it, one line each.
const entries = (files, pattern) => Object.entries(files).filter(([path]) => pattern.test(path));
const lines = (text) => text.split('\n').map((line, index) => [line, index + 1]);

/** The text without its comments, line for line. Good enough for code that has no comment signs inside strings but URLs. */
export const withoutComments = (text) =>
  text
    .replace(/\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ''))
    .replace(/(^|[^:])\/\/.*$/gm, '$1')
    .replace(/<!--[\s\S]*?-->/g, (comment) => comment.replace(/[^\n]/g, ''));

const layers = {
  base: [],
  mesh: ['base'],
  face: ['base', 'mesh'],
  solve: ['base'],
  operators: ['base', 'mesh', 'face', 'solve'],
  apply: ['base', 'mesh', 'face', 'solve', 'operators'],
  session: ['base', 'mesh', 'face', 'solve', 'operators', 'apply'],
};
/** A file in a folder of the core belongs to that layer; one beside the folders to the session. */
const layerOf = (path) => (path.includes('/') ? path.slice(0, path.indexOf('/')) : 'session');

/** base ← mesh ← face ← operators ← apply ← session ← wasm and tools, base ← solve ← {operators, apply}. */
export function includeDirection(files) {
  const broken = [];
  for (const [path, text] of entries(files, /^(core|wasm)\/.*\.[ch]pp$/)) {
    const inner = path.match(/^core\/(?:include\/polylap|src)\/(.*)$/)?.[1];
    for (const [line, number] of lines(text)) {
      const included = line.match(/^\s*#\s*include\s*["<]([^">]+)[">]/)?.[1];
      if (!included) continue;
      const isPublic = included.startsWith('polylap/');
      const target = isPublic ? included.slice('polylap/'.length) : included;
      const known = isPublic || `core/src/${target}` in files;
      if (!known) continue;
      if (inner === undefined) {
        const own = `${path.slice(0, path.lastIndexOf('/'))}/${target}` in files;
        if (!isPublic && !own) broken.push(`${path}:${number} includes ${included}, which is private to the core`);
        continue;
      }
      const [from, to] = [layerOf(inner), layerOf(target)];
      if (!(from in layers)) broken.push(`${path}:${number} is in the unknown layer ${from}`);
      else if (from !== to && !layers[from].includes(to)) {
        broken.push(`${path}:${number} includes ${included}: ${from} must not know ${to}`);
      }
    }
  }
  return broken;
}

/** Which modules of wasm/src each of them may import: raw ← session ← worker ⇠ protocol ⇢ client. */
const moduleImports = {
  types: ['generated'],
  generated: ['types'],
  error: ['types', 'generated'],
  raw: ['types', 'generated'],
  check: ['types', 'generated', 'error', 'raw'],
  session: ['types', 'generated', 'error', 'check', 'raw'],
  compile: ['error', 'check'],
  load: ['compile', 'raw', 'session'],
  protocol: ['types', 'generated', 'raw'],
  serve: ['types', 'generated', 'error', 'check', 'session', 'protocol'],
  worker: ['load', 'serve'],
  queue: ['types', 'error', 'check', 'protocol'],
  client: ['types', 'generated', 'check', 'protocol', 'queue'],
  create: ['types', 'compile', 'client'],
  index: ['types', 'generated', 'error', 'client', 'create'],
  node: ['types', 'generated', 'error', 'session', 'load', 'serve', 'client'],
};

/** The modules of wasm/src hold to their order, and web/ knows only the library's front door. */
export function moduleDirection(files) {
  const broken = [];
  const importsOf = (text) =>
    lines(withoutComments(text)).flatMap(([line, number]) =>
      [...line.matchAll(/(?:from|import)\s*\(?\s*['"](\.[^'"]+)['"]/g)].map((match) => [match[1], number]),
    );
  for (const [path, text] of entries(files, /^wasm\/src\/[^/]+\.ts$/)) {
    const name = path.match(/([^/]+?)(\.d)?\.ts$/)[1];
    if (path.endsWith('.d.ts')) continue;
    const allowed = moduleImports[name];
    if (!allowed) broken.push(`${path} has no place in the order of modules (tests/repo/rules.mjs)`);
    for (const [target, number] of importsOf(text)) {
      const module = target.match(/^\.\/([^/]+?)\.(js|ts)$/)?.[1];
      const built = ['../../build/wasm/polylap.js', '../../build/wasm/polylap-core.js'];
      const isBuilt = built.includes(target) && name === 'load';
      if (allowed && !isBuilt && !allowed.includes(module)) broken.push(`${path}:${number} imports ${target}`);
    }
  }
  for (const [path, text] of entries(files, /^web\/.*\.(ts|mjs|html)$/)) {
    for (const [target, number] of importsOf(text)) {
      if (!/(^|\/)(wasm|core|build)\//.test(target)) continue;
      // It takes the place of wasm/src/create.ts.
      const asCreate = path === 'web/embed/inlined-client.ts' && target.endsWith('/wasm/src/client.js');
      // What builds the site runs in Node, and has Node's door.
      const door = path.endsWith('.mjs')
        ? /\/wasm\/src\/(index|types|node)\.(js|ts)$/
        : /\/wasm\/src\/(index|types)\.js$/;
      if (!door.test(target) && !asCreate) broken.push(`${path}:${number} imports ${target}, past the front door`);
    }
  }
  return broken;
}

/** Where an operator may be named outside its own files: the table, what is made from it, and the places below. */
const mayNameOperators = [
  { path: 'core/src/operators/registry.cpp' },
  { path: 'core/CMakeLists.txt' },
  { path: 'wasm/src/generated.ts' },
  { path: 'wasm/src/types.ts', line: /^export type Claim = / }, // "planar" is also where a property can hold
  { path: 'web/src/state.ts', line: /^const openingPair\b/ },
  { path: 'web/src/gallery.ts' }, // figures of the thesis
  { folder: 'web/figures/' },
  { folder: 'web/thesis/' },
  { folder: 'web/class/' },
];

/** No operator is known by name outside its own files and the table. @param ids of the operator table */
export function operatorNames(files, ids) {
  const broken = [];
  for (const [path, text] of entries(files, /^(core|wasm|web)\/.*\.([ch]pp|ts|mjs|js|html|css|txt|cmake)$/)) {
    const code = withoutComments(text);
    for (const id of ids) {
      const snake = id.replaceAll('-', '_');
      const camel = id.replace(/(?:^|-)(.)/g, (_, letter) => letter.toUpperCase());
      if (path.startsWith('core/') && new RegExp(`/operators/${snake}\\.[ch]pp$`).test(path)) continue;
      const names = new RegExp(
        `(['"\`])${id}\\1|\\b${snake}_(info|stiffness|mass|operator)\\b|\\b${camel}(Options|Spec|Operator)\\b|operators/${snake}\\.`,
      );
      for (const [line, number] of lines(code)) {
        if (!names.test(line)) continue;
        const may = ({ path: one, folder, line: only }) =>
          (one === path || (folder && path.startsWith(folder))) && (!only || only.test(line));
        if (mayNameOperators.some(may)) continue;
        broken.push(`${path}:${number} knows the operator ${id} by name`);
      }
    }
  }
  return broken;
}

/** Nothing in the repository depends on the machine it was written on. */
export function machinePaths(files) {
  const folder = ['work', 'tmp', 'root', 'home', 'Users', 'mnt', 'farm'].join('|');
  const absolute = new RegExp(`(^|[\\s"'\`(=:,])/(${folder})/[\\w.-]`);
  const registry = /https?:\/\/[^\s"'/]*(registry|npmjs|artifactory|nexus|pypi|mirror)[^\s"'/]*\//i;
  return Object.entries(files).flatMap(([path, text]) =>
    lines(text).flatMap(([line, number]) => [
      ...(absolute.test(line) ? [`${path}:${number} has an absolute path of a machine`] : []),
      ...(registry.test(line) || (path === 'package-lock.json' && /"resolved":/.test(line))
        ? [`${path}:${number} names a registry`]
        : []),
    ]),
  );
}

/** Every C++ source is listed in the CMakeLists.txt that builds it: nothing is left out in silence. */
export function listedSources(files) {
  const lists = [
    { list: 'core/CMakeLists.txt', sources: /^core\/src\/.*\.cpp$/, base: 'core/' },
    { list: 'core/tools/CMakeLists.txt', sources: /^core\/tools\/.*\.cpp$/, base: 'core/tools/' },
    { list: 'tests/CMakeLists.txt', sources: /^tests\/core\/.*\.cpp$/, base: 'tests/' },
    { list: 'tests/bench/CMakeLists.txt', sources: /^tests\/bench\/native\/.*\.cpp$/, base: 'tests/bench/' },
    { list: 'wasm/CMakeLists.txt', sources: /^wasm\/.*\.cpp$/, base: 'wasm/' },
  ];
  return lists.flatMap(({ list, sources, base }) => {
    const listed = new Set((files[list] ?? '').split(/[\s()]+/));
    return entries(files, sources)
      .filter(([path]) => !listed.has(path.slice(base.length)))
      .map(([path]) => `${path} is not listed in ${list}`);
  });
}

const topLevel = [
  ...['core', 'wasm', 'web', 'tests', 'CMakeLists.txt', 'CMakePresets.json', 'package.json', 'package-lock.json'],
  ...['README.md', 'CHANGELOG.md', 'LICENSE', 'CITATION.cff', 'tsconfig.json', 'biome.json'],
];
export function fixedTopLevel(files) {
  const names = new Set(Object.keys(files).map((path) => path.split('/')[0]));
  return [...names]
    .filter((name) => !topLevel.includes(name) && !name.startsWith('.'))
    .map((name) => `${name} is new at the top level`);
}

/** Tests that never run, or that keep others from running. */
export const idleTests = (files) =>
  entries(files, /^tests\/.*\.(cpp|ts|mjs)$/).flatMap(([path, text]) =>
    lines(withoutComments(text))
      .filter(([line]) =>
        /\bGTEST_SKIP\b|\bDISABLED_\w|\b(it|test|describe)\.(skip|only|todo|skipIf|runIf)\b/.test(line),
      )
      .map(([, number]) => `${path}:${number} leaves tests out`),
  );

/** One version everywhere. */
export function versions(files) {
  const found = {
    'package.json': JSON.parse(files['package.json']).version,
    'package-lock.json': JSON.parse(files['package-lock.json']).version,
    'CMakeLists.txt': files['CMakeLists.txt'].match(/VERSION (\d+\.\d+\.\d+)/)?.[1],
    'CITATION.cff': files['CITATION.cff'].match(/^version: (.*)$/m)?.[1],
  };
  const wanted = found['package.json'];
  return Object.entries(found)
    .filter(([, version]) => version !== wanted)
    .map(([path, version]) => `${path} has version ${version}, package.json ${wanted}`);
}
