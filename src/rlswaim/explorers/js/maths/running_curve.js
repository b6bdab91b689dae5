// The curve of roots that a locus draws as one parameter runs, the places where a trace stops, and what marks
// it.
import { polynomialAround } from './changed_vehicle.js';
import { gainCurve, gainNodes } from './gain_curve.js';
import { loopOf } from './open_loop.js';
import { stationCrossings } from './station_crossings.js';
import { along, collapse, factorsOf, fill, leftOut } from './terms.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./open_loop.js').What} What */
/** @typedef {import('./break_aways.js').BreakAway} BreakAway */
/** @typedef {import('./crossings.js').Crossing} Crossing */
/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/** @typedef {import('./tracing.js').Curve} Curve */
/**
 * back, forth: the nodes from the present value to the two ends; idle: nothing depends on the parameter.
 * @typedef {{ kind: 'gain' | 'station', curve: Curve, from: number, end: number, back: number[], forth:
 *   number[], idle: boolean, zeros: { x: number[], y: number[] }, breaks: BreakAway[], crossings: (branches:
 *   TracePoint[]) => Crossing[] }} RunningCurve
 */

/**
 * @param {System} system
 * @param {State} state
 * @param {What} what
 * @returns {RunningCurve}
 */
export function runningCurve(system, state, what) {
  return system.running[what.running].magnitudes
    ? runningGain(system, state, what)
    : runningStation(system, state, what.running);
}

/**
 * @param {System} system
 * @param {State} state
 * @param {What} what
 * @returns {RunningCurve}
 */
function runningGain(system, state, what) {
  const t = state[what.running];
  const sign = t < 0 ? -1 : 1;
  const { magnitudes } = system.running[what.running];
  const last = Math.max(magnitudes[1], Math.abs(t));
  const loop = loopOf(system, state, what);
  const isWithin = (/** @type {{ gain: number }} */ { gain }) => gain * sign > 0 && gain * sign < last;
  const breaks = loop.breaks.filter(isWithin);
  const inside = gainNodes(
    magnitudes,
    breaks.map((b) => b.gain * sign),
  ).filter((size) => size < last);
  const nodes = [...inside, last];
  const before = nodes.filter((size) => size < t * sign).map((size) => size * sign);
  return {
    kind: 'gain',
    curve: gainCurve(loop, sign, breaks),
    from: 0,
    end: sign * last,
    back: [t, ...before.reverse()],
    forth: [t, ...nodes.filter((size) => size > t * sign).map((size) => size * sign)],
    idle: false,
    zeros: loop.zeros,
    breaks,
    crossings: () =>
      loop
        .crossings()
        .filter(isWithin)
        .map((c) => ({ ...c, direction: sign * c.direction })), // as its size rises
  };
}

/** @param {number} a @param {number} b */
const halfway = (a, b) => (a + b) / 2;

/**
 * A whole foot where one lies between: shapes are straight between two feet and bend at them.
 * @param {number} a @param {number} b
 */
function footBetween(a, b) {
  const foot = Math.round((a + b) / 2);
  return (foot - a) * (b - foot) > 0 ? foot : halfway(a, b);
}

/**
 * @param {System} system
 * @param {State} state
 * @param {string} station
 * @returns {RunningCurve}
 */
export function runningStation(system, state, station) {
  const { ends, step } = system.running[station];
  const ofVehicle = system.plant?.parameters.includes(station);
  const off = leftOut(system, state);
  const free = Object.keys(system.shapes).filter((f) => system.shapes[f].at === station && !off.includes(f));
  const table = collapse(system.terms, factorsOf(system, state), free);
  /** @type {Record<string, number>} */
  const shape = {};
  /** @type {Curve} */
  const curve = {
    fill(t, c) {
      if (ofVehicle) return c.set(polynomialAround(system.base ?? system, { ...state, [station]: t }));
      for (const f of free) shape[f] = along(system.shapes[f].values, t);
      fill(table, shape, c);
    },
    middle: ofVehicle ? halfway : footBetween,
  };
  const t = state[station];
  const count = Math.floor((ends[1] - ends[0]) / step) || 0;
  const inner = Array.from({ length: count }, (_, i) => (Math.floor(ends[0] / step) + 1 + i) * step);
  const nodes = [ends[0], ...inner.filter((at) => at > ends[0] && at < ends[1]), ends[1]];
  return {
    kind: 'station',
    curve,
    from: ends[0],
    end: ends[1],
    back: [t, ...nodes.filter((at) => at < t).reverse()],
    forth: [t, ...nodes.filter((at) => at > t)],
    idle: free.length === 0 && !ofVehicle,
    zeros: { x: [], y: [] },
    breaks: [],
    crossings: (branches) => stationCrossings(curve, branches),
  };
}
