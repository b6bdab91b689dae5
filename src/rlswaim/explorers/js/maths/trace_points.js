// A point of a trace: all roots at one value of the parameter that runs.

/** @typedef {Float64Array | number[]} Numbers */
/**
 * gap: for each root the square of the distance to the next one, infinite where two coincide; apart: no two coincide;
 * kx, ky: as x, y, but of roots that coincide where each came from; clear, far: how it stands to the point before;
 * turns: how often its order has changed; number, follows, seen: which point it was put in order after (by number: points
 * that held each other would all stay), and how that stood then.
 * @typedef {{ t: number, x: Numbers, y: Numbers, gap: Numbers, apart: boolean, kx: Numbers, ky: Numbers, clear: boolean,
 *   far: boolean, turns: number, number: number, follows: number, seen: number }} TracePoint
 */

let made = 0;

/**
 * @param {number} t
 * @param {Numbers} x
 * @param {Numbers} y
 * @returns {TracePoint}
 */
export function tracePoint(t, x, y) {
  const n = x.length;
  const gap = x.slice(); // arrays made by slice are several times cheaper here than new Float64Arrays
  gap.fill(Infinity);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < i; j++) {
      const dx = x[i] - x[j];
      const dy = y[i] - y[j];
      const d = dx * dx + dy * dy;
      if (d < gap[i]) gap[i] = d;
      if (d < gap[j]) gap[j] = d;
    }
  }
  let apart = true;
  for (let i = 0; i < n; i++) {
    if (gap[i] > 1e-10 * (x[i] * x[i] + y[i] * y[i])) continue;
    gap[i] = Infinity;
    apart = false;
  }
  // One literal: objects put together from parts are several times slower.
  return {
    t,
    x,
    y,
    gap,
    apart,
    kx: x,
    ky: y,
    clear: false,
    far: false,
    turns: 0,
    number: made++,
    follows: -1,
    seen: 0,
  };
}
