// Long work in slices, so that the page stays alive meanwhile.

/**
 * The parts of the work that came, the time that they took, and at its end the result.
 * @template Part, Result
 * @typedef {{ parts: Part[], ms: number, done: boolean, result?: Result }} Found
 */

/**
 * Goes on with work for some time.
 * @template Part, Result
 * @param {Generator<Part, Result>} steps @param {number} ms
 * @returns {Found<Part, Result>}
 */
export function slice(steps, ms) {
  const parts = [];
  const start = performance.now();
  let spent = 0;
  while (spent < ms) {
    const step = steps.next();
    spent = performance.now() - start;
    if (step.done === true) return { parts, ms: spent, done: true, result: step.value };
    parts.push(step.value);
  }
  return { parts, ms: spent, done: false };
}

/**
 * Goes on with work slice by slice, the page's own work in between; the first slice comes after a delay, or
 * at once. Returns what stops it.
 * @template Part, Result
 * @param {Generator<Part, Result>} steps @param {number} ms of a slice
 * @param {(found: Found<Part, Result>) => void} receive
 * @param {number} [delay] ms
 */
export function inSlices(steps, ms, receive, delay) {
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;
  const turn = () => {
    const found = slice(steps, ms);
    if (!found.done) timer = setTimeout(turn);
    receive(found);
  };
  if (delay === undefined) turn();
  else timer = setTimeout(turn, delay);
  return () => clearTimeout(timer);
}

const SPARE = 3; // ms of rest that are left to the page
const LONGEST = 4; // ms: a key that comes in a rest waits no longer

/**
 * Goes on with work while the page rests, where the browser tells when it does.
 * @param {Generator<unknown>} steps
 */
export function whileResting(steps) {
  globalThis.requestIdleCallback?.((rest) => {
    const time = Math.min(rest.timeRemaining() - SPARE, LONGEST);
    if (time <= 0 || !slice(steps, time).done) whileResting(steps);
  });
}
