// Undo, redo and the page's address for a view's own parameters. Those of another view are kept by that one.
import { nameOf, readAddress, writeAddress } from './address.js';
import { History, onUndoKeys, undoButtons } from './undo.js';

const LAG = 160; // ms until the address follows

// The value that a text of the address gives a parameter, if its slider has such a place or two that it lies between.
function valueOf(grid, text) {
  if (typeof grid[0] === 'string') return grid.includes(text) ? text : undefined;
  const value = text.trim() === '' ? NaN : Number(text);
  const whole = grid.every(Number.isInteger);
  return value >= grid[0] && value <= grid.at(-1) && (!whole || Number.isInteger(value)) ? value : undefined;
}

export function keep(model, payload, el, apply) {
  const own = payload.parameters.filter(({ name }) => payload.own.includes(name));
  const read = () => JSON.stringify(Object.fromEntries(own.map(({ name }) => [name, model.get(name)])));
  const history = new History(
    read,
    (snapshot) => apply(JSON.parse(snapshot)),
    () => steps.tell(),
  );
  const steps = undoButtons(history);
  let timer;

  function write() {
    const moved = own.filter(({ name }) => model.get(name) !== payload.initial[name]);
    writeAddress(nameOf(el), Object.fromEntries(moved.map(({ name }) => [name, model.get(name)])));
  }

  function arrive() {
    const texts = readAddress(nameOf(el));
    const values = own.map(({ name, grid }) => [name, valueOf(grid, texts[name] ?? '')]);
    apply(Object.fromEntries(values.filter(([, value]) => value !== undefined)));
  }

  const unkey = onUndoKeys(el, history);
  addEventListener('hashchange', arrive);
  return {
    nodes: own.length ? [steps.undo, steps.redo] : [],
    arrive() {
      arrive();
      history.present = read();
      steps.tell();
    },
    note() {
      history.note();
      clearTimeout(timer);
      timer = setTimeout(write, LAG);
    },
    stop() {
      history.stop();
      clearTimeout(timer);
      unkey();
      removeEventListener('hashchange', arrive);
    },
  };
}
