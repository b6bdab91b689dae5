// A view that is its parameters' picture: presets and undo above, what it shows below.
import { button, element, group } from '../page/elements.js';
import { Lifecycle } from '../page/lifecycle.js';
import { holds, ParameterState } from '../page/parameter_state.js';

/** @import { Context, Values } from '../types.d.ts' */
/**
 * @typedef {object} Simple
 * @property {(string | Node)[]} nodes
 * @property {HTMLCanvasElement[]} canvases
 * @property {(values: Values, page: Lifecycle) => string} draw
 * @property {() => void} [stop]
 */

/** Puts a view on its page. @param {Context} context @param {Simple} view */
export function mount({ model, el }, view) {
  const state = new ParameterState(model);
  const { presets, initial, system, colors } = state.payload;
  const made = presets.map(({ name, label, values }) => ({
    values,
    node: button(name, () => state.set(values), { title: label, 'aria-pressed': 'false' }),
  }));
  const reset = button('Reset', () => state.set(initial), { title: 'back to the start' });
  const page = new Lifecycle(el, system, {
    state,
    colors,
    canvases: view.canvases,
    draw() {
      const { values } = state;
      for (const preset of made)
        preset.node.setAttribute('aria-pressed', String(holds(preset.values, values)));
      return view.draw(values, page);
    },
    stop: view.stop,
  });
  const nodes = [...made.map(({ node }) => node), reset, ...(state.own.length ? page.history.buttons : [])];
  el.append(group('buttons', 'Presets', element('span', {}, 'Try'), ...nodes), ...view.nodes, page.live);
  return { state, page };
}
