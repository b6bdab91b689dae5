// A compensator of sections in series, and its place in a loop: as a factor of one gain's signal.
import { multiply } from './polynomials.js';
import { SECTIONS_IN_S } from './sections_in_s.js';
import { SECTIONS_IN_Z } from './sections_in_z.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').Term} Term */
/** @typedef {import('./polynomials.js').Coefficients} Coefficients */
/** @typedef {import('./sections_in_s.js').Kind} Kind */
/**
 * kind: a key of KINDS; values: its numbers, in the order of the kind's names.
 * @typedef {{ kind: string, values: number[] }} Section
 */
/**
 * place: the gain whose signal goes through it.
 * @typedef {{ place: string, gain: number, sections: Section[] }} Compensator
 */

/** The most sections, and the highest order that all of them may have together. */
export const MOST = { sections: 8, order: 12 };

/** @type {Record<string, Kind>} */
export const KINDS = { ...SECTIONS_IN_S, ...SECTIONS_IN_Z };

/** Names of the kinds for continuous or discrete time. @param {boolean} isDiscrete */
export const kindsOf = (isDiscrete) => Object.keys(isDiscrete ? SECTIONS_IN_Z : SECTIONS_IN_S);

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

/** N and D of all sections, the leading coefficient of D 1. @param {Compensator} compensator */
export function monic(compensator) {
  const { N, D } = ratioOf(compensator);
  return [N, D].map((c) => c.map((v) => v / D[D.length - 1]));
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
 * The poles and the zeros of a section, those at the origin last.
 * @param {Section} section
 * @param {Solver} solve for what is longer than a quadratic
 */
export function rootsOf({ kind, values }, solve) {
  const { N, D } = KINDS[kind].ratio(values);
  /** @param {Coefficients} c */
  const found = (c) => {
    if (c.length <= 3) return shortRoots(c);
    const all = Array.from(c);
    const resting = all.findIndex((v) => v !== 0);
    const { x, y } = solve(all.slice(resting));
    const rest = Array.from(x, (re, i) => ({ re, im: y[i] }));
    return [...rest, ...Array(resting).fill({ re: 0, im: 0 })];
  };
  return { zeros: found(N), poles: found(D) };
}
