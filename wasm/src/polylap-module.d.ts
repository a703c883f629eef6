// The build output has no types of its own, and need not exist to check these sources.
declare module '*/build/wasm/polylap-core.js' {
  const createModule: import('./raw.js').CreateModule;
  export default createModule;
}
declare module '*/build/wasm/polylap.js' {
  const createModule: import('./raw.js').CreateModule;
  export default createModule;
}
