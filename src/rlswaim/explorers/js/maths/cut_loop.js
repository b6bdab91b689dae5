// The loop that is cut open at one gain, as its frequency response sees it.
import { closedLoop } from './closed_loop.js';
import { marginsOf } from './margins.js';
import { marginsOnCurve } from './margins_on_curve.js';
import { lastLoop, loopOf, withoutGains } from './open_loop.js';
import { ownMargins } from './own_margins.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./open_loop.js').What} What */
/** @typedef {import('./factored_loop.js').FactoredLoop} FactoredLoop */
/** @typedef {import('./closed_loop.js').NamedPoles} NamedPoles */
/** @typedef {import('./margins.js').Loop} PolynomialLoop */
/**
 * L = gain N/D, closed by 1 + L = 0. parts: N/D as factors; period: s between samples, 0 in continuous time;
 * poles: those of D by name; isStable: whether the loop closed is; loop: what margins are found from.
 * @typedef {{ running: string, gain: number, period: number, parts: FactoredLoop, poles: NamedPoles,
 *   isStable: boolean, loop: PolynomialLoop }} CutLoop
 */

/**
 * Which loop is cut: the one that the locus shows or, where that runs a station or shows zeros, the last of
 * the system's own.
 * @param {System & { loci?: What[] }} system
 * @param {What} what
 * @returns {What}
 */
export function loopToCut(system, what) {
  /** @param {What} other */
  const isLoop = (other) => other.of !== 'zeros' && Boolean(system.running[other.running]?.magnitudes);
  return [what, ...(system.loci ?? []).toReversed()].find(isLoop) ?? lastLoop(system);
}

/**
 * Time between samples (s, 1 where it is not told), 0 in continuous time.
 * @param {System & { period?: number }} system
 */
export function periodOf(system) {
  const dt = system.loop?.dt;
  return dt === true ? 1 : (dt ?? system.period ?? 0);
}

/**
 * @param {System & { loci?: What[], period?: number }} system
 * @param {State} state
 * @param {What} shown by the locus
 * @returns {CutLoop}
 */
export function cutLoop(system, state, shown) {
  const what = loopToCut(system, shown);
  const { running, off } = what;
  const loop = loopOf(system, state, what);
  const period = periodOf(system);
  const still = withoutGains(state, off);
  const { x, y } = closedLoop(system, still);
  /** @param {number} re @param {number} i */
  const decays = (re, i) => (period ? Math.hypot(re, y[i]) < 1 : re < 0);
  return {
    running,
    gain: state[running],
    period,
    parts: loop.parts,
    poles: closedLoop(system, { ...still, [running]: 0 }),
    isStable: Array.from(x).every(decays),
    loop,
  };
}

/** The margins of a loop that is cut. @param {CutLoop} cut */
export const cutMargins = (cut) => (cut.period ? marginsOnCurve(cut) : marginsOf(cut.loop, cut.gain));

/**
 * The margins by which a loop is judged: of one that a reader gave those from its factors, which are exact,
 * at frequency 0 too; of any other those at the frequencies of its response.
 * @param {System} system
 * @param {CutLoop} cut
 */
export function judgedMargins({ loop }, cut) {
  if (!loop) {
    const found = cutMargins(cut);
    return found && { ...found, gain: found.gain.filter(({ omega }) => omega > 0) };
  }
  const found = ownMargins(cut.parts, cut.loop.crossings(), cut.gain, loop.dt);
  /** @template {{ omega: number }} Each @param {Each} margin @returns {Each} */
  const inTime = (margin) => ({ ...margin, omega: margin.omega / (cut.period || 1) });
  return found && { gain: found.gain.map(inTime), phase: found.phase.map(inTime) };
}
