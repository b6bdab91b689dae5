// Which part of the s plane is seen: fitted to the poles, or where wheel, fingers and keys have put it.

const MARGIN = { left: 44, right: 10, top: 8, bottom: 36 };
const LADDER = [1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.4, 8, 10];
const WIDTHS = [1e-7, 1e5]; // narrowest and widest window (1/s)
const BELOW = 0.07; // of the window's height, below the real axis

export function ladder(value, rungs = LADDER) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return decade * rungs.find((rung) => rung * decade >= value * (1 - 1e-12));
}

export function frameOf(width, height) {
  return {
    x: MARGIN.left,
    y: MARGIN.top,
    w: Math.max(width - MARGIN.left - MARGIN.right, 1),
    h: Math.max(height - MARGIN.top - MARGIN.bottom, 1),
  };
}

// The window whose lower left corner is at (left, bottom), in a frame of the picture.
export function windowAt(left, bottom, scale, frame, width, height) {
  return {
    left,
    bottom,
    right: left + frame.w / scale,
    top: bottom + frame.h / scale,
    scale,
    tolerance: 0.25,
    frame,
    width,
    height,
    X: (x) => frame.x + (x - left) * scale,
    Y: (y) => frame.y + frame.h - (y - bottom) * scale,
    re: (px) => left + (px - frame.x) / scale,
    im: (py) => bottom + (frame.y + frame.h - py) / scale,
    holds: (px, py) => px >= frame.x && px <= frame.x + frame.w && py >= frame.y && py <= frame.y + frame.h,
  };
}

// All given points, the borders on a ladder of round numbers so that they stand still while the points move a little.
export function fitted(points, width, height) {
  const frame = frameOf(width, height);
  const reach = (values) => 1.08 * values.reduce((most, v) => Math.max(most, v), 0);
  const want = [
    reach(points.map((p) => -p[0])),
    reach(points.map((p) => p[0])),
    reach(points.map((p) => Math.abs(p[1]))),
  ];
  const least = 0.4 * Math.max(...want, 1e-6);
  const [l, r, t] = want.map((v) => ladder(Math.max(v, least)));
  const scale = Math.min(frame.w / (l + r), frame.h / ((1 + BELOW) * t));
  const spare = frame.w / scale - l - r;
  return windowAt(-(l + (spare * l) / (l + r)), -BELOW * t, scale, frame, width, height);
}

// A window as state: center on the real axis, lower border and width, for any size of the picture.
export const cameraOf = ({ left, right, bottom }) => ({ x: (left + right) / 2, y: bottom, w: right - left });

export function windowOf({ x, y, w }, width, height) {
  const frame = frameOf(width, height);
  return windowAt(x - w / 2, y, frame.w / w, frame, width, height);
}

// Never below the real axis by more than a strip: what lies there mirrors the rest.
function kept(left, bottom, w, h) {
  return { x: left + w / 2, y: Math.max(bottom, -BELOW * h), w };
}

// Closer by a factor, the point under (px, py) staying where it is.
export function zoomed(view, factor, px, py) {
  const before = view.right - view.left;
  const w = Math.min(Math.max(before / factor, WIDTHS[0]), WIDTHS[1]);
  const part = w / before;
  const [x, y] = [view.re(px), view.im(py)];
  return kept(x - (x - view.left) * part, y - (y - view.bottom) * part, w, (view.top - view.bottom) * part);
}

export function panned(view, dx, dy) {
  return kept(
    view.left - dx / view.scale,
    view.bottom + dy / view.scale,
    view.right - view.left,
    view.top - view.bottom,
  );
}

// A small window in the upper left corner that shows the neighborhood of the origin `magnify` times enlarged.
export function insetOf(view, magnify) {
  const w = Math.round(0.4 * view.frame.w);
  const h = Math.round(0.46 * view.frame.h);
  const frame = { x: view.frame.x + 6, y: view.frame.y + 6, w, h };
  const scale = view.scale * magnify;
  return windowAt(-(0.62 * w) / scale, (-0.1 * h) / scale, scale, frame, view.width, view.height);
}
