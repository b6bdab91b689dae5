// Two designs side by side, each on a workbench of its own with its sliders, both on the same scales. The
// designs are chosen outside, by number.
import { goToAddressed, onAddress, readAddress, writeAddress } from '../page/address.js';
import { leftOut } from '../page/address_values.js';
import { element } from '../page/elements.js';
import { isNewHere } from '../page/lifecycle.js';
import { Notice } from '../page/notice.js';
import { PageBench } from './page_bench.js';
import { SharedWindow } from './shared_window.js';

/** @import { Context, Model } from '../types.d.ts' */

const SIDES = ['left', 'right'];
const NAME = 'comparison';

class Side {
  /** @param {Model} model @param {string} key @param {SharedWindow} shared */
  constructor(model, key, shared) {
    this.model = model;
    this.shared = shared;
    this.key = key;
    /** @type {number} */
    this.at = undefined;
    /** @type {PageBench} */
    this.bench = undefined;
    this.root = element('div');
    this.node = element('section', { class: 'side', 'aria-label': `${key} design` }, this.root);
  }

  show() {
    const { shared, systems, designs } = this.model.get('payload');
    const at = this.model.get(this.key);
    if (at === this.at || !designs[at]) return;
    if (this.bench) {
      this.bench.stop();
      writeAddress(this.bench.name, {}); // what was looked at goes with the design
    }
    const payload = { ...shared, ...systems[designs[at].system] };
    const initial = payload.presets[designs[at].preset].values;
    this.bench = new PageBench(payload, initial, `${this.key}-${at}`, this.shared);
    this.root.replaceWith(this.bench.node);
    Object.assign(this, { at, root: this.bench.node });
  }
}

/**
 * Which designs an address names, and notes on names that are none; the rest stays as it is.
 * @param {Record<string, string>} texts @param {number} count
 */
function chosen(texts, count) {
  const named = Object.entries(texts).map(([key, text]) => ({ key, at: text === '' ? NaN : Number(text) }));
  /** @param {{ key: string, at: number }} entry */
  const isDesign = ({ key, at }) => SIDES.includes(key) && Number.isInteger(at) && at >= 0 && at < count;
  const notes = named.filter((entry) => !isDesign(entry)).map(({ key }) => leftOut(key, 'not a design here'));
  return { designs: named.filter(isDesign), notes };
}

/** @param {Context} context */
export function render({ model, el }) {
  el.classList.add('rlswaim-comparison');
  el.dataset.explorer = NAME;
  const start = SIDES.map((key) => model.get(key));
  const shared = new SharedWindow();
  const sides = SIDES.map((key) => new Side(model, key, shared));
  /** @param {{ key: string, at: number }[]} designs */
  const choose = (designs) => {
    for (const { key, at } of designs) model.set(key, at);
    model.save_changes();
  };
  const notice = new Notice(() => choose(SIDES.map((key, i) => ({ key, at: start[i] }))));
  /** @param {string} [hash] */
  const arrive = (hash) => {
    const texts = readAddress(NAME, hash);
    if (Object.keys(texts).length === 0) return;
    const { designs, notes } = chosen(texts, model.get('payload').designs.length);
    choose(designs);
    notice.opened(notes);
  };
  const show = () => {
    for (const side of sides) side.show();
    const moved = SIDES.some((key, i) => model.get(key) !== start[i]);
    writeAddress(NAME, moved ? Object.fromEntries(SIDES.map((key) => [key, model.get(key)])) : {});
  };
  el.append(element('div', { class: 'rlswaim-explorer' }, notice.node), ...sides.map(({ node }) => node));
  arrive();
  show();
  const laidOut = new ResizeObserver(() => {
    laidOut.disconnect();
    if (isNewHere()) goToAddressed(el, NAME);
  });
  laidOut.observe(el);
  const changed = () => {
    notice.clear();
    show();
  };
  for (const key of SIDES) model.on(`change:${key}`, changed);
  const unfollow = onAddress((hash) => {
    arrive(hash);
    goToAddressed(el, NAME, hash);
  });
  return () => {
    laidOut.disconnect();
    for (const { bench } of sides) bench.stop();
    for (const key of SIDES) model.off(`change:${key}`, changed);
    unfollow();
  };
}
