/** Up to here lines are as wide as they should be; beyond, hairlines. */
export const wideLimit = 30_000;
/** Beyond this only some of them are drawn. */
export const drawnLimit = 400_000;
