// The kinds of sections that a compensator in continuous time has.

/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {{ re: number, im: number }} Place of a root */
/**
 * Constant term first; 1 at s = 0 (z = 1 in discrete time) where it can be.
 * @typedef {{ N: Coefficients, D: Coefficients }} Ratio
 */
/**
 * names: of the numbers, with unit; least, most: their bounds; snap: the nearest number that it may be;
 * fresh: the first values, from a frequency (rad/s, in discrete time rad a sample); moved: the values with a
 * zero or a pole elsewhere, absent where none can be moved; isOne: whether all its roots move as one.
 * @typedef {{ text: string, names: string[], least: number[], most: number[],
 *   fresh: (omega: number) => number[], ratio: (values: number[]) => Ratio,
 *   snap?: (k: number, value: number) => number, isOne?: boolean,
 *   moved?: (values: number[], isZero: boolean, to: Place, from: Place) => number[] }} Kind
 */

const SLOWEST = 1e-2; // rad/s: a real root nearer to the origin is at it
const FASTEST = 1e3;

/** A real root at s = at: 1 - s/at, or s at the origin. @param {number} at */
const root = (at) => (at === 0 ? [0, 1] : [1, -1 / at]);
/** @param {number} omega @param {number} zeta */
const pair = (omega, zeta) => [1, (2 * zeta) / omega, 1 / (omega * omega)];

/**
 * The numerator of Pade's approximation of e^(-s T), of order n over n; the denominator has -s in it.
 * @param {number} T s
 * @param {number} n
 */
function pade(T, n) {
  const c = [1];
  for (let k = 1; k <= n; k++) c.push((c[k - 1] * (n - k + 1) * T) / ((2 * n - k + 1) * k));
  return c;
}

/** As a number is told. @param {number} v */
const short = (v) => Number(v.toPrecision(4));
/** @param {number} _ @param {number} value */
const orOrigin = (_, value) => (Math.abs(value) < SLOWEST ? 0 : value);
/** @param {Place} to */
const omegaZeta = ({ re, im }) => [short(Math.hypot(re, im)), short(-re / Math.hypot(re, im))];

/** @type {Record<string, Kind>} */
export const SECTIONS_IN_S = {
  pole: {
    text: 'Real pole',
    names: ['s (1/s)'],
    least: [-FASTEST],
    most: [FASTEST],
    fresh: (omega) => [-omega],
    ratio: ([at]) => ({ N: [1], D: root(at) }),
    snap: orOrigin,
    moved: (_values, _isZero, { re }) => [short(re)],
  },
  zero: {
    text: 'Real zero',
    names: ['s (1/s)'],
    least: [-FASTEST],
    most: [FASTEST],
    fresh: (omega) => [-omega],
    ratio: ([at]) => ({ N: root(at), D: [1] }),
    snap: orOrigin,
    moved: (_values, _isZero, { re }) => [short(re)],
  },
  poles: {
    text: 'Pole pair',
    names: ['ω (rad/s)', 'ζ'],
    least: [SLOWEST, -1],
    most: [FASTEST, 1],
    fresh: (omega) => [omega, 0.5],
    ratio: ([omega, zeta]) => ({ N: [1], D: pair(omega, zeta) }),
    moved: (_values, _isZero, to) => omegaZeta(to),
  },
  zeros: {
    text: 'Zero pair',
    names: ['ω (rad/s)', 'ζ'],
    least: [SLOWEST, -1],
    most: [FASTEST, 1],
    fresh: (omega) => [omega, 0.1],
    ratio: ([omega, zeta]) => ({ N: pair(omega, zeta), D: [1] }),
    moved: (_values, _isZero, to) => omegaZeta(to),
  },
  notch: {
    text: 'Notch',
    names: ['ω (rad/s)', 'ζ of zeros', 'ζ of poles'],
    least: [SLOWEST, 0, 0.01],
    most: [FASTEST, 1, 1],
    fresh: (omega) => [omega, 0.05, 0.5],
    ratio: ([omega, zero, pole]) => ({ N: pair(omega, zero), D: pair(omega, pole) }),
    moved([, zero, pole], isZero, to) {
      const [omega, zeta] = omegaZeta(to);
      return isZero ? [omega, zeta, pole] : [omega, zero, zeta];
    },
  },
  lead: {
    text: 'Lead or lag',
    names: ['zero (1/s)', 'pole (1/s)'],
    least: [-FASTEST, -FASTEST],
    most: [-SLOWEST, -SLOWEST],
    fresh: (omega) => [-omega / 2, -omega * 2],
    ratio: ([zero, pole]) => ({ N: root(zero), D: root(pole) }),
    moved: ([zero, pole], isZero, { re }) => (isZero ? [short(re), pole] : [zero, short(re)]),
  },
  delay: {
    text: 'Delay',
    names: ['T (s)', 'order of Padé'],
    least: [1e-3, 1],
    most: [10, 4],
    fresh: (omega) => [Number((0.1 / omega).toPrecision(3)), 2],
    ratio: ([T, order]) => {
      const D = pade(T, order);
      return { N: D.map((c, k) => (k % 2 ? -c : c)), D };
    },
    snap: (k, value) => (k === 1 ? Math.round(value) : value),
    isOne: true,
    moved: ([T, order], _isZero, to, from) => [
      short((T * Math.hypot(from.re, from.im)) / Math.hypot(to.re, to.im)),
      order,
    ],
  },
};
