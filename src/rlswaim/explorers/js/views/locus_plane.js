// The root locus on the page: picture, window, tooltip, and a place for the keyboard on each pole.
import { contextOf } from '../drawing/canvas.js';
import { button, complex, element, number, press, set, symbol } from '../page/dom.js';
import { handleKeys, handlePointers, nearestOn, nearestPole } from '../page/pointer.js';
import { gainAt } from '../maths/gain_at.js';
import { rootLocus } from '../maths/locus.js';
import { drawLocus } from '../drawing/pole_pictures.js';
import { cameraOf, fitted, insetOf, windowOf, zoomed } from '../drawing/camera.js';

const KEYS_HELP =
  'Arrows step the running parameter, plus and minus zoom, 0 fits, Shift with arrows pans, Tab goes to the poles.';

export const MAGNIFY = [1, 3, 10, 100, 1000, 10000];

// What runs, with its unit, from where to where.
export function runText(system, name) {
  const unit = system.running[name]?.ends ? ' ft' : '';
  return (value) => `${number(value)}${unit}`;
}

const dampingOf = (x, y) => -x / Math.hypot(x, y);

export class LocusPlane {
  constructor(bench) {
    this.bench = bench;
    this.canvas = element('canvas', {
      role: 'application',
      tabindex: '0',
      'data-plane': 'locus',
      'aria-description': KEYS_HELP,
    });
    this.tip = element('div', { class: 'tip', role: 'tooltip', 'aria-live': 'off', hidden: true });
    this.spot = element('div', { class: 'spot', hidden: true });
    this.handles = [];
    this.keys = element('div', { class: 'handles' });
    this.title = element('b', {}, 'Root locus');
    this.range = element('span');
    this.now = element('small');
    const caption = element('figcaption', {}, element('span', {}, this.title, ', ', this.range), this.now);
    const stage = element(
      'div',
      { class: 'stage' },
      this.canvas,
      this.keys,
      this.spot,
      this.tip,
      this.#tools(),
    );
    this.node = element('figure', { class: 'locus' }, caption, stage);
    const acts = this.#acts();
    this.stop = handlePointers(this.canvas, acts);
    handleKeys(this.canvas, acts);
    handleKeys(this.keys, acts);
  }

  #tools() {
    const zoom = (factor) => () => {
      const view = this.#now();
      this.#move(zoomed(view, factor, view.frame.x + view.frame.w / 2, view.Y(Math.max(view.bottom, 0))));
    };
    this.lock = button(
      'Lock axes',
      () => this.#move(this.bench.desk.view.camera ? null : cameraOf(this.view)),
      {
        title: 'hold the window while sliders move',
        'aria-pressed': 'false',
      },
    );
    const nodes = [
      button('−', zoom(0.7), { 'aria-label': 'zoom out' }),
      button('+', zoom(1 / 0.7), { 'aria-label': 'zoom in' }),
      button('Fit', () => this.#move(null), { title: 'show all poles (double click)' }),
      this.lock,
    ];
    return element('div', { class: 'tools', role: 'group', 'aria-label': 'window' }, ...nodes);
  }

  #acts() {
    return {
      main: () => this.#now(),
      pole: (px, py, reach) => nearestPole(this.locus.present, this.#viewAt(px, py), px, py, reach),
      drag: (branch, px, py) => this.#drag(branch, px, py),
      dropped: () => this.bench.past.settle(),
      click: (px, py, reach) => this.#choose(px, py, reach),
      open: (branch) => this.#open(branch),
      hover: (px, py, reach) => this.#hover(px, py, reach),
      move: (camera) => this.#move(camera),
      fit: () => this.#move(null),
      step: (places) => this.#step(places),
    };
  }

  // The window as it will be drawn next: more than one move may come in a frame.
  #now() {
    const { camera } = this.bench.desk.view;
    return camera ? windowOf(camera, this.view.width, this.view.height) : this.view;
  }

  #viewAt(px, py) {
    return this.inset?.view.holds(px, py) ? this.inset.view : this.view;
  }

  #pointsAt(px, py) {
    return this.inset?.view.holds(px, py) ? this.inset.locus.branches : this.locus.branches;
  }

  #move(camera) {
    this.bench.look({ camera });
  }

  #step(places) {
    const { running } = this.bench.desk.what;
    this.bench.put(running, this.bench.desk.stepped(running, places));
  }

  #exact(point, x, y) {
    const { system, desk } = this.bench;
    return gainAt(system, desk.state, desk.what, point.branch, x, point.y < 0 ? -y : y, this.locus);
  }

  // Along its own branch, as near to the pointer as it gets.
  #drag(branch, px, py) {
    const view = this.#viewAt(px, py);
    const own = this.locus.branches.map(({ t, x, y }) => ({ t, x: [x[branch]], y: [y[branch]] }));
    const point = nearestOn(own, view, px, py, Infinity);
    this.#run(this.#exact({ ...point, branch }, view.re(px), Math.abs(view.im(py))));
  }

  #run(t) {
    const { desk } = this.bench;
    this.bench.put(desk.what.running, desk.place(desk.what.running, t));
  }

  #choose(px, py, reach) {
    const view = this.#viewAt(px, py);
    const point = nearestOn(this.#pointsAt(px, py), view, px, py, reach);
    if (point) this.#run(this.#exact(point, view.re(px), Math.abs(view.im(py))));
  }

  #open(branch) {
    const { x, y } = this.locus.present;
    this.bench.openMode(x[branch], y[branch]);
  }

  #hover(px, py, reach) {
    const view = px === undefined ? null : this.#viewAt(px, py);
    const point = view && nearestOn(this.#pointsAt(px, py), view, px, py, reach);
    this.tip.hidden = this.spot.hidden = !point;
    this.canvas.style.cursor = point ? 'pointer' : '';
    if (!point) return;
    if (nearestPole(this.locus.present, view, px, py, reach) >= 0) this.canvas.style.cursor = 'grab';
    this.#tell(point, view);
  }

  #tell({ branch, t, x, y }, view) {
    const { system, desk } = this.bench;
    const { running } = desk.what;
    const zeta = Math.hypot(x, y) ? ` · ζ ${number(dampingOf(x, y), 3)}` : '';
    this.tip.replaceChildren(
      element('b', {}, this.locus.open.branches[branch]),
      element('br'),
      ...symbol(running),
      ` ${runText(system, running)(t)} · ω ${number(Math.hypot(x, y), 3)} rad/s${zeta}`,
    );
    const [left, top] = [view.X(x), view.Y(Math.abs(y))];
    this.spot.style.transform = `translate(${left}px, ${top}px)`;
    const wide = this.tip.offsetWidth;
    const at = Math.min(Math.max(left + 12, 0), this.view.width - wide - 2);
    this.tip.style.transform = `translate(${at}px, ${Math.max(top - 52, 0)}px)`;
  }

  // Draws the present state, and returns what it traced.
  draw(width, height, closed) {
    const { system, desk, theme, model } = this.bench;
    const {
      state,
      what,
      view: { camera, printed },
    } = desk;
    this.view = camera ? windowOf(camera, width, height) : fitted(this.#worthSeeing(closed), width, height);
    this.locus = rootLocus(system, state, this.view, what);
    const magnify = model.get('magnify');
    this.inset = null;
    if (magnify > 1) {
      const view = insetOf(this.view, magnify);
      this.inset = { view, magnify, locus: rootLocus(system, state, view, what) };
    }
    this.extra = {
      printed: system.presets[printed]?.printed ?? [],
      selected: this.bench.selected(closed),
      inset: this.inset,
    };
    this.paint(contextOf(this.canvas, width, height));
    this.#place();
    this.#say(state, what, theme);
    return this.locus;
  }

  // The locus of a state in the present window, drawn where nobody sees it.
  rehearse(state) {
    const { system, desk, theme } = this.bench;
    this.spare ??= element('canvas');
    const g = contextOf(this.spare, this.view.width, this.view.height);
    drawLocus(g, this.view, theme, rootLocus(system, state, this.view, desk.what), this.extra);
  }

  paint(g, theme = this.bench.theme) {
    drawLocus(g, this.view, theme, this.locus, this.extra);
  }

  // The window must hold all poles.
  #worthSeeing(closed) {
    const { poles, presets } = this.bench.system;
    const printed = presets[this.bench.desk.view.printed]?.printed ?? [];
    return [...poles, ...printed]
      .map((p) => [p.re, p.im])
      .concat(Array.from(closed.x, (x, i) => [x, closed.y[i]]));
  }

  // Where the keyboard finds the poles: over their marks, above the axis.
  #place() {
    const { x, y } = this.locus.present;
    while (this.handles.length < x.length) {
      const branch = this.handles.length;
      const made = button('', () => this.#open(branch));
      this.keys.append(made);
      this.handles.push({ made });
    }
    this.handles.forEach((handle, i) => {
      const [px, py] = [this.view.X(x[i]), this.view.Y(y[i])];
      const hidden = !(i < x.length && y[i] >= 0 && this.view.holds(px, py));
      if (handle.hidden !== hidden) handle.made.hidden = handle.hidden = hidden;
      if (hidden || (handle.px === px && handle.py === py)) return;
      [handle.px, handle.py] = [px, py];
      handle.made.style.transform = `translate(${px.toFixed(1)}px, ${py.toFixed(1)}px)`;
    });
  }

  #say(state, { running, of, off = [], gain, name }) {
    const text = runText(this.bench.system, running);
    const still = off.filter((other) => other !== running);
    if (this.said !== this.bench.desk.view.locus) {
      this.said = this.bench.desk.view.locus;
      set(this.title, of === 'zeros' ? `Zeros of the loop in ${gain}` : 'Root locus');
    }
    const { from = 0, end } = this.locus;
    const range = `from ${text(from)} to ${text(end)}`;
    if (this.ranged !== running + range) {
      this.ranged = running + range;
      this.range.replaceChildren(...symbol(running), ` ${range}`);
    }
    const open = still.length ? `, with ${still.join(', ')} = 0` : '';
    set(
      this.now,
      `${name && name !== running ? `${name}: ` : ''}filled marks at ${running} = ${text(state[running])}${open}`,
    );
    press(this.lock, Boolean(this.bench.desk.view.camera));
  }

  // Words that may lag a little behind the picture.
  later(words) {
    const { running } = this.bench.desk.what;
    const { present, end, from = 0, open } = this.locus;
    const text = runText(this.bench.system, running);
    const value = text(this.bench.desk.state[running]);
    this.canvas.setAttribute(
      'aria-label',
      `Root locus in ${running} from ${text(from)} to ${text(end)}. At ${running} = ${value}: ${words}`,
    );
    this.handles.forEach(({ made, hidden }, i) => {
      if (hidden) return;
      const label = `${open.branches[i]} at ${complex(present.x[i], present.y[i])} 1/s, ${present.x[i] > 0 ? 'unstable' : 'stable'}; Enter shows its mode`;
      if (made.ariaLabel !== label) made.ariaLabel = label;
    });
  }
}
