// A compensator of sections in series, and its place in a loop: as a factor of one gain's signal.
import { multiply } from './polynomials.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').Term} Term */
/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/**
 * kind: a key of KINDS; values: its numbers, in the order of the kind's names.
 * @typedef {{ kind: string, values: number[] }} Section
 */
/**
 * place: the gain whose signal goes through it.
 * @typedef {{ place: string, gain: number, sections: Section[] }} Compensator
 */
/** @typedef {{ N: Coefficients, D: Coefficients }} Ratio constant term first; 1 at s = 0 where it can be */
/**
 * names: of the numbers, with unit; least, most: their bounds; fresh: the first values, from a frequency.
 * @typedef {{ text: string, names: string[], least: number[], most: number[],
 *   fresh: (omega: number) => number[], ratio: (values: number[]) => Ratio }} Kind
 */

/** The most sections, and the highest order that all of them may have together. */
export const MOST = { sections: 8, order: 12 };
export const SLOWEST = 1e-2; // rad/s: a real root nearer to the origin is at it
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

/** @type {Record<string, Kind>} */
export const KINDS = {
  pole: {
    text: 'Real pole',
    names: ['s (1/s)'],
    least: [-FASTEST],
    most: [FASTEST],
    fresh: (omega) => [-omega],
    ratio: ([at]) => ({ N: [1], D: root(at) }),
  },
  zero: {
    text: 'Real zero',
    names: ['s (1/s)'],
    least: [-FASTEST],
    most: [FASTEST],
    fresh: (omega) => [-omega],
    ratio: ([at]) => ({ N: root(at), D: [1] }),
  },
  poles: {
    text: 'Pole pair',
    names: ['ω (rad/s)', 'ζ'],
    least: [SLOWEST, -1],
    most: [FASTEST, 1],
    fresh: (omega) => [omega, 0.5],
    ratio: ([omega, zeta]) => ({ N: [1], D: pair(omega, zeta) }),
  },
  zeros: {
    text: 'Zero pair',
    names: ['ω (rad/s)', 'ζ'],
    least: [SLOWEST, -1],
    most: [FASTEST, 1],
    fresh: (omega) => [omega, 0.1],
    ratio: ([omega, zeta]) => ({ N: pair(omega, zeta), D: [1] }),
  },
  notch: {
    text: 'Notch',
    names: ['ω (rad/s)', 'ζ of zeros', 'ζ of poles'],
    least: [SLOWEST, 0, 0.01],
    most: [FASTEST, 1, 1],
    fresh: (omega) => [omega, 0.05, 0.5],
    ratio: ([omega, zero, pole]) => ({ N: pair(omega, zero), D: pair(omega, pole) }),
  },
  lead: {
    text: 'Lead or lag',
    names: ['zero (1/s)', 'pole (1/s)'],
    least: [-FASTEST, -FASTEST],
    most: [-SLOWEST, -SLOWEST],
    fresh: (omega) => [-omega / 2, -omega * 2],
    ratio: ([zero, pole]) => ({ N: root(zero), D: root(pole) }),
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
  },
};

/** How many zeros and poles a section has. @param {Section} section */
export function orderOf({ kind, values }) {
  const { N, D } = KINDS[kind].ratio(values);
  return { zeros: N.length - 1, poles: D.length - 1 };
}

/** Those of all sections. @param {Section[]} sections */
export function ordersOf(sections) {
  const all = sections.map(orderOf);
  /** @param {(order: { zeros: number, poles: number }) => number} part */
  const sum = (part) => all.reduce((total, order) => total + part(order), 0);
  return { zeros: sum(({ zeros }) => zeros), poles: sum(({ poles }) => poles) };
}

/**
 * gain N/D of all sections.
 * @param {Compensator} compensator
 * @returns {{ N: Float64Array, D: Float64Array }}
 */
export function ratioOf({ gain, sections }) {
  const all = sections.map(({ kind, values }) => KINDS[kind].ratio(values));
  /** @param {'N' | 'D'} part @param {number} first */
  const product = (part, first) =>
    all.reduce((found, ratio) => multiply(found, ratio[part]), Float64Array.of(first));
  return { N: product('N', gain), D: product('D', 1) };
}

/** Can it be built: has it as many poles as zeros? @param {Compensator} compensator */
export function isProper({ sections }) {
  const { zeros, poles } = ordersOf(sections);
  return zeros <= poles;
}

/** A complex root and its conjugate. @param {number} re @param {number} im */
const twin = (re, im) => [
  { re, im },
  { re, im: -im },
];

/** The roots of a polynomial of degree 2 at most. @param {Coefficients} c */
function shortRoots(c) {
  if (c.length < 2) return [];
  if (c.length === 2) return [{ re: c[0] === 0 ? 0 : -c[0] / c[1], im: 0 }];
  const [half, square] = [-c[1] / (2 * c[2]), c[0] / c[2]];
  const rest = half * half - square;
  if (rest < 0) return twin(half, Math.sqrt(-rest));
  const far = half + (half < 0 ? -1 : 1) * Math.sqrt(rest);
  return [
    { re: far, im: 0 },
    { re: far ? square / far : 0, im: 0 },
  ];
}

/** @typedef {(c: Coefficients) => { x: ArrayLike<number>, y: ArrayLike<number> }} Solver */

/**
 * The poles and the zeros of a section.
 * @param {Section} section
 * @param {Solver} solve for what is longer than a quadratic
 */
export function rootsOf({ kind, values }, solve) {
  const { N, D } = KINDS[kind].ratio(values);
  /** @param {Coefficients} c */
  const found = (c) => {
    if (c.length <= 3) return shortRoots(c);
    const { x, y } = solve(c);
    return Array.from(x, (re, i) => ({ re, im: y[i] }));
  };
  return { zeros: found(N), poles: found(D) };
}
