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

/** @param {Model} model @param {{ key: string, at: number }[]} designs */
function choose(model, designs) {
  for (const { key, at } of designs) model.set(key, at);
  model.save_changes();
}

/**
 * Acts once, when an element has its size; returns what calls that off.
 * @param {HTMLElement} el @param {() => void} act
 */
function whenLaidOut(el, act) {
  const watch = new ResizeObserver(() => {
    watch.disconnect();
    act();
  });
  watch.observe(el);
  return () => watch.disconnect();
}

/** The address tells designs other than those of the start. @param {Model} model @param {number[]} start */
function tellAddress(model, start) {
  const now = SIDES.map((key) => model.get(key));
  const moved = now.some((design, i) => design !== start[i]);
  writeAddress(NAME, moved ? Object.fromEntries(SIDES.map((key, i) => [key, now[i]])) : {});
}

/** @param {Context} context */
export function render({ model, el }) {
  el.classList.add('rlswaim-comparison');
  el.dataset.explorer = NAME;
  /** @type {number[]} */
  const start = SIDES.map((key) => model.get(key));
  const shared = new SharedWindow();
  const sides = SIDES.map((key) => new Side(model, key, shared));
  const own = SIDES.map((key, i) => ({ key, at: start[i] }));
  const notice = new Notice(() => choose(model, own));
  /** @param {string} [hash] */
  const arrive = (hash) => {
    const texts = readAddress(NAME, hash);
    if (Object.keys(texts).length === 0) return;
    const { designs, notes } = chosen(texts, model.get('payload').designs.length);
    choose(model, designs);
    notice.opened(notes);
  };
  const show = () => {
    for (const side of sides) side.show();
    tellAddress(model, start);
  };
  el.append(element('div', { class: 'rlswaim-explorer' }, notice.node), ...sides.map(({ node }) => node));
  arrive();
  show();
  const unwatch = whenLaidOut(el, () => isNewHere() && goToAddressed(el, NAME));
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
    unwatch();
    for (const { bench } of sides) bench.stop();
    for (const key of SIDES) model.off(`change:${key}`, changed);
    unfollow();
  };
}
