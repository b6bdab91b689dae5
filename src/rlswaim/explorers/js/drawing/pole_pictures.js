// The two pictures of the s plane: the root locus, and the map of the poles over a station.
import { Picture } from './s_plane.js';

function locusIn(picture, locus, extra) {
  const { theme } = picture;
  const names = locus.open.branches;
  picture.branches(locus.branches, names, 2);
  picture.arrows(locus.branches, names, 110);
  for (const { x, y } of locus.breaks) picture.dot(x, y, theme.ink);
  picture.zeros(locus.zeros);
  picture.crosses(locus.open);
  for (const crossing of locus.crossings) picture.crossing(crossing);
  picture.poles(locus.present, names);
  picture.printed(extra.printed);
  if (extra.selected) picture.ring(extra.selected.re, extra.selected.im, 11, 1.6);
}

// extra: { printed roots, selected pole, inset: { view, locus, magnify } }
export function drawLocus(g, view, theme, locus, extra) {
  const picture = new Picture(g, view, theme);
  picture.background();
  locusIn(picture, locus, extra);
  picture.finish();
  if (!extra.inset) return;
  const inset = new Picture(g, extra.inset.view, theme);
  inset.backgroundOfInset(extra.inset.magnify);
  locusIn(inset, extra.inset.locus, extra);
  inset.finish();
  inset.border();
}

export function drawMap(g, view, theme, present, names, sides, unit) {
  const picture = new Picture(g, view, theme);
  picture.background();
  for (const side of sides) picture.branches(side, names, 2);
  for (const side of sides) {
    for (const p of side) {
      if (p.t % 100 === 0)
        names.forEach((name, i) => p.y[i] >= 0 && picture.dot(p.x[i], p.y[i], theme.branch(name).color));
    }
  }
  for (const side of sides) {
    const end = side.at(-1);
    names.forEach((name, i) => {
      const moved = Math.hypot(end.x[i] - present.x[i], end.y[i] - present.y[i]) * view.scale;
      if (end.y[i] >= 0 && moved > 14)
        picture.text(`${end.t} ${unit}`, view.X(end.x[i]) + 6, view.Y(end.y[i]) - 8, theme.muted, 'left');
    });
  }
  picture.poles(present, names);
  picture.finish();
}
