// Two designs side by side, each on a workbench of its own. The designs are chosen outside, by number.
import { readAddress, writeAddress } from '../page/address.js';
import { element } from '../page/dom.js';
import { Workbench } from './workbench.js';

const SIDES = ['left', 'right'];
const NAME = 'comparison';

// What a workbench asks of a model, for one that only this page holds.
class Held {
  constructor(values) {
    this.values = values;
    this.acts = new Map();
  }

  get(name) {
    return this.values[name];
  }

  set(name, value) {
    if (this.values[name] === value) return;
    this.values[name] = value;
    for (const act of [...this.#actsOf(`change:${name}`)]) act();
  }

  save_changes() {}

  #actsOf(event) {
    if (!this.acts.has(event)) this.acts.set(event, new Set());
    return this.acts.get(event);
  }

  on(event, act) {
    this.#actsOf(event).add(act);
  }

  off(event, act) {
    this.#actsOf(event).delete(act);
  }
}

class Side {
  constructor(model, key) {
    this.key = key;
    this.system = element('div');
    this.node = element('section', { class: 'side', 'aria-label': `${key} design` }, this.system);
    this.show = () => this.#show(model.get('payload'), model.get(key));
  }

  #show({ systems, designs }, at) {
    if (at === this.at || !designs[at]) return;
    if (this.bench) {
      this.bench.stop();
      writeAddress(this.bench.name, {}); // what was looked at goes with the design
    }
    const payload = systems[designs[at].system];
    const initial = payload.presets[designs[at].preset].values;
    const fresh = element('div', { 'data-name': `${this.key}-${at}` });
    this.system.replaceWith(fresh);
    Object.assign(this, { at, system: fresh });
    this.bench = new Workbench(new Held({ payload: { ...payload, initial }, magnify: 1, ...initial }), fresh);
  }

  stop() {
    this.bench.stop();
  }
}

// Which designs an address names; the rest stays as it is.
function chosen(texts, count) {
  const numbers = SIDES.map((key) => [key, Number(texts[key] ?? NaN)]);
  return numbers.filter(([, at]) => Number.isInteger(at) && at >= 0 && at < count);
}

function render({ model, el }) {
  el.classList.add('rlswaim-comparison');
  el.dataset.explorer = NAME;
  const start = SIDES.map((key) => model.get(key));
  const sides = SIDES.map((key) => new Side(model, key));
  const arrive = () => {
    for (const [key, at] of chosen(readAddress(NAME), model.get('payload').designs.length))
      model.set(key, at);
    model.save_changes();
  };
  const changed = () => {
    for (const side of sides) side.show();
    const moved = SIDES.some((key, i) => model.get(key) !== start[i]);
    writeAddress(NAME, moved ? Object.fromEntries(SIDES.map((key) => [key, model.get(key)])) : {});
  };
  arrive();
  el.append(...sides.map(({ node }) => node));
  for (const key of SIDES) model.on(`change:${key}`, changed);
  addEventListener('hashchange', arrive);
  changed();
  return () => {
    for (const side of sides) side.stop();
    for (const key of SIDES) model.off(`change:${key}`, changed);
    removeEventListener('hashchange', arrive);
  };
}

export default { render };
