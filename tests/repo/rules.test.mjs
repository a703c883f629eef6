import { describe, expect, it } from 'vitest';
import { operatorTable, repositoryFiles } from './files.mjs';
import * as rules from './rules.mjs';

const files = repositoryFiles();
const ids = operatorTable().map(({ id }) => id);

describe('the repository', () => {
  it('is there', () => {
    expect(Object.keys(files).length).toBeGreaterThan(80);
    expect(ids.length).toBeGreaterThan(1);
  });
  it('includes in one direction', () => expect(rules.includeDirection(files)).toEqual([]));
  it('imports in one direction', () => expect(rules.moduleDirection(files)).toEqual([]));
  it('knows no operator by name', () => expect(rules.operatorNames(files, ids)).toEqual([]));
  it('knows no machine', () => expect(rules.machinePaths(files)).toEqual([]));
  it('lists every source', () => expect(rules.listedSources(files)).toEqual([]));
  it('has the top level that it should have', () => expect(rules.fixedTopLevel(files)).toEqual([]));
  it('leaves no test out', () => expect(rules.idleTests(files)).toEqual([]));
  it('has one version', () => expect(rules.versions(files)).toEqual([]));
});

describe('each rule can be broken', () => {
  it('includeDirection', () => {
    const header = { 'core/include/polylap/mesh/a.hpp': '', 'core/src/face/secret.hpp': '', 'core/tools/own.hpp': '' };
    const broken = (path, target) => rules.includeDirection({ ...header, [path]: `#include "${target}"\n` });
    expect(broken('core/src/base/b.cpp', 'polylap/mesh/a.hpp')).toHaveLength(1);
    expect(broken('core/src/solve/b.cpp', 'polylap/mesh/a.hpp')).toHaveLength(1);
    expect(broken('core/src/apply/b.cpp', 'polylap/session.hpp')).toHaveLength(1);
    expect(broken('core/src/mesh/b.cpp', 'face/secret.hpp')).toHaveLength(1);
    expect(broken('core/src/odd/b.cpp', 'polylap/mesh/a.hpp')).toHaveLength(1);
    expect(broken('wasm/bindings/session.cpp', 'face/secret.hpp')).toHaveLength(1);
    expect(broken('core/src/operators/b.cpp', 'face/secret.hpp')).toEqual([]);
    expect(broken('core/src/session.cpp', 'polylap/mesh/a.hpp')).toEqual([]);
    expect(broken('core/tools/b.cpp', 'own.hpp')).toEqual([]);
  });
  it('moduleDirection', () => {
    const broken = (path, target) => rules.moduleDirection({ [path]: `import { x } from '${target}';\n` });
    expect(broken('wasm/src/raw.ts', './session.js')).toHaveLength(1);
    expect(broken('wasm/src/client.ts', './session.js')).toHaveLength(1);
    expect(broken('wasm/src/protocol.ts', './client.js')).toHaveLength(1);
    expect(broken('wasm/src/session.ts', '../../build/wasm/polylap.js')).toHaveLength(1);
    expect(broken('wasm/src/stray.ts', './types.js')).toHaveLength(1);
    expect(broken('web/src/app.ts', '../../wasm/src/session.js')).toHaveLength(1);
    expect(broken('web/src/app.ts', '../../wasm/src/index.js')).toEqual([]);
    expect(broken('wasm/src/worker.ts', './serve.js')).toEqual([]);
  });
  it('operatorNames', () => {
    const broken = (path, text) => rules.operatorNames({ [path]: text }, ['new-one', 'planar']);
    expect(broken('core/src/session.cpp', 'if (id == "new-one") return;')).toHaveLength(1);
    expect(broken('core/src/apply/a.cpp', '#include "polylap/operators/new_one.hpp"')).toHaveLength(1);
    expect(broken('web/src/app.ts', "case 'planar':")).toHaveLength(1);
    expect(broken('web/src/state.ts', "const other = { a: 'planar' };")).toHaveLength(1);
    expect(broken('web/src/state.ts', "const openingPair = { a: 'planar' };")).toEqual([]);
    expect(broken('core/src/operators/planar.cpp', 'const char* id = "planar";')).toEqual([]);
    expect(broken('core/src/session.cpp', '// "planar" is only spoken of')).toEqual([]);
  });
  it('machinePaths', () => {
    expect(rules.machinePaths({ 'a.md': ['see ', 'home', 'ann', 'x'].join('/') })).toHaveLength(1);
    expect(rules.machinePaths({ '.npmrc': ['registry=https:/', 'registry.example.org', ''].join('/') })).toHaveLength(
      1,
    );
    expect(rules.machinePaths({ 'package-lock.json': '  "resolved": "x"' })).toHaveLength(1);
    expect(rules.machinePaths({ 'a.md': 'build/native/bin and https://example.org/home/x' })).toEqual([]);
  });
  it('listedSources', () => {
    const list = { 'tests/CMakeLists.txt': 'add_executable(polylap_tests core/a_test.cpp)' };
    expect(rules.listedSources({ ...list, 'tests/core/a_test.cpp': '' })).toEqual([]);
    expect(rules.listedSources({ ...list, 'tests/core/b_test.cpp': '' })).toHaveLength(1);
  });
  it('fixedTopLevel', () => {
    expect(rules.fixedTopLevel({ 'scripts/a.sh': '' })).toHaveLength(1);
    expect(rules.fixedTopLevel({ 'core/a.cpp': '', '.ci/run': '' })).toEqual([]);
  });
  it('idleTests', () => {
    const word = 'skip';
    expect(rules.idleTests({ 'tests/web/a.test.ts': `it.${word}('x', f);` })).toHaveLength(1);
    expect(rules.idleTests({ 'tests/core/a_test.cpp': `TEST(A, DIS${'ABLED'}_b) {}` })).toHaveLength(1);
    expect(rules.idleTests({ 'tests/web/a.test.ts': "it('x', f);" })).toEqual([]);
  });
  it('versions', () => {
    const same = {
      'package.json': '{"version":"1.2.3"}',
      'package-lock.json': '{"version":"1.2.3"}',
      'CITATION.cff': 'version: 1.2.3',
    };
    expect(rules.versions({ ...same, 'CMakeLists.txt': 'project(p VERSION 1.2.3)' })).toEqual([]);
    expect(rules.versions({ ...same, 'CMakeLists.txt': 'project(p VERSION 1.2.4)' })).toHaveLength(1);
  });
});
