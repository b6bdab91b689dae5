// The least peak of the sensitivity over the station of a gyro, and the poles and zeros that set it.
import { contextOf } from '../drawing/context.js';
import { cross, label, line, mark, ring } from '../drawing/marks.js';
import { complex, number } from '../drawing/numbers.js';
import { Plane } from '../drawing/plane.js';
import { sPlane } from '../drawing/s_plane.js';
import { frameOf, viewOf } from '../drawing/view.js';
import { bound, overBand } from '../maths/peak_bound.js';
import { element, legend, picture, set } from '../page/elements.js';
import { ValueTable } from '../page/value_table.js';
import { simple } from './simple_view.js';

/** @import { Theme, Values } from '../types.d.ts' */
/** @import { Layer } from '../drawing/plane.js' */
/** @import { Lifecycle } from '../page/lifecycle.js' */
/** @import { Bound } from '../maths/peak_bound.js' */

const STEP = 3; // ft between two points of the curve
const LENGTH = 420; // ft
const DECADES = [1, 10, 100, 1000];
const TITLE = 'Least peak of the sensitivity';

/** @param {number} value */
const log = (value) => Math.log10(Math.min(Math.max(value, 1), 1e4));

/** Lines and numbers at the decades. @param {Theme} theme @returns {Layer[]} */
const decades = (theme) =>
  DECADES.flatMap((size) => [
    line([[0, log(size)], [LENGTH, log(size)]], theme.grid, 1), // biome-ignore format: two points
    label(String(size), 0, log(size), 6, -7, theme.muted, 'left'),
  ]);

class PeakBound {
  /** @param {any} payload */
  constructor(payload) {
    this.payload = payload;
    this.words = element('p', { class: 'verdict' });
    this.table = new ValueTable('What bounds the loop', ['', 'here']);
    const curve = picture('bound', {}, element('b', {}, TITLE), ' over the station of gyro a');
    const plane = picture('zeros', {}, element('b', {}, 'Right half of the s plane'));
    this.canvases = [curve.canvas, plane.canvas];
    this.key = '';
    /** @type {number[][]} */
    this.curve = [];
    this.nodes = [
      this.words,
      element('div', { class: 'planes' }, curve.figure, plane.figure),
      legend([
        ['━', 'bound for any controller'],
        ['┄', 'a peak of 2, as is usually asked for'],
        ['●', 'this station'],
        ['×', 'pole of the vehicle'],
        ['○', 'zero of what is measured'],
      ]),
      this.table.node,
    ];
  }

  /** The curve stays while the gyro runs along it. @param {Values} values */
  #curveAt(values) {
    const { gravity, gyro_b, share } = values;
    const key = `${gravity} ${gyro_b} ${share}`;
    if (this.key !== key) {
      this.key = key;
      this.curve = Array.from({ length: LENGTH / STEP + 1 }, (_, k) => {
        const at = k * STEP;
        return [at, log(bound(this.payload, { ...values, gyro_a: at }).peak)];
      });
    }
    return this.curve;
  }

  /** @param {Values} values @param {Bound} found @param {Lifecycle} page */
  #drawCurve(values, found, page) {
    const { theme } = page;
    const [canvas] = this.canvases;
    const [width, height] = page.sizeOf(canvas);
    const view = viewOf([0, LENGTH], [0, 4], frameOf(width, height), width, height);
    const asked = [[0, log(2)], [LENGTH, log(2)]]; // biome-ignore format: two points
    const layers = [
      ...decades(theme),
      line(asked, theme.color('corrected'), 1.5, [4, 4]),
      line(this.#curveAt(values), theme.color('rigid')),
      mark('●', values.gyro_a, log(found.peak), theme.color('rigid')),
    ];
    new Plane(contextOf(canvas, width, height), view, theme).chart(
      'station of gyro a (ft)',
      '',
      layers,
      true,
    );
    canvas.ariaLabel = `${TITLE} over the station: ${number(found.peak)} at ${values.gyro_a} ft.`;
  }

  /** @param {Bound} found @param {Lifecycle} page */
  #drawPlane({ poles, zeros }, page) {
    const { theme } = page;
    const canvas = this.canvases[1];
    const [width, height] = page.sizeOf(canvas);
    const view = viewOf([-0.4, 3.2], [-0.2, 2.6], frameOf(width, height), width, height);
    const marks = [
      ...zeros.x.map((x, i) => ring(x, Math.abs(zeros.y[i]), 6, 2, { color: theme.color('mode 1') })),
      ...poles.map((p) => cross(p, 0, theme.color('rigid'))),
    ];
    sPlane(contextOf(canvas, width, height), view, theme, ...marks);
    const told = poles.map((p) => number(p)).join(', ');
    canvas.ariaLabel = `Poles right of the axis: ${told}; ${this.#zeros(zeros)}`;
  }

  /** @param {Bound['zeros']} zeros */
  #zeros({ x, y }) {
    const upper = x.map((re, i) => [re, y[i]]).filter(([, im]) => im >= 0);
    const told = upper.map(([re, im]) => (im ? complex(re, im).replace('+', '±') : number(re)));
    return told.length ? `zeros: ${told.join(', ')}` : 'no zero';
  }

  /** @param {Values} values @param {Bound} found */
  #tell({ bandwidth }, { poles, zeros, peak, interlaced }) {
    const band = overBand(poles, bandwidth);
    const rows = [
      ['poles right of the axis (1/s)', poles.map((p) => number(p)).join(', '), 'poles', ''],
      ['zeros right of the axis (1/s)', this.#zeros(zeros).replace('zeros: ', ''), 'zeros', ''],
      ['least peak of the sensitivity', number(peak), 'peak', peak],
      [`least peak with ${number(bandwidth)} rad/s at hand`, number(Math.max(band, peak)), 'band', band],
      ['a stable controller', interlaced ? 'may do it' : 'cannot do it', 'interlaced', interlaced],
    ];
    this.table.show(
      rows.map(([name, text, key, value]) => ({
        cells: [String(name), String(text)],
        data: { quantity: key, value },
      })),
    );
  }

  /** @param {Values} values @param {Lifecycle} page */
  draw(values, page) {
    const found = bound(this.payload, values);
    this.#drawCurve(values, found, page);
    this.#drawPlane(found, page);
    this.#tell(values, found);
    const can = found.interlaced
      ? 'A stable controller may stabilize it'
      : 'No stable controller stabilizes it';
    const said = `${can}; every loop has a sensitivity of at least ${number(found.peak)} somewhere.`;
    set(this.words, said);
    return said;
  }
}

export const render = simple(PeakBound);
