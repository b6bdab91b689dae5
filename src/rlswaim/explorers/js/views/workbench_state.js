// The state under the reader's hands: the parameters (the model's) and what is looked at (the view's own).

const DEGREE = Math.PI / 180;
const ANGLES = { alpha: 'α', theta: 'θ' };
const FEET = { q1: 'q₁', q2: 'q₂' };
export const DURATIONS = [1, 2, 5, 10, 20, 50, 100, 200, 500];
export const GUSTS = [0.2, 0.5, 1, 2, 5, 10];

// What the loop can be excited with: a step, a gust, or one coordinate displaced at the start.
export function inputsOf({ numerators }) {
  return Object.keys(numerators).map((input) => {
    const name = input.replace('(0)', '');
    if (input === 'theta_c') return { input, kind: 'step', amplitude: DEGREE, text: 'step of 1° in θ_c' };
    if (input === 'alpha_g')
      return { input, kind: 'gust', amplitude: DEGREE, text: '1 − cos gust of 1° in α_g' };
    if (FEET[name])
      return { input, kind: 'initial', amplitude: 1, text: `${FEET[name]} of 1 ft at the start` };
    return { input, kind: 'initial', amplitude: DEGREE, text: `${ANGLES[name] ?? name} of 1° at the start` };
  });
}

// The loci that can be drawn: the report's own, then one for each slider.
export function lociOf({ loci, running }) {
  const own = loci.map((what) => ({ key: what.name, text: what.name, what }));
  const rest = Object.keys(running).map((name) => ({
    key: name,
    text: name,
    what: { running: name, off: [], of: 'poles' },
  }));
  return [...own, ...rest];
}

const START = { map: 0, camera: null, input: 0, duration: 5, gust: 2 };

export class Desk {
  constructor(model) {
    this.model = model;
    this.system = model.get('payload');
    this.loci = lociOf(this.system);
    this.inputs = inputsOf(this.system);
    this.names = this.system.parameters.map(({ name }) => name);
    const fresh = this.system.presets.findIndex((p) => this.#same(p.values, this.system.initial));
    const mode = this.system.poles.findIndex((p) => p.branch === 'mode 1' && p.im > 0);
    this.start = {
      ...START,
      locus: fresh < 0 ? this.loci[0].key : this.locusOf(fresh),
      printed: fresh,
      mode,
    };
    this.view = { ...this.start };
  }

  #same(values, state) {
    return Object.entries(values).every(([name, value]) => state[name] === value);
  }

  locusOf(preset) {
    return this.loci[this.system.presets[preset].locus ?? 0].key;
  }

  get state() {
    return Object.fromEntries(this.names.map((name) => [name, this.model.get(name)]));
  }

  get what() {
    return this.loci.find(({ key }) => key === this.view.locus).what;
  }

  get station() {
    return this.system.maps[this.view.map];
  }

  get response() {
    const { kind, input, amplitude } = this.inputs[this.view.input];
    return { kind, input, amplitude, duration: this.view.gust };
  }

  // Is this the design of the report that the parameters are at? Of two with the same gains, the one that was chosen.
  isDesign(preset) {
    const { printed } = this.view;
    const at = (i) => this.#same(this.system.presets[i].values, this.state);
    return at(preset) && (printed === preset || printed < 0 || !at(printed));
  }

  set(values, view = {}) {
    Object.assign(this.view, view);
    for (const [name, value] of Object.entries(values)) this.model.set(name, value);
    this.model.save_changes();
  }

  // A value as its slider may take it: whole where the places are whole, else with five digits.
  place(name, value) {
    const { grid } = this.system.parameters.find((p) => p.name === name);
    if (!grid.every(Number.isInteger)) return Number(value.toPrecision(5));
    return Math.min(Math.max(Math.round(value), grid[0]), grid.at(-1));
  }

  // The place of the slider some places on from a value.
  stepped(name, places) {
    const { grid } = this.system.parameters.find((p) => p.name === name);
    const value = this.model.get(name);
    const next = places > 0 ? grid.findIndex((g) => g > value) : grid.findLastIndex((g) => g < value);
    if (next < 0) return value;
    return grid[Math.min(Math.max(next + places - Math.sign(places), 0), grid.length - 1)];
  }

  reset() {
    this.view = { ...this.start };
    this.set({ ...this.system.initial, magnify: this.system.magnify ?? 1 });
  }

  snapshot() {
    return JSON.stringify([this.state, { ...this.view, camera: null }, this.model.get('magnify')]);
  }

  restore(snapshot) {
    const [state, view, magnify] = JSON.parse(snapshot);
    this.set({ ...state, magnify }, { ...view, camera: this.view.camera });
  }

  // What differs from the start, as texts for the page's address.
  toAddress() {
    const { state, view, start } = this;
    const { initial } = this.system;
    const moved = this.names.some((name) => state[name] !== initial[name]);
    const all = moved ? this.names.map((name) => [name, state[name]]) : [];
    for (const name of Object.keys(start))
      if (name !== 'camera' && view[name] !== start[name]) all.push([`view.${name}`, view[name]]);
    const { camera } = view;
    if (camera)
      all.push([
        'view.window',
        [camera.x, camera.y, camera.w].map((v) => Number(v.toPrecision(6))).join('_'),
      ]);
    const magnify = this.model.get('magnify');
    if (magnify !== (this.system.magnify ?? 1)) all.push(['view.magnify', magnify]);
    return Object.fromEntries(all);
  }

  // What an address says, as far as it makes sense; the rest stays as it is.
  fromAddress(texts) {
    const values = {};
    for (const { name, grid } of this.system.parameters) {
      const text = texts[name];
      if (text === undefined) continue;
      if (typeof grid[0] === 'string') grid.includes(text) && (values[name] = text);
      else if (text.trim() !== '' && Number.isFinite(Number(text)) && this.#allowed(grid, Number(text)))
        values[name] = Number(text);
    }
    const magnify = Number(texts['view.magnify']);
    if (magnify >= 1 && magnify <= 1e6) values.magnify = magnify;
    this.set(values, this.#viewFrom(texts));
  }

  #allowed(grid, value) {
    return (
      !grid.every(Number.isInteger) || (Number.isInteger(value) && value >= grid[0] && value <= grid.at(-1))
    );
  }

  #viewFrom(texts) {
    const view = {};
    const locus = texts['view.locus'];
    if (this.loci.some(({ key }) => key === locus)) view.locus = locus;
    const places = {
      map: this.system.maps,
      input: this.inputs,
      printed: this.system.presets,
      mode: { length: 99 },
    };
    for (const [name, { length }] of Object.entries(places)) {
      const at = Number(texts[`view.${name}`] ?? NaN);
      if (Number.isInteger(at) && at >= (name === 'printed' ? -1 : 0) && at < length) view[name] = at;
    }
    if (DURATIONS.includes(Number(texts['view.duration']))) view.duration = Number(texts['view.duration']);
    if (GUSTS.includes(Number(texts['view.gust']))) view.gust = Number(texts['view.gust']);
    const [x, y, w] = (texts['view.window'] ?? '').split('_').map(Number);
    if (Number.isFinite(x) && Number.isFinite(y) && w > 0) view.camera = { x, y, w };
    return view;
  }
}
