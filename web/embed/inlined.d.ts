/** What web/embed/inlined.mjs puts into files that carry everything in themselves: deflated, then base64; unpack.ts undoes that. */
declare module 'inlined:core' {
  /** The whole polylap.wasm. */
  const packed: string;
  export default packed;
}
declare module 'inlined:worker' {
  /** The worker as a classic script. */
  const packed: string;
  export default packed;
}
declare module 'inlined:files' {
  /** JSON: the text of each file of build/public by its path there. */
  const packed: string;
  export default packed;
}
