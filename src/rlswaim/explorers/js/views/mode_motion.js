// The bent vehicle moves in the closed-loop mode that is picked on the bench below it.
import { modeShape } from '../maths/mode_shape.js';

/** @import { Values } from '../types.d.ts' */
/** @import { Lifecycle } from '../page/lifecycle.js' */
/** @import { PageBench } from './page_bench.js' */
/**
 * @typedef {(motions: Values | null, name: string) => void} Show motions as the view's sliders; null at
 *   rest
 */

const PERIOD = 2400; // ms of one swing on the page, whatever the mode's own
const LARGEST = 40; // ft, the largest deflection that is drawn
const DEGREES = 180 / Math.PI;

/**
 * The motions of a mode at a phase of its swing, its deflection so large.
 * @param {any} mode its outputs as complex numbers, for a largest deflection of 1 ft @param {number} phase
 * @returns {Values}
 */
export function motionsAt({ alpha, theta, q1, q2, delta }, phase) {
  /** @param {[number, number]} value @param {number} unit */
  const now = ([re, im], unit = 1) => LARGEST * unit * (re * Math.cos(phase) - im * Math.sin(phase));
  return {
    q_1: now(q1),
    q_2: now(q2),
    theta: now(theta, DEGREES),
    alpha: now(alpha, DEGREES),
    delta: now(delta, DEGREES),
  };
}

export class ModeMotion {
  /** @param {Lifecycle} page of the view @param {Show} show */
  constructor(page, show) {
    this.page = page;
    this.show = show;
    this.next = 0;
    this.still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    /** @type {PageBench | null} */
    this.bench = null;
    this.begin = () => this.#frame(performance.now());
  }

  /** @param {PageBench | null} bench that is open */
  follow(bench) {
    this.bench?.workbench.mode.node.removeEventListener('toggle', this.begin);
    this.bench = bench;
    bench?.workbench.mode.node.addEventListener('toggle', this.begin);
    this.begin();
  }

  /** @param {number} now ms */
  #frame(now) {
    cancelAnimationFrame(this.next);
    const { bench } = this;
    const pole = bench?.workbench.closed && bench.workbench.selected(bench.workbench.closed);
    if (!pole) return this.show(null, '');
    const { system, state, mode } = bench.workbench;
    const found = modeShape(system, state.values, pole);
    const phase = this.still || mode.paused ? 0 : (2 * Math.PI * (now % PERIOD)) / PERIOD;
    if (this.page.seen) this.show(found && motionsAt(found, phase), pole.name);
    this.next = requestAnimationFrame((time) => this.#frame(time));
  }

  stop() {
    this.follow(null);
    cancelAnimationFrame(this.next);
  }
}
