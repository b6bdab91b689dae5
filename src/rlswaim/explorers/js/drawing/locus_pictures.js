// The two pictures of the s plane: the root locus, and the map of the poles over a station.
import { branches, crosses, crossing, directions, poles } from './locus_marks.js';
import { dot, label, plus, ring, specks } from './marks.js';
import { originInset, sPlane } from './s_plane.js';
import { zPlane } from './z_plane.js';

/** @import { Graphics, Locus, NamedRoots, Point, Pole, Roots, Theme, View } from '../types.d.ts' */
/** @import { Layer } from './plane.js' */
/**
 * @typedef {{ printed: Pole[], selected: Pole, inset: { view: View, locus: Locus, magnify: number },
 *   region?: Layer, cloud?: Roots[], discrete?: boolean }} Extra cloud: the poles of dispersed vehicles;
 *   discrete: roots in z, not in s
 */

const NOTHING = () => {};

/** @param {Locus} locus @param {Theme} theme @param {Extra} extra @returns {Layer[]} */
function marksOf(locus, theme, { printed, selected, region = NOTHING, cloud = [], discrete }) {
  const names = locus.open.branches;
  return [
    region,
    branches(locus.branches, names),
    directions(locus.branches, names),
    ...locus.breaks.map(({ x, y }) => dot(x, Math.abs(y), theme.ink)),
    ...Array.from(locus.zeros.x, (x, i) =>
      ring(x, Math.abs(locus.zeros.y[i]), 5, 1.6, { inside: theme.plane }),
    ),
    crosses(locus.open),
    specks(cloud),
    ...locus.crossings.map((c) => crossing(c, discrete)),
    poles(locus.present, names),
    ...printed.map(({ re, im }) => plus(re, Math.abs(im), 8)),
    ...(selected ? [ring(selected.re, Math.abs(selected.im), 11)] : []),
  ];
}

/**
 * @param {Graphics} g @param {View} view @param {Theme} theme @param {Locus} locus
 * @param {Extra} extra roots printed in the report, the pole selected, a small window about the origin
 */
export function drawLocus(g, view, theme, locus, extra) {
  (extra.discrete ? zPlane : sPlane)(g, view, theme, ...marksOf(locus, theme, extra));
  if (!extra.inset) return;
  const { view: inner, locus: small, magnify } = extra.inset;
  originInset(g, inner, theme, magnify, ...marksOf(small, theme, extra));
}

/**
 * @param {Graphics} g @param {View} view @param {Theme} theme
 * @param {NamedRoots} present the poles where the station is
 * @param {Point[][]} sides traced from there to both ends
 * @param {{ unit: string, every?: number }} running a dot stands at every so many of its unit
 */
export function drawMap(g, view, theme, present, sides, { unit, every = 100 }) {
  const names = present.branches;
  /** @param {Point} p @param {(i: number, y: number) => Layer} layer */
  const upper = (p, layer) => Array.from(p.y, (y, i) => (y >= 0 ? layer(i, y) : () => {}));
  const hundreds = sides.flat().filter(({ t }) => t % every === 0);
  /** @param {Point} end @param {number} i */
  const moved = (end, i) => Math.hypot(end.x[i] - present.x[i], end.y[i] - present.y[i]) * view.scale;
  const ends = sides.map((side) => side.at(-1));
  sPlane(
    g,
    view,
    theme,
    ...sides.map((side) => branches(side, names)),
    ...hundreds.flatMap((p) => upper(p, (i, y) => dot(p.x[i], y, theme.color(names[i])))),
    ...ends.flatMap((end) =>
      upper(end, (i, y) =>
        moved(end, i) > 14 ? label(`${end.t} ${unit}`, end.x[i], y, 6, -8, theme.muted, 'left') : () => {},
      ),
    ),
    poles(present, names),
  );
}
