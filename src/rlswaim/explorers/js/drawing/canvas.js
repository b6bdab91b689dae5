// What every drawing starts from: a canvas in CSS pixels, words, shapes, places of round numbers.

export const FONT = '11px system-ui, sans-serif';

const prepared = new WeakSet();

// A canvas's context, one unit a CSS pixel. Its font is set with its size alone: that is slow.
export function contextOf(canvas, width, height) {
  const ratio = globalThis.devicePixelRatio || 1;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  const g = canvas.getContext('2d');
  if (!prepared.has(canvas) || canvas.width !== w || canvas.height !== h) {
    [canvas.width, canvas.height] = [w, h];
    g.font = FONT;
    prepared.add(canvas);
  }
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  return g;
}

export function write(g, words, x, y, color, align = 'center', halo = undefined) {
  g.textAlign = align;
  g.textBaseline = 'middle';
  if (halo) {
    g.strokeStyle = halo;
    g.lineWidth = 3;
    g.strokeText(words, x, y);
  }
  g.fillStyle = color;
  g.fillText(words, x, y);
}

export function multiples(step, from, to) {
  const first = Math.ceil(from / step - 1e-9);
  return Array.from(
    { length: Math.max(0, Math.floor(to / step + 1e-9) - first + 1) },
    (_, k) => (first + k) * step,
  );
}

export function polygon(g, points) {
  for (let k = 0; k < points.length; k += 2) g[k ? 'lineTo' : 'moveTo'](points[k], points[k + 1]);
  g.closePath();
}
