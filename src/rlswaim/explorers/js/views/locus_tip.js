// What the pointer reads off a root locus: the branch, the value of what runs, frequency and damping.

import { number } from '../drawing/numbers.js';
import { element, symbol } from '../page/elements.js';

/** @import { View } from '../types.d.ts' */
/** @import { Place } from '../drawing/nearest.js' */

export class LocusTip {
  constructor() {
    this.node = element('div', { class: 'tip', role: 'tooltip', 'aria-live': 'off', hidden: true });
    this.spot = element('div', { class: 'spot', hidden: true });
  }

  hide() {
    this.node.hidden = true;
    this.spot.hidden = true;
  }

  /**
   * @param {Place} place @param {View} view @param {string} branch @param {string} running
   * @param {string} value
   */
  show({ x, y }, view, branch, running, value) {
    this.node.hidden = false;
    this.spot.hidden = false;
    const omega = Math.hypot(x, y);
    const zeta = omega ? ` · ζ ${number(-x / omega, 3)}` : '';
    this.node.replaceChildren(
      element('b', {}, branch),
      element('br'),
      ...symbol(running),
      ` ${value} · ω ${number(omega, 3)} rad/s${zeta}`,
    );
    const [left, top] = [view.X(x), view.Y(Math.abs(y))];
    this.spot.style.transform = `translate(${left}px, ${top}px)`;
    const at = Math.min(Math.max(left + 12, 0), view.width - this.node.offsetWidth - 2);
    this.node.style.transform = `translate(${at}px, ${Math.max(top - 52, 0)}px)`;
  }
}
