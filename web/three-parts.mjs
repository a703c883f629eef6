/**
 * What the build leaves out of three.js. All materials here are shaders of our own and nothing casts shadows, so the shaders of three's own materials,
 * its lights' shadows, environment maps, morphing and headsets would be carried for nothing: a quarter of the script. Three keeps each in a file of its
 * own, which a stand-in takes the place of; a file that has gone fails the build.
 */
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const sources = join(dirname(createRequire(import.meta.url).resolve('three')), '../src');

/** A class or maker whose methods do nothing. */
const idle = (name, methods, fields = '') =>
  `export function ${name}() { return { ${fields} ${methods.map((method) => `${method}() {},`).join(' ')} }; }`;

const standIns = {
  // Of the pieces that shaders include, three puts this one into each by itself.
  'renderers/shaders/ShaderChunk.js': `
    import colorspace_pars_fragment from './ShaderChunk/colorspace_pars_fragment.glsl.js';
    export const ShaderChunk = { colorspace_pars_fragment };`,
  'renderers/shaders/ShaderLib.js': 'export const ShaderLib = {};',
  'renderers/shaders/UniformsLib.js': 'export const UniformsLib = {};',
  'renderers/shaders/DFGLUTData.js': 'export const getDFGLUT = () => null;',
  'renderers/webgl/WebGLEnvironments.js': idle('WebGLEnvironments', ['get', 'dispose']),
  'renderers/webgl/WebGLMaterials.js': `
    export function WebGLMaterials() {
      return { refreshMaterialUniforms(uniforms, material) { material.uniformsNeedUpdate = false; } };
    }`,
  'renderers/webgl/WebGLMorphtargets.js': idle('WebGLMorphtargets', ['update']),
  'renderers/webgl/WebGLOutput.js': idle('WebGLOutput', []),
  'renderers/webgl/WebGLShadowMap.js': idle('WebGLShadowMap', ['render'], 'enabled: false,'),
  'renderers/webgl/WebGLUniformsGroups.js': idle('WebGLUniformsGroups', ['update', 'bind', 'dispose']),
  'renderers/webxr/WebXRManager.js': idle(
    'WebXRManager',
    ['addEventListener', 'removeEventListener', 'setAnimationLoop', 'getEnvironmentBlendMode', 'dispose'],
    'enabled: false, isPresenting: false,',
  ),
};

export function threeParts() {
  const parts = new Map(Object.entries(standIns).map(([file, code]) => [join(sources, file), code]));
  return {
    name: 'three-parts',
    apply: 'build',
    enforce: 'pre',
    buildStart() {
      for (const file of parts.keys()) if (!existsSync(file)) this.error(`three.js has no ${file} any more`);
    },
    // Built into one file, as it comes, nothing of three could be taken apart.
    resolveId: (source) => (source === 'three' ? join(sources, 'Three.js') : null),
    load: (id) => parts.get(id) ?? null,
  };
}
