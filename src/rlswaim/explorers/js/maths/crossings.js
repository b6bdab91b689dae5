// Where branches of a root locus cross the boundary of stability: the imaginary axis or, in discrete time, the unit circle.
import { gainAtPoint, logarithmicSlope } from './factored_loop.js';
import { EPS } from './polynomials.js';
import { realPhases } from './real_phases.js';

/** @typedef {import('./factored_loop.js').FactoredLoop} FactoredLoop */
/** @typedef {import('./multiple_roots.js').Root} Root */
/**
 * A crossing at s = j omega (or z = e^(j omega)) with omega >= 0; direction +1 as k rises: the root gets unstable.
 * @typedef {{ gain: number, omega: number, direction: number }} Crossing
 */
/**
 * A boundary as the image of the imaginary axis: toPlane maps a root to the plane in which it is the axis, onto the point
 * of the boundary that is nearest to one, at the point of an omega, from w = j tangent the omega.
 * @typedef {{ toPlane: (root: Root) => Root, onto: (x: number, y: number) => [number, number],
 *   at: (omega: number) => [number, number], omega: (tangent: number) => number, excess: boolean }} Boundary
 */

/** @type {Boundary} */
export const IMAGINARY_AXIS = {
  toPlane: (root) => root,
  onto: (_, y) => [0, y],
  at: (omega) => [0, omega],
  omega: (tangent) => tangent,
  excess: false,
};

/** @type {Boundary} */
export const UNIT_CIRCLE = {
  // w = (z - 1)/(z + 1); z = -1 goes to infinity.
  toPlane({ x, y, count }) {
    const square = (x + 1) ** 2 + y * y;
    return { x: ((x - 1) * (x + 1) + y * y) / square, y: (2 * y) / square, count };
  },
  onto(x, y) {
    const size = Math.hypot(x, y);
    return [x / size, y / size];
  },
  at: (omega) => (omega === Math.PI ? [-1, 0] : [Math.cos(omega), Math.sin(omega)]),
  omega: (tangent) => 2 * Math.atan(tangent),
  excess: true,
};

/**
 * The crossings of a loop, by rising omega: there N/D is real and changes its sign's side. A root that is on the boundary
 * at k = 0, or rests there, does not cross it. A crossing that rounding of the data may move by more than the size of its
 * gain is left out.
 * @param {FactoredLoop} loop
 * @param {Boundary} boundary
 * @returns {Crossing[]}
 */
export function crossings(loop, boundary = IMAGINARY_AXIS) {
  if (!Number.isFinite(loop.gain) || loop.gain === 0) return [];
  const mapped = (/** @type {'poles' | 'zeros'} */ of) =>
    loop[of].flatMap((root) => {
      const on = isAt(loop, of, root, ...boundary.onto(root.x, root.y));
      const w = boundary.toPlane(root);
      return Number.isFinite(w.x + w.y) ? [on ? { ...w, x: 0 } : w] : [];
    });
  const [poles, zeros] = [mapped('poles'), mapped('zeros')];
  const size = (/** @type {Root[]} */ roots) => roots.reduce((sum, { count }) => sum + count, 0);
  // A zero at infinity is one at w = 1.
  const excess = size(loop.poles) - size(loop.zeros);
  if (boundary.excess && excess !== 0) zeros.push({ x: 1, y: 0, count: excess });
  const inside = realPhases(poles, zeros).map(boundary.omega);
  const ends = boundary.excess ? [0, Math.PI] : [0];
  return [...ends, ...inside].sort((a, b) => a - b).flatMap((omega) => withGain(loop, boundary, omega));
}

// Whether the data let a pole (or a zero) be at a point beside it.
/**
 * @param {FactoredLoop} loop
 * @param {'poles' | 'zeros'} of
 * @param {Root} root
 * @param {number} x
 * @param {number} y
 */
const isAt = (loop, of, root, x, y) =>
  Math.hypot(root.x - x, root.y - y) <= 1e-3 * Math.hypot(x, y) && loop.isRoot(of, x, y);

/**
 * @param {FactoredLoop} loop
 * @param {Boundary} boundary
 * @param {number} omega
 * @returns {Crossing[]}
 */
function withGain(loop, boundary, omega) {
  const [x, y] = boundary.at(omega);
  const stands = (/** @type {'poles' | 'zeros'} */ of) => loop[of].some((root) => isAt(loop, of, root, x, y));
  if (stands('poles') || stands('zeros')) return [];
  const [gain] = gainAtPoint(loop, x, y);
  const [re, im] = logarithmicSlope(loop, x, y);
  // ds/dk = 1/(k slope), seen along the normal of the boundary: 1 for the axis, the point itself for the circle.
  const [nx, ny] = boundary.excess ? [x, y] : [1, 0];
  const across = re * nx - im * ny;
  const along = Math.abs(re * ny + im * nx);
  const size = [...loop.poles, ...loop.zeros].reduce(
    (sum, root) => sum + root.count / Math.hypot(x - root.x, y - root.y),
    0,
  );
  if (!Number.isFinite(gain) || gain === 0 || !(Math.abs(across) > 4 * EPS * size)) return [];
  const doubt = loop.doubt(x, y) * (1 + along / Math.abs(across));
  return doubt < 1 ? [{ gain, omega, direction: Math.sign(gain) * Math.sign(across) }] : [];
}
