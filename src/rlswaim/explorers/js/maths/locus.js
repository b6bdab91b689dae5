// The root locus of a control system in any of its parameters.
import { roots } from './aberth.js';
import { closedLoop } from './closed_loop.js';
import { lastLoop, loopOf, withoutGains } from './open_loop.js';
import { runningCurve, runningStation } from './running_curve.js';
import { finished, tracing } from './tracing.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {import('./open_loop.js').What} What */
/** @typedef {import('./line_quality.js').View} View */
/** @typedef {import('./running_curve.js').RunningCurve} RunningCurve */
/** @typedef {import('./trace_points.js').TracePoint} TracePoint */
/** @typedef {import('./closed_loop.js').NamedPoles} NamedPoles */

/**
 * From the present value to both ends.
 * @param {Pick<RunningCurve, 'curve' | 'back' | 'forth'>} running
 * @param {{ x: ArrayLike<number>, y: ArrayLike<number> }} start
 * @param {View} view
 * @returns {Generator<undefined, [TracePoint[], TracePoint[]], undefined>}
 */
function* tracedBothWays({ curve, back, forth }, start, view) {
  return [yield* tracing(curve, back, start, view), yield* tracing(curve, forth, start, view)];
}

/** @param {TracePoint} point */
const hasNumbers = ({ x, y }) => Array.from(x).every(Number.isFinite) && Array.from(y).every(Number.isFinite);

/**
 * The locus of any parameter. A gain runs from 0 to the end of its range, on the side of its sign; a station from the nose
 * to the tail. Each branch has the name of the present pole on it. isFinite tells whether all roots are numbers: they
 * aren't where a parameter is so large that a coefficient overflows.
 * @param {System} system
 * @param {State} state
 * @param {View} view
 * @param {What} what
 */
export function rootLocus(system, state, view, what = lastLoop(system)) {
  const running = runningCurve(system, state, what);
  const { kind, curve, from, end, zeros, breaks } = running;
  const start = presentRoots(system, state, what, curve);
  const [back, forth] = finished(tracedBothWays(running, start, view));
  const branches = [...back.slice(1).reverse(), ...forth];
  const { x, y } = branches[0];
  return {
    kind,
    from,
    end,
    open: { x, y, branches: start.branches },
    zeros,
    breaks,
    crossings: running.crossings(branches),
    branches,
    names: start.branches,
    present: { t: state[what.running], x: start.x, y: start.y },
    // What isn't a number stays so along a branch.
    isFinite: [branches[0], branches[branches.length - 1]].every(hasNumbers),
  };
}

/**
 * The roots at the present value: the named poles, or the zeros, which have no names of their own.
 * @param {System} system
 * @param {State} state
 * @param {What} what
 * @param {import('./tracing.js').Curve} curve
 * @returns {NamedPoles}
 */
function presentRoots(system, state, what, curve) {
  const { running, off, of } = what;
  if (of !== 'zeros') return closedLoop(system, withoutGains(state, off));
  const c = new Float64Array(loopOf(system, state, what).D.length);
  curve.fill(state[running], c);
  const { x, y } = roots(c);
  return { x, y, branches: x.map(() => 'zero') };
}

/**
 * The closed-loop poles at the present gains as a station runs over its range, step by step: from the present one both
 * ways, so that a branch is the one that the locus calls so. Empty at last where the feedback makes no use of it.
 * @param {System} system
 * @param {State} state
 * @param {NamedPoles} present
 * @param {View} view
 * @param {string} station
 * @returns {Generator<undefined, TracePoint[][], undefined>}
 */
export function* poleMapping(system, state, present, view, station = system.maps[0]) {
  const running = runningStation(system, state, station);
  return running.idle ? [] : yield* tracedBothWays(running, present, view);
}

/** @param {Parameters<typeof poleMapping>} given */
export const poleMap = (...given) => finished(poleMapping(...given));
