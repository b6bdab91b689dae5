// The vehicle bent in a closed-loop mode, at one phase of its motion or at several.
import { multiples, write } from './canvas.js';

const BORDER = { left: 16, right: 16, top: 14, bottom: 24 };
const BODY = 7; // half the body's width on the picture
export const STILL = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => (k * Math.PI) / 8);

function deflected(shape, phase, k) {
  return shape.re[k] * Math.cos(phase) - shape.im[k] * Math.sin(phase);
}

function path(g, shape, X, Y, at, from, to) {
  for (let k = from; k <= to; k += 5) g[k === from ? 'moveTo' : 'lineTo'](X(k), Y(at(k)));
}

// The body as a band around its bent axis, pointed at the nose.
function body(g, X, Y, at, last) {
  const half = (k) => BODY * Math.min(1, 0.15 + k / 45);
  g.beginPath();
  g.moveTo(X(0), Y(at(0)));
  for (let k = 5; k <= last; k += 5) g.lineTo(X(k), Y(at(k)) - half(k));
  for (let k = last; k >= 5; k -= 5) g.lineTo(X(k), Y(at(k)) + half(k));
  g.closePath();
}

function scenery(g, theme, width, height, X, Y, last, marks) {
  g.beginPath();
  g.moveTo(X(0), Y(0));
  g.lineTo(X(last), Y(0));
  g.setLineDash([4, 4]);
  g.strokeStyle = theme.axis;
  g.lineWidth = 1;
  g.stroke();
  g.setLineDash([]);
  const every = width < 480 ? 100 : 50;
  for (const l of multiples(every, 0, last))
    write(
      g,
      `${l}${l === 0 ? ' ft (nose)' : ''}`,
      X(l),
      height - 8,
      theme.muted,
      l === 0 ? 'left' : 'center',
    );
  for (const { station, label } of marks) {
    g.beginPath();
    g.moveTo(X(station), Y(0) - 24);
    g.lineTo(X(station), Y(0) + 24);
    g.strokeStyle = theme.muted;
    g.stroke();
    write(g, label, X(station), BORDER.top - 5, theme.muted);
  }
}

// marks: [{ station, label }]; phases: one while it moves, several where it stands still.
export function drawBent(g, width, height, theme, color, shape, phases, marks) {
  const last = shape.re.length - 1;
  const X = (l) => BORDER.left + ((width - BORDER.left - BORDER.right) * l) / last;
  const middle = BORDER.top + (height - BORDER.top - BORDER.bottom) / 2;
  const reach = (height - BORDER.top - BORDER.bottom) / 2 - BODY - 4;
  const Y = (z) => middle + reach * z; // z is positive down, as in the report
  g.clearRect(0, 0, width, height);
  g.lineJoin = 'round';
  scenery(g, theme, width, height, X, Y, last, marks);
  for (const side of [1, -1]) {
    g.beginPath();
    path(g, shape, X, Y, (k) => side * Math.hypot(shape.re[k], shape.im[k]), 0, last);
    g.strokeStyle = theme.grid;
    g.lineWidth = 1.5;
    g.stroke();
  }
  phases.forEach((phase, i) => {
    g.globalAlpha = phases.length > 1 ? 1 - (0.85 * i) / phases.length : 1;
    body(g, X, Y, (k) => deflected(shape, phase, k), last);
    if (i === 0) {
      g.fillStyle = theme.plane;
      g.fill();
    }
    g.strokeStyle = color;
    g.lineWidth = i === 0 ? 2 : 1;
    g.stroke();
  });
  g.globalAlpha = 1;
}
