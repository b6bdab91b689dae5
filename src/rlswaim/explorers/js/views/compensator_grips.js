// What takes hold of a compensator's poles and zeros: a ring about each, in the s plane and at its
// frequency on the Bode diagram, for mouse, finger and keys.
import { roots } from '../maths/aberth.js';
import { KINDS, rootsOf } from '../maths/compensator.js';
import { button, element } from '../page/elements.js';
import { movable, movableByKeys } from '../page/movable_point.js';

/** @import { View } from '../types.d.ts' */
/** @import { Section } from '../maths/compensator.js' */
/**
 * A root of a section that can be moved: set returns the section's numbers with the root elsewhere.
 * @typedef {{ section: number, kind: string, isZero: boolean, re: number, im: number,
 *   set: (re: number, im: number) => number[] }} Grip
 */
/** @typedef {{ x: number, y: number }} Spot px */

/** @param {Section[]} sections @returns {Grip[]} */
export const gripsOf = (sections) =>
  sections.flatMap((section, at) => {
    const { kind, values } = section;
    const { moved, isOne } = KINDS[kind];
    if (!moved) return [];
    const { poles, zeros } = rootsOf(section, roots);
    /** @param {{ re: number, im: number }[]} all @param {boolean} isZero */
    const upper = (all, isZero) =>
      all
        .filter(({ im }) => im >= 0)
        .slice(0, isOne ? 1 : 2)
        .map((from) => ({
          section: at,
          kind,
          isZero,
          ...from,
          set: (/** @type {number} */ re, /** @type {number} */ im) =>
            moved(values, isZero, { re, im }, from),
        }));
    return [...upper(poles, false), ...(isOne ? [] : upper(zeros, true))];
  });

export class Grips {
  /**
   * @param {HTMLElement} stage on which they lie
   * @param {{ view: () => View, spot: (grip: Grip, view: View) => Spot,
   *   moved: (grip: Grip, x: number, y: number) => [number, number],
   *   stepped: (re: number, im: number, right: number, up: number) => [number, number],
   *   told: (re: number, im: number) => string, put: (section: number, values: number[]) => void,
   *   drop: () => void }} place how a root and a place of the stage belong together
   */
  constructor(stage, place) {
    this.place = place;
    this.node = element('div', { class: 'grips' });
    stage.append(this.node);
    /** @type {{ node: HTMLButtonElement, grip: Grip, x: number, y: number }[]} */
    this.all = [];
  }

  #make() {
    const made = { node: button('', () => {}), grip: /** @type {Grip} */ (undefined), x: 0, y: 0 };
    const { place } = this;
    /** @param {number} re @param {number} im */
    const put = (re, im) => place.put(made.grip.section, made.grip.set(re, Math.max(im, 0)));
    /** @type {import('../page/movable_point.js').MovablePoint} */
    const point = {
      grab: () => 0,
      drag: (_, px, py) => put(...place.moved(made.grip, px + made.x - 13, py + made.y - 13)),
      drop: place.drop,
      step: (right, up) => {
        const { re, im } = made.grip;
        put(...place.stepped(re, im, right, up));
      },
    };
    movable(/** @type {any} */ (made.node), point);
    movableByKeys(made.node, point);
    this.node.append(made.node);
    this.all.push(made);
  }

  /** @param {Section[]} sections */
  show(sections) {
    const grips = gripsOf(sections);
    const view = grips.length ? this.place.view() : undefined;
    while (this.all.length < grips.length) this.#make();
    this.all.forEach((made, i) => {
      made.grip = grips[i];
      const spot = view && grips[i] && this.place.spot(grips[i], view);
      const isSeen = Boolean(spot) && view.holds(spot.x, spot.y);
      made.node.hidden = !isSeen;
      if (!isSeen) return;
      Object.assign(made, spot);
      made.node.style.transform = `translate(${spot.x}px, ${spot.y}px)`;
      const { kind, isZero, re, im } = grips[i];
      const label = `${isZero ? 'zero' : 'pole'} of the compensator’s ${KINDS[kind].text.toLowerCase()} at `;
      made.node.ariaLabel = `${label}${this.place.told(re, im)}`;
    });
  }
}
