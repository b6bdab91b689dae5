// What takes hold of a compensator's poles and zeros: a ring about each, in the s plane and at its
// frequency on the Bode diagram, for mouse, finger and keys.
import { roots } from '../maths/aberth.js';
import { KINDS, rootsOf } from '../maths/compensator.js';
import { button, element } from '../page/elements.js';
import { movable, movableByKeys } from '../page/movable_point.js';
import { complex, number } from '../page/numbers.js';

/** @import { View } from '../types.d.ts' */
/** @import { Section } from '../maths/compensator.js' */
/**
 * A root of a section that can be moved: set returns the section's numbers with the root elsewhere.
 * @typedef {{ section: number, kind: string, isZero: boolean, re: number, im: number,
 *   set: (re: number, im: number) => number[] }} Grip
 */
/** @typedef {{ x: number, y: number }} Spot px */

/** @param {number} v */
const short = (v) => Number(v.toPrecision(4));
const STEP = 1.05; // factor of a key

/**
 * The numbers of a section of which one root, or pair of roots, is moved.
 * @param {Section} section @param {boolean} isZero
 * @returns {(re: number, im: number) => number[]}
 */
function mover({ kind, values }, isZero) {
  /** @param {number} re @param {number} im */
  const omegaZeta = (re, im) => {
    const omega = Math.hypot(re, im);
    return [short(omega), short(-re / omega)];
  };
  if (kind === 'pole' || kind === 'zero') return (re) => [short(re)];
  if (kind === 'lead') return (re) => (isZero ? [short(re), values[1]] : [values[0], short(re)]);
  if (kind === 'notch')
    return (re, im) => {
      const [omega, zeta] = omegaZeta(re, im);
      return isZero ? [omega, zeta, values[2]] : [omega, values[1], zeta];
    };
  if (kind === 'delay') {
    const now = rootsOf({ kind, values }, roots).poles[0];
    return (re, im) => [short((values[0] * Math.hypot(now.re, now.im)) / Math.hypot(re, im)), values[1]];
  }
  return omegaZeta;
}

/** @param {Section[]} sections @returns {Grip[]} */
export const gripsOf = (sections) =>
  sections.flatMap((section, at) => {
    const { poles, zeros } = rootsOf(section, roots);
    /** @param {{ re: number, im: number }[]} all @param {boolean} isZero */
    const upper = (all, isZero) =>
      all
        .filter(({ im }) => im >= 0)
        .slice(0, section.kind === 'delay' ? 1 : 2)
        .map(({ re, im }) => ({
          section: at,
          kind: section.kind,
          isZero,
          re,
          im,
          set: mover(section, isZero),
        }));
    return [...upper(poles, false), ...(section.kind === 'delay' ? [] : upper(zeros, true))];
  });

export class Grips {
  /**
   * @param {HTMLElement} stage on which they lie
   * @param {{ view: () => View, spot: (grip: Grip, view: View) => Spot,
   *   moved: (grip: Grip, x: number, y: number) => [number, number], put: (section: number, values:
   * number[]) => void, drop: () => void }} place how a root and a place of the stage belong together
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
        const factor = STEP ** (right || up);
        if (right || im === 0) put(re * factor, im * factor);
        else put(re / factor, im);
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
      made.node.ariaLabel = `${label}${complex(re, im)} 1/s, ω ${number(Math.hypot(re, im), 3)} rad/s`;
    });
  }
}
