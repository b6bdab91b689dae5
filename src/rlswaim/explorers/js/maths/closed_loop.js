// The closed-loop poles with their names, as the loops are closed one after the other.
import { roots } from './aberth.js';
import { gainCurve, gainNodes } from './gain_curve.js';
import { once } from './kept_values.js';
import { BLIND } from './line_quality.js';
import { loopOf, namedPoles, placesOf, withoutGains } from './open_loop.js';
import { polynomialOf } from './terms.js';
import { tracePoint } from './trace_points.js';
import { pointBeside, Tracer } from './tracing.js';

/** @typedef {import('./terms.js').System} System */
/** @typedef {import('./terms.js').State} State */
/** @typedef {{ x: ArrayLike<number>, y: ArrayLike<number>, branches: string[] }} NamedPoles */

/**
 * The roots at a gain as a function of it, traced from 0 as far as asked, and kept. All gains have one sign.
 * @param {System} system
 * @param {State} state
 * @param {string} running
 * @param {number} sign
 * @param {NamedPoles} start the roots without this gain
 */
function pathOf(system, state, running, sign, start) {
  return once(system, `path ${running} ${sign} ${placesOf(system, { ...state, [running]: 0 })}`, () => {
    const loop = loopOf(system, state, { running });
    const breaks = loop.breaks.filter((b) => b.gain * sign > 0);
    const nodes = gainNodes(
      system.running[running].magnitudes,
      breaks.map((b) => b.gain * sign),
    );
    const curve = gainCurve(loop, sign, breaks);
    const tracer = new Tracer(curve, start.x.length, BLIND);
    const points = [tracePoint(0, Array.from(start.x), Array.from(start.y))];
    return (/** @type {number} */ gain) => {
      const before = nodes.filter((size) => size < Math.abs(gain));
      while (points.length < before.length) {
        const stretch = tracer.to(points[points.length - 1], sign * nodes[points.length]);
        points.push(stretch[stretch.length - 1]);
      }
      const last = tracer.to(points[before.length - 1], gain);
      return pointBeside(curve, gain, last[last.length - 1]);
    };
  });
}

/**
 * The closed-loop poles, each with the name of the open-loop pole that it grows out of as the loops are
 * closed one after the other, in the report's order.
 * @param {System} system
 * @param {State} state
 * @returns {NamedPoles}
 */
export function closedLoop(system, state) {
  return once(system, `poles ${placesOf(system, state)}`, () => {
    const poles = namedPoles(system, state);
    let now = withoutGains(state, system.locus_gains);
    for (const running of system.locus_gains) {
      const gain = state[running];
      if (gain === 0) continue;
      const end = pathOf(system, now, running, Math.sign(gain), poles)(gain);
      [poles.x, poles.y] = [end.x, end.y];
      now = { ...now, [running]: gain };
    }
    return poles;
  });
}

/**
 * The closed-loop poles alone, unordered: to choose the window before anything is traced.
 * @param {System} system
 * @param {State} state
 */
export const closedLoopPoles = (system, state) => roots(polynomialOf(system, state));
