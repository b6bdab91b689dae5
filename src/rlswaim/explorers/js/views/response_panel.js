// The responses in time of the closed loop after a step, a gust, or a displacement at the start.
import { contextOf } from '../drawing/context.js';
import { drawResponses, heightOf, responseWords } from '../drawing/response_charts.js';
import { stepResponse } from '../maths/own_response.js';
import { responses } from '../maths/responses.js';
import { element, panel, picture, select } from '../page/elements.js';
import { DURATIONS, GUSTS } from './excitations.js';

/** @import { Workbench } from './workbench.js' */

const SAMPLES = 181;

/** @param {number[]} choices s @returns {[number, string][]} */
const seconds = (choices) => choices.map((s) => [s, `${s} s`]);

export class ResponsePanel {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.height = 0;
    this.duration = 0;
    this.canvas = picture('responses', {}).canvas;
    /** @type {[number, string][]} */
    const inputs = bench.state.inputs.map(({ text }, i) => [i, text]);
    /** @param {string} name */
    const look = (name) => (/** @type {string} */ value) => bench.look({ [name]: Number(value) });
    this.lists = {
      input: select('After a', inputs, look('input')),
      gust: select('lasting', seconds(GUSTS), look('gust')),
      duration: select('over', seconds(bench.system.durations ?? DURATIONS), look('duration')),
    };
    const nodes = Object.values(this.lists).map(({ node }) => node);
    const row = element('div', { class: 'controls' }, ...nodes);
    this.panel = panel('responses', 'Responses', () => bench.page.follow(), row, this.canvas);
    this.node = this.panel.node;
    this.#choose();
  }

  #choose() {
    const { shown, response } = this.bench.state;
    const { input, gust, duration } = this.lists;
    input.choose(shown.input);
    gust.choose(shown.gust);
    duration.choose(shown.duration);
    gust.node.hidden = response.kind !== 'gust';
  }

  /** @param {number} width */
  draw(width) {
    const { system, state, page } = this.bench;
    const { duration } = state.shown;
    if (this.duration !== duration) {
      this.duration = duration;
      this.times = Float64Array.from({ length: SAMPLES }, (_, k) => (duration * k) / (SAMPLES - 1));
    }
    /** @type {Record<string, Float64Array>} */
    this.found = system.loop
      ? { y: stepResponse(system, state.values, this.times) }
      : responses(system, state.values, state.response, this.times);
    const height = this.bench.desk.room(this.canvas) ?? heightOf(width, Object.keys(this.found).length);
    if (this.height !== height) {
      this.height = height;
      this.canvas.style.height = `${height}px`;
    }
    const g = contextOf(this.canvas, width, height);
    drawResponses(g, width, height, page.theme, this.times, this.found, system.units);
    this.#choose();
  }

  /** Words that may lag a little behind the picture. */
  later() {
    if (!this.found) return;
    const { system, state } = this.bench;
    const { text } = state.inputs[state.shown.input];
    const told = responseWords(this.found, system.units);
    this.canvas.ariaLabel = `Responses over ${state.shown.duration} s after a ${text}. ${told}`;
  }
}
