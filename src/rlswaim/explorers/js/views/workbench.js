// The workbench: parameters in; pictures, table and words out. The same state always gives the same picture.
import { inLab, nameOf, readAddress, writeAddress } from '../page/address.js';
import { Desk } from './workbench_state.js';
import {
  Drawing,
  button,
  buttons,
  element,
  onThemeChange,
  panel,
  press,
  select,
  set,
  symbol,
  themeOf,
} from '../page/dom.js';
import { copy, download, pythonOf, svgOf } from '../page/take_away.js';
import { History, onUndoKeys, undoButtons } from '../page/undo.js';
import { closedLoop } from '../maths/closed_loop.js';
import { margins } from '../maths/margins.js';
import { LocusPlane, MAGNIFY } from './locus_plane.js';
import { ModePanel } from './mode_panel.js';
import { helpPanel, legend, MapPanel, ResponsePanel } from './panels.js';
import { practise } from '../page/rehearsal.js';
import { PoleTable, polesAsText } from '../page/pole_table.js';
import { crossingWords, marginWords, printedWords, verdict } from '../page/verdict_words.js';

const LAG = 160; // ms until words that nobody watches follow the picture

export class Workbench {
  constructor(model, el) {
    Object.assign(this, { model, el, system: model.get('payload'), desk: new Desk(model), width: 0 });
    this.drawing = new Drawing(el, () => this.#draw());
    this.past = new History(
      () => this.desk.snapshot(),
      (state) => this.#restore(state),
      () => this.steps.tell(),
    );
    this.steps = undoButtons(this.past);
    this.plane = new LocusPlane(this);
    this.map = new MapPanel(this);
    this.responses = new ResponsePanel(this);
    this.mode = new ModePanel(this);
    this.seen = new Map([this.map, this.responses, this.mode].map((part) => [part.canvas, true]));
    this.#build();
    this.#listen();
  }

  #build() {
    const { system, el } = this;
    el.classList.add('rlswaim-explorer');
    el.dataset.explorer = system.system;
    el.dataset.lmSuppressShortcuts = 'true'; // JupyterLab keeps its own keys out
    this.table = new PoleTable();
    this.word = element('b');
    this.reason = element('span');
    this.live = element('span', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
    this.running = element('span');
    this.crossings = element('span');
    this.margins = element('span');
    this.printed = element('span');
    this.signs = legend();
    const scroll = element(
      'div',
      { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'pole table' },
      this.table.node,
    );
    const poles = panel('poles', 'Closed-loop poles', () => {}, scroll);
    poles.node.open = this.map.node.open = this.responses.node.open = true;
    el.append(
      this.#presets(),
      this.#bar(),
      element('p', { class: 'verdict' }, this.word, this.reason),
      this.live,
      this.plane.node,
      element(
        'p',
        { class: 'crossings' },
        this.running,
        this.crossings,
        ' ',
        this.margins,
        ' ',
        this.printed,
      ),
      this.signs,
      element(
        'div',
        { class: 'panels' },
        poles.node,
        this.map.node,
        this.responses.node,
        this.mode.node,
        this.#takeaway(),
        helpPanel(),
      ),
    );
  }

  #presets() {
    const entries = this.system.presets.map((p) => [p.name, [p.label, p.note].filter(Boolean).join(': ')]);
    this.designs = buttons('Designs', [...entries, ['Reset']], (i) => this.#preset(i));
    return this.designs.group;
  }

  #preset(i) {
    const preset = this.system.presets[i];
    if (!preset) this.desk.reset();
    else this.desk.set(preset.values, { locus: this.desk.locusOf(i), printed: i, camera: null });
    this.#changed();
  }

  #bar() {
    this.loci = select(
      'Locus in',
      this.desk.loci.map(({ key, text }) => [key, text]),
      (locus) => this.look({ locus, camera: null }),
    );
    this.inset = select(
      'Origin',
      MAGNIFY.map((m) => [m, m === 1 ? 'as it is' : `×${m.toLocaleString('en')} inset`]),
      (m) => {
        this.desk.set({ magnify: Number(m) });
        this.#changed();
      },
    );
    this.said = element('span', { class: 'said', 'aria-live': 'polite' });
    const link = button('Copy link', () => this.#copy(this.#link(), 'link'), { hidden: inLab() });
    const steps = element('span', { class: 'steps' }, this.steps.undo, this.steps.redo, link, this.said);
    return element('div', { class: 'bar' }, this.loci.node, this.inset.node, steps);
  }

  #takeaway() {
    this.code = element('code');
    const shown = element('pre', { tabindex: '0' }, this.code);
    const row = element(
      'div',
      { class: 'controls' },
      button('Picture (SVG)', () => this.#save('svg')),
      button('Poles (CSV)', () => this.#save('csv')),
      button('Copy as Python', () => this.#copy(pythonOf(this.system, this.desk.state), 'call')),
    );
    return panel('takeaway', 'Take away: picture, poles, Python', () => this.#tellLater(), row, shown).node;
  }

  get name() {
    return nameOf(this.el);
  }

  #link() {
    this.#writeAddress();
    return location.href;
  }

  async #copy(text, what) {
    const done = await copy(text);
    set(
      this.said,
      done
        ? `${what} copied`
        : `no clipboard here: the ${what} stands ${what === 'link' ? 'in the address bar' : 'below'}`,
    );
    setTimeout(() => set(this.said, ''), 4000);
  }

  #save(kind) {
    const { plane, system } = this;
    if (kind === 'csv') return download(`${system.system}-poles.csv`, 'text/csv', polesAsText(this.poles));
    const { width, height } = plane.view;
    const text = svgOf(width, height, plane.canvas.ariaLabel ?? system.system, this.theme.plane, (g) =>
      plane.paint(g),
    );
    download(`${system.system}-locus.svg`, 'image/svg+xml', text);
  }

  // What the rooms of the workbench ask for.

  look(view) {
    Object.assign(this.desk.view, view);
    this.#changed();
  }

  put(name, value) {
    this.desk.set({ [name]: value });
  }

  openMode(re, im) {
    const { x, y } = this.closed;
    const off = Array.from(x, (v, i) => Math.hypot(v - re, y[i] - im));
    const mode = off.indexOf(Math.min(...off));
    if (off[mode] > 1e-5 * Math.hypot(re, im) + 1e-9)
      return set(this.said, 'another loop is open here: not a pole of the whole system');
    this.mode.node.open = true;
    this.look({ mode });
  }

  // The closed-loop pole whose mode is shown; none while the panel is closed.
  selected({ x, y, branches }) {
    if (!this.mode.node.open) return null;
    const index = Math.min(this.desk.view.mode, x.length - 1);
    return { index, re: x[index], im: y[index], name: branches[index] };
  }

  isSeen(part) {
    return part.node.open && this.seen.get(part.canvas);
  }

  // What follows from the page, not from the hand, is drawn with its next frame.
  follow() {
    this.drawing.next();
  }

  #changed() {
    this.past.note();
    this.drawing.now();
  }

  #restore(snapshot) {
    this.desk.restore(snapshot);
    this.drawing.now();
  }

  #draw() {
    if (this.width === 0) return; // not on the page yet
    const start = performance.now();
    const { desk, system } = this;
    this.theme ??= themeOf(this.el, system);
    this.closed = closedLoop(system, desk.state);
    this.poles = Array.from(this.closed.x, (re, i) => ({
      re,
      im: this.closed.y[i],
      name: this.closed.branches[i],
    }));
    this.locus = this.plane.draw(this.width, this.height, this.closed);
    for (const part of [this.map, this.responses, this.mode])
      if (this.isSeen(part)) part.draw(this.inner, this.closed);
    this.#tell();
    this.el.dispatchEvent(
      new CustomEvent('rlswaim:drawn', { bubbles: true, detail: { ms: performance.now() - start } }),
    );
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.#tellLater(), LAG);
    practise(system, desk.state, (state) => this.plane.rehearse(state));
  }

  #tell() {
    const { desk, locus } = this;
    const { running } = desk.what;
    this.verdict = verdict(this.poles);
    const { word, long } = this.verdict;
    this.table.show(this.poles, this.theme);
    set(this.word, word === 'neutral' ? 'Neutrally stable' : word[0].toUpperCase() + word.slice(1));
    set(this.reason, long);
    if (this.word.className !== word) this.word.className = word;
    if (this.named !== running) this.running.replaceChildren(...symbol((this.named = running)));
    set(this.crossings, crossingWords(locus.crossings));
    set(this.margins, marginWords(margins(this.system, desk.state, desk.what)));
    set(this.printed, printedWords(this.plane.extra.printed, locus.present));
    const { path } = this.system.presets[desk.view.printed] ?? {};
    set(this.signs.lastChild.lastChild, path ? ` printed in the report (${path})` : ' printed in the report');
    this.system.presets.forEach((_, i) => press(this.designs.made[i], desk.isDesign(i)));
    if (this.loci.list.value !== desk.view.locus) this.loci.list.value = desk.view.locus;
    const magnify = String(this.model.get('magnify'));
    if (this.inset.list.value !== magnify) this.inset.list.value = magnify;
  }

  // Words for a screen reader, the address and the call of the library follow when the hand rests.
  #tellLater() {
    if (!this.verdict) return;
    const { word, short, long } = this.verdict;
    set(this.live, short);
    this.plane.later(`${word}${long}`);
    this.map.later(short);
    this.responses.later();
    this.mode.later();
    set(this.code, pythonOf(this.system, this.desk.state));
    this.#writeAddress();
  }

  #writeAddress() {
    writeAddress(this.name, this.desk.toAddress());
  }

  #readAddress() {
    const texts = readAddress(this.name);
    if (Object.keys(texts).length === 0) return;
    this.desk.fromAddress(texts);
    if ('view.mode' in texts) this.mode.node.open = true;
    this.follow();
  }

  #arrive() {
    if (this.arrived || !this.el.isConnected) return;
    this.arrived = true;
    this.#readAddress();
    this.past.present = this.desk.snapshot();
    this.steps.tell();
  }

  #listen() {
    const { model, el } = this;
    const changed = () => this.#changed();
    const names = [...this.desk.names, 'magnify'];
    for (const name of names) model.on(`change:${name}`, changed);
    const resized = new ResizeObserver(() => this.#measure());
    resized.observe(this.plane.canvas);
    const watch = new IntersectionObserver((entries) => this.#noteSeen(entries), { rootMargin: '120px' });
    for (const canvas of this.seen.keys()) watch.observe(canvas);
    const unwatch = onThemeChange(() => {
      this.theme = themeOf(el, this.system); // at once: the mode that swings doesn't wait for the drawing
      this.follow();
    });
    const unkey = onUndoKeys(el, this.past);
    const address = () => this.#readAddress();
    addEventListener('hashchange', address);
    this.stop = () => {
      this.drawing.stop();
      clearTimeout(this.timer);
      this.past.stop();
      this.plane.stop();
      this.mode.stop();
      this.map.stop();
      for (const observer of [resized, watch]) observer.disconnect();
      unwatch();
      unkey();
      removeEventListener('hashchange', address);
      for (const name of names) model.off(`change:${name}`, changed);
    };
  }

  #measure() {
    this.#arrive();
    const { clientWidth, clientHeight } = this.plane.canvas;
    [this.width, this.height] = [clientWidth, clientHeight];
    this.inner = Math.max(...[...this.seen.keys()].map((canvas) => canvas.clientWidth)) || clientWidth;
    this.follow();
  }

  #noteSeen(entries) {
    for (const { target, isIntersecting } of entries) this.seen.set(target, isIntersecting);
    if (entries.some(({ isIntersecting }) => isIntersecting)) this.follow();
  }
}
