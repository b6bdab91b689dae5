// A frequency on the boundary of stability in the picture of the locus: shown there, and read there.
import { element } from '../page/elements.js';
import { placeOn } from '../page/movable_point.js';

/** @import { Sample } from '../maths/frequency_response.js' */
/** @import { LocusPlane } from './locus_plane.js' */

const REACH = 7; // px from the axis within which the pointer reads a frequency

export class AxisSpot {
  /** @param {LocusPlane} plane @param {(omega: number) => void} mark NaN where the pointer is away */
  constructor(plane, mark) {
    this.plane = plane;
    this.mark = mark;
    this.reads = false;
    this.node = element('div', { class: 'spot', 'data-spot': 'frequency', hidden: true });
    plane.canvas.parentElement.append(this.node);
    plane.canvas.addEventListener('pointermove', (event) => this.#read(event));
    plane.canvas.addEventListener('pointerleave', () => this.reads && mark(NaN));
  }

  /** @param {boolean} reads whether the pointer on the plane is listened to */
  listen(reads) {
    this.reads = reads;
    if (!reads) this.node.hidden = true;
  }

  /** @param {PointerEvent} event */
  #read(event) {
    const { view } = this.plane;
    if (!this.reads || !view || event.buttons) return;
    const [px, py] = placeOn(this.plane.canvas, event);
    const isNear = view.holds(px, py) && Math.abs(px - view.X(0)) < REACH && view.y(py) > 0;
    this.mark(isNear ? view.y(py) : NaN);
  }

  /** @param {Sample | null} sample @param {number} period s, 0 in continuous time */
  show(sample, period) {
    const { view } = this.plane;
    const [x, y] = sample && period ? onCircle(sample.omega * period) : [0, sample?.omega];
    const isSeen = Boolean(sample && view?.holds(view.X(x), view.Y(y)));
    this.node.hidden = !isSeen;
    if (isSeen) this.node.style.transform = `translate(${view.X(x)}px, ${view.Y(y)}px)`;
  }
}

/** @param {number} angle */
const onCircle = (angle) => [Math.cos(angle), Math.sin(angle)];
