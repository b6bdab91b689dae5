// Which mode a frequency of a loop belongs to.

/** @typedef {import('./closed_loop.js').NamedPoles} NamedPoles */
/** @typedef {{ name: string, omega: number }} Mode */

const LIGHT = 0.3; // damping ratio below which an open-loop pole makes a lobe of its own
const NEAR = 1.25; // factor between frequencies of one mode

/**
 * The lightly damped open-loop poles by rising frequency.
 * @param {NamedPoles} poles
 * @returns {Mode[]}
 */
export function modesOf({ x, y, branches }) {
  const all = branches.map((name, i) => ({ name, omega: Math.hypot(x[i], y[i]), x: x[i], y: y[i] }));
  const light = all.filter((p) => p.y > 0 && Math.abs(p.x) < LIGHT * p.omega);
  return light.map(({ name, omega }) => ({ name, omega })).sort((a, b) => a.omega - b.omega);
}

/**
 * The mode nearest to a frequency, none where all are farther than a quarter.
 * @param {Mode[]} modes
 * @param {number} omega
 * @returns {Mode | undefined}
 */
export function modeAt(modes, omega) {
  /** @param {Mode} mode */
  const apart = (mode) => Math.abs(Math.log(omega / mode.omega));
  const [nearest] = [...modes].sort((a, b) => apart(a) - apart(b));
  return nearest && apart(nearest) < Math.log(NEAR) ? nearest : undefined;
}
