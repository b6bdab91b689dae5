// The map over sensor and jet stations: computed beside the page, coarse first, drawn as it comes.
import { STATIONS, STEPS, abscissaAt, planOf, rootsAt, rows } from '../maths/abscissa.js';
import { element, set } from '../page/dom.js';
import { Table, apply, legend, mount, number, plane, signed } from '../page/live_view.js';
import { Plot } from '../drawing/plot.js';
import { initialize } from '../page/sliders.js';

const STATIONS_OF = ['sensor', 'jet'];
const FINE = 0.002; // 1/s: the scale is straight below and logarithmic above
const ENDS = 10;
const TICKS = [-10, -1, -0.1, 0, 0.1, 1, 10];

// Place of a value on the scale, from 0 to 1.
const share = (value) =>
  Math.max(0, Math.min(1, 0.5 + (0.5 * Math.asinh(value / FINE)) / Math.asinh(ENDS / FINE)));

// Rows of the map from a worker made of the same scripts, or in short turns on the page where no worker may start.
function calculator(code, receive) {
  let id = 0;
  let worker = null;
  let latest = null;
  function here() {
    const mine = id;
    const left = rows(latest);
    const turn = () => {
      if (mine !== id) return;
      const until = performance.now() + 4;
      const found = [];
      let next = { done: false };
      while (!next.done && performance.now() < until) {
        next = left.next();
        if (!next.done) found.push(next.value);
      }
      receive(found);
      if (!next.done) setTimeout(turn);
    };
    turn();
  }
  try {
    const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
    worker = new Worker(address, { type: 'module' });
    worker.onmessage = ({ data }) => data.id === id && receive(data.rows);
    worker.onerror = () => {
      worker = null;
      if (latest) here();
    };
  } catch {
    worker = null;
  }
  return {
    start(plan) {
      id += 1;
      latest = plan;
      if (worker) worker.postMessage({ id, plan });
      else here();
    },
    halt() {
      id += 1; // what still comes of the last plan is not taken
    },
    stop() {
      id += 1;
      worker?.terminate();
    },
  };
}

function render({ model, el }) {
  const payload = model.get('payload');
  const gains = payload.parameters.map(({ name }) => name).filter((name) => !STATIONS_OF.includes(name));
  const palette = payload.palette.map(
    (hex) => Number.parseInt(hex.slice(5) + hex.slice(3, 5) + hex.slice(1, 3), 16) | 0xff000000,
  );
  let [plan, key, started, cursor] = [null, '', false, null];
  let pictures = []; // of the last fineness that is whole, and of the one that comes in
  let last = null; // the last fineness that is whole

  const { canvas, figure } = plane(
    'stations',
    [element('b', {}, 'Largest real part of all poles'), ' (1/s) for every sensor and jet'],
    { tabindex: '0', role: 'application' },
  );
  const scale = plane('scale', 'color of the map (1/s): below zero all poles decay');
  const words = element('p', { class: 'verdict' });
  const word = element('b');
  const rest = element('span');
  const progress = element('p', { class: 'crossings' });
  words.append(word, rest);
  const table = new Table('The pairs of Table 3 at these gains', [
    'case',
    'sensor (ft)',
    'jet (ft)',
    'largest real part (1/s)',
    'stable',
  ]);
  const signs = legend([
    ['✚', 'the pair chosen'],
    ['○', 'pairs of Table 3'],
    ['━', 'zero: stable within'],
    ['◌', 'the keyboard’s mark: arrow keys move it (with Shift ten feet), Enter picks'],
  ]);

  // A picture of one fineness: a pixel for each pair, see-through where it has not come yet. Two of each serve in turn.
  const made = new Map();
  function pictureOf(step) {
    const side = Math.ceil(STATIONS / step);
    const [old, idle] = made.get(step) ?? [];
    const canvas = idle?.canvas ?? element('canvas', { width: side, height: side });
    const g = idle?.g ?? canvas.getContext('2d', { willReadFrequently: true }); // a canvas in plain memory: rows go in fast
    const line = idle?.line ?? g.createImageData(side, 1);
    g.clearRect(0, 0, side, side);
    const picture = { step, side, canvas, g, line };
    made.set(step, [picture, old]);
    return picture;
  }

  function paint({ step, jet, values }) {
    if (pictures.at(-1)?.step !== step) pictures = [...pictures.slice(-1), pictureOf(step)];
    const { side, g, line } = pictures.at(-1);
    const pixels = new Int32Array(line.data.buffer);
    values.forEach((value, n) => (pixels[n] = palette[Math.round(share(value) * (palette.length - 1))]));
    g.putImageData(line, 0, side - 1 - jet / step);
  }

  function receive(found) {
    for (const part of found) {
      if (part.pairs) showPairs(part.pairs);
      else if (part.line) last = part;
      else paint(part);
    }
    view.redraw();
  }

  function showPairs(values) {
    table.show(
      payload.pairs.map(({ case: at, sensor, jet }, i) => ({
        cells: [
          at,
          sensor,
          jet,
          signed(values[i]),
          values[i] < 0 ? 'yes' : values[i] > 0 ? 'no' : 'neutral',
        ].map(String),
        data: { case: at, value: values[i] },
      })),
    );
  }
  const machine = calculator(MAP_WORKER, receive);

  function restart(state, seen) {
    const now = JSON.stringify(gains.map((name) => state[name]));
    if (now !== key) {
      key = now;
      plan = planOf(payload, Object.fromEntries(gains.map((name) => [name, state[name]])));
      [pictures, last, started] = [pictures.slice(-1), null, false];
      machine.halt();
    }
    if (seen && !started) machine.start(plan);
    started ||= seen;
  }

  function drawMap(state, theme) {
    const plot = new Plot(canvas, theme, {
      x: [-0.5, 420.5],
      y: [-0.5, 420.5],
      xLabel: 'station of the sensor (ft)',
      yLabel: 'station of the jet (ft)',
    }).axes();
    const { g } = plot;
    g.imageSmoothingEnabled = false;
    for (const { step, side, canvas: cells } of pictures) {
      g.drawImage(
        cells,
        plot.X(-0.5),
        plot.Y(step * side - 0.5),
        step * side * plot.sx,
        step * side * plot.sy,
      );
    }
    g.beginPath();
    const line = last?.line ?? [];
    for (let k = 0; k < line.length; k += 4) {
      g.moveTo(plot.X(line[k]), plot.Y(line[k + 1]));
      g.lineTo(plot.X(line[k + 2]), plot.Y(line[k + 3]));
    }
    g.strokeStyle = '#000';
    g.lineWidth = 1.5;
    g.stroke();
    const ring = (sensor, jet, radius, color, width) => {
      g.beginPath();
      g.arc(plot.X(sensor), plot.Y(jet), radius, 0, 2 * Math.PI);
      g.strokeStyle = color;
      g.lineWidth = width;
      g.stroke();
    };
    for (const { sensor, jet } of payload.pairs) {
      ring(sensor, jet, 4, '#fff', 3);
      ring(sensor, jet, 4, '#000', 1.3);
    }
    const [x, y] = [plot.X(state.sensor), plot.Y(state.jet)];
    for (const [color, width] of [
      ['#fff', 5],
      ['#000', 2],
    ]) {
      g.strokeStyle = color;
      g.lineWidth = width;
      g.beginPath();
      g.moveTo(x - 10, y);
      g.lineTo(x + 10, y);
      g.moveTo(x, y - 10);
      g.lineTo(x, y + 10);
      g.stroke();
    }
    if (cursor) {
      g.setLineDash([3, 3]);
      ring(cursor.sensor, cursor.jet, 9, '#fff', 4);
      ring(cursor.sensor, cursor.jet, 9, '#000', 2);
      g.setLineDash([]);
    }
    plot.finish();
    return plot;
  }

  function drawScale(theme) {
    const plot = new Plot(scale.canvas, theme, { x: [0, 1], y: [0, 1], bare: true });
    const { g } = plot;
    payload.palette.forEach((color, k) => {
      g.fillStyle = color;
      const width = (plot.width - 16) / payload.palette.length;
      g.fillRect(8 + k * width, 0, width + 1, 12);
    });
    for (const tick of TICKS)
      plot.text(
        signed(tick, 1),
        8 + share(tick) * (plot.width - 16),
        20,
        theme.muted,
        tick === -ENDS ? 'left' : tick === ENDS ? 'right' : 'center',
        false,
      );
  }

  let plot;
  function draw(state, theme, seen) {
    restart(state, seen);
    plot = drawMap(state, theme);
    drawScale(theme);
    const pair = rootsAt(plan, state.sensor, state.jet);
    const value = abscissaAt(plan, state.sensor, state.jet);
    const right = value > 0 ? pair.x.filter((x) => x > 0).length : 0;
    word.className = value > 0 ? 'unstable' : 'stable';
    set(word, value < 0 ? 'Stable' : value > 0 ? 'Unstable' : 'Neutral');
    const why = `: with the sensor at ${number(state.sensor)} ft and the jet at ${number(state.jet)} ft the largest real part is ${signed(value)} 1/s${right ? `; ${right} of 9 poles lie right of the axis` : ''}.`;
    set(rest, why);
    Object.assign(words.dataset, { value });
    const complete = last?.step === 1;
    set(
      progress,
      complete
        ? `All ${(STATIONS * STATIONS).toLocaleString('en')} pairs at one foot: ${last.stable.toLocaleString('en')} stable${last.neutral ? `, ${last.neutral.toLocaleString('en')} neutral, with a root at zero and none right of it` : ''}.`
        : `Computing: every ${pictures.at(-1)?.step ?? STEPS[0]} ft …`,
    );
    el.dataset.step = complete ? 'complete' : String(last?.step ?? 0);
    const there = cursor
      ? ` The mark is at sensor ${cursor.sensor} ft, jet ${cursor.jet} ft: ${signed(abscissaAt(plan, cursor.sensor, cursor.jet))} 1/s.`
      : '';
    canvas.setAttribute(
      'aria-label',
      `Map of the largest real part over sensor and jet stations. ${word.textContent}${why} Arrow keys move a mark, Enter picks its pair.${there}`,
    );
    scale.canvas.setAttribute(
      'aria-label',
      'Color scale from −10 to +10 1/s, purple below zero, orange above',
    );
    return cursor ? there.trim() : `${word.textContent}${why}`;
  }

  const within = (value) => Math.max(0, Math.min(STATIONS - 1, Math.round(value)));
  canvas.addEventListener('click', ({ offsetX, offsetY }) => {
    if (!plot) return;
    cursor = null;
    apply(model, {
      sensor: within(plot.x[0] + (offsetX - plot.pad.left) / plot.sx),
      jet: within(plot.y[0] + (plot.height - plot.pad.bottom - offsetY) / plot.sy),
    });
    view.redraw();
  });
  const MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  canvas.addEventListener('keydown', (event) => {
    const move = MOVES[event.key];
    if (move) {
      const by = event.shiftKey ? 10 : 1;
      cursor ??= { sensor: model.get('sensor'), jet: model.get('jet') };
      cursor = { sensor: within(cursor.sensor + by * move[0]), jet: within(cursor.jet + by * move[1]) };
    } else if ((event.key === 'Enter' || event.key === ' ') && cursor) {
      apply(model, cursor);
      cursor = null;
    } else if (event.key === 'Escape') cursor = null;
    else return;
    event.preventDefault();
    view.redraw();
  });
  canvas.addEventListener('blur', () => {
    cursor = null;
    view.redraw();
  });

  const view = {
    nodes: [words, figure, scale.figure, progress, signs, table.node],
    canvases: [canvas, scale.canvas],
    draw,
    stop: machine.stop,
  };
  return mount({ model, el }, view);
}

export default { initialize, render };
