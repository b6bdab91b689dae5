// Responses in time as small pictures side by side: one for each quantity, with axes and units.
import { multiples, write } from './canvas.js';
import { stepOf, tick } from './s_plane.js';

const ROW = 118;
const CHART = { left: 50, right: 8, top: 18, bottom: 20 };
const LETTER = { alpha: 'α', theta: 'θ', q1: 'q₁', q2: 'q₂', delta: 'δ', delta_r: 'δᵣ' };
const COLOR_OF = {
  alpha: 'attitude',
  theta: 'attitude',
  q1: 'mode 1',
  q2: 'mode 2',
  delta: 'actuator',
  delta_r: 'jet',
};

// Angles are told in degrees.
const scaleOf = (unit) => (unit === 'rad' ? [180 / Math.PI, '°'] : [1, unit]);

export const columnsOf = (width, count) => Math.min(count, Math.max(1, Math.floor(width / 220)));

export const heightOf = (width, count) => Math.ceil(count / columnsOf(width, count)) * ROW;

// A range of round numbers that holds all values and zero.
function rangeOf(values, factor) {
  let low = 0;
  let high = 0;
  for (const v of values) {
    if (v * factor < low) low = v * factor;
    if (v * factor > high) high = v * factor;
  }
  if (high - low < 1e-12) return [-1, 1, 1];
  const step = stepOf(high - low, ROW - CHART.top - CHART.bottom, 26);
  return [Math.floor(low / step + 1e-9) * step, Math.ceil(high / step - 1e-9) * step, step];
}

function curve(g, times, values, X, Y) {
  g.beginPath();
  for (let k = 0; k < times.length; k++) g[k ? 'lineTo' : 'moveTo'](X(times[k]), Y(values[k]));
}

function drawChart(g, theme, box, times, values, name, unit) {
  const [factor, shown] = scaleOf(unit);
  const [low, high, step] = rangeOf(values, factor);
  const end = times[times.length - 1];
  const [x0, y0] = [box.x + CHART.left, box.y + CHART.top];
  const [w, h] = [box.w - CHART.left - CHART.right, box.h - CHART.top - CHART.bottom];
  const X = (t) => x0 + (w * t) / end;
  const Y = (v) => y0 + (h * (high - v)) / (high - low);
  const every = stepOf(end, w, 60);
  g.fillStyle = theme.plane;
  g.fillRect(x0, y0, w, h);
  g.beginPath();
  for (const t of multiples(every, 0, end)) {
    g.moveTo(X(t), y0);
    g.lineTo(X(t), y0 + h);
  }
  for (const v of multiples(step, low, high)) {
    g.moveTo(x0, Y(v));
    g.lineTo(x0 + w, Y(v));
  }
  g.strokeStyle = theme.grid;
  g.lineWidth = 1;
  g.stroke();
  g.beginPath();
  g.moveTo(x0, Y(0));
  g.lineTo(x0 + w, Y(0));
  g.strokeStyle = theme.axis;
  g.stroke();
  for (const t of multiples(every, 0, end)) write(g, tick(t, every), X(t), y0 + h + 10, theme.muted);
  for (const v of multiples(step, low, high)) write(g, tick(v, step), x0 - 5, Y(v), theme.muted, 'right');
  write(g, `${LETTER[name] ?? name} (${shown})`, x0, y0 - 9, theme.ink, 'left');
  write(g, 't (s)', x0 + w, y0 - 9, theme.muted, 'right');
  curve(g, times, values, X, (v) => Y(v * factor));
  g.strokeStyle = theme.branch(COLOR_OF[name])?.color ?? theme.ink;
  g.lineWidth = 1.8;
  g.stroke();
}

export function drawResponses(g, width, height, theme, times, responses, units) {
  const names = Object.keys(responses);
  const columns = columnsOf(width, names.length);
  const w = width / columns;
  g.clearRect(0, 0, width, height);
  g.lineJoin = 'round';
  names.forEach((name, i) => {
    const box = { x: (i % columns) * w, y: Math.floor(i / columns) * ROW, w, h: ROW };
    drawChart(g, theme, box, times, responses[name], name, units[name]);
  });
}

// The largest and the last value of each response, in words.
export function responseWords(responses, units) {
  const text = ([name, values]) => {
    const [factor, unit] = scaleOf(units[name]);
    let most = 0;
    for (const v of values) if (Math.abs(v) > Math.abs(most)) most = v;
    const end = values[values.length - 1];
    return `${name}: largest ${(most * factor).toPrecision(3)} ${unit}, at the end ${(end * factor).toPrecision(3)} ${unit}`;
  };
  return Object.entries(responses).map(text).join('; ');
}
