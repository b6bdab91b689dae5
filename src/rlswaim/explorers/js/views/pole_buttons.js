// Where the keyboard finds the poles of a locus: a button over the mark of each pole above the axis.

import { complex } from '../drawing/numbers.js';
import { button, element } from '../page/elements.js';

/** @import { Roots, View } from '../types.d.ts' */
/** @typedef {{ node: HTMLButtonElement, hidden: boolean, px: number, py: number }} Handle */

const UNTOLD = 'A pole of the closed loop'; // until the words follow the picture

export class PoleButtons {
  /** @param {(branch: number) => void} open */
  constructor(open) {
    this.open = open;
    this.node = element('div', { class: 'handles' });
    /** @type {Handle[]} */
    this.handles = [];
  }

  /** @param {Roots} poles @param {View} view */
  place({ x, y }, view) {
    while (this.handles.length < x.length) {
      const branch = this.handles.length;
      const node = button('', () => this.open(branch));
      node.ariaLabel = UNTOLD;
      this.node.append(node);
      this.handles.push({ node, hidden: false, px: NaN, py: NaN });
    }
    this.handles.forEach((handle, i) => {
      const [px, py] = [view.X(x[i]), view.Y(y[i])];
      const hidden = !(i < x.length && y[i] >= 0 && view.holds(px, py));
      if (handle.hidden !== hidden) {
        handle.hidden = hidden;
        handle.node.hidden = hidden;
      }
      if (hidden || (handle.px === px && handle.py === py)) return;
      Object.assign(handle, { px, py });
      handle.node.style.transform = `translate(${px.toFixed(1)}px, ${py.toFixed(1)}px)`;
    });
  }

  /** @param {Roots} poles @param {string[]} branches */
  tell({ x, y }, branches) {
    this.handles.forEach(({ node, hidden }, i) => {
      if (hidden) return;
      const stable = x[i] > 0 ? 'unstable' : 'stable';
      const label = `${branches[i]} at ${complex(x[i], y[i])} 1/s, ${stable}; Enter shows its mode`;
      if (node.ariaLabel !== label) node.ariaLabel = label;
    });
  }
}
