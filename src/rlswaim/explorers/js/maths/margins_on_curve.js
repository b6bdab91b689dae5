// Margins read off a frequency response, where no polynomial in omega has them: in discrete time.
import { frequencyResponse, responseAt } from './frequency_response.js';
import { gainMargin, phaseMargin } from './one_margin.js';

/** @typedef {import('./frequency_response.js').Loop} Loop */
/** @typedef {import('./polynomials.js').Complex} Complex */

const FARTHER = 1e3; // than its roots a loop may cross
const TURNS = 60; // of a bisection: to the last digit

/**
 * Where a real function of L changes its sign between neighboring frequencies.
 * @param {Loop} loop
 * @param {ArrayLike<number>} omega
 * @param {(value: Complex) => number} of
 */
function crossings(loop, omega, of) {
  const at = (/** @type {number} */ w) => of(responseAt(loop, w));
  const found = [];
  for (let k = 1; k < omega.length; k++) {
    let [low, high] = [omega[k - 1], omega[k]];
    const isPositive = at(low) > 0;
    if (isPositive === at(high) > 0) continue;
    for (let turn = 0; turn < TURNS; turn++) {
      const middle = (low + high) / 2;
      if (at(middle) > 0 === isPositive) low = middle;
      else high = middle;
    }
    found.push((low + high) / 2);
  }
  return found;
}

/**
 * As `marginsOf`, for any loop.
 * @param {Loop} loop
 */
export function marginsOnCurve(loop) {
  if (loop.gain === 0) return null;
  const own = frequencyResponse(loop).omega;
  if (own.length === 0) return { gain: [], phase: [] };
  const beyond = [own[0] / FARTHER, ...(loop.period ? [] : [own.at(-1) * FARTHER])];
  const { omega } = frequencyResponse(loop, beyond);
  const gain = crossings(loop, omega, ([, im]) => im)
    .map((w) => ({ omega: w, value: responseAt(loop, w) }))
    .filter(({ value: [re, im] }) => re < 0 && Math.abs(im) < 1e-6 * Math.abs(re))
    .map(({ omega: w, value: [re] }) => gainMargin(-1 / re, w));
  const phase = crossings(loop, omega, ([re, im]) => Math.hypot(re, im) - 1).map((w) => {
    const [re, im] = responseAt(loop, w);
    return phaseMargin(-re, -im, w);
  });
  return { gain, phase };
}
