// A view that is its parameters' picture: presets and undo above, what it shows below.
import { button, element, group, press } from '../page/elements.js';
import { Lifecycle } from '../page/lifecycle.js';
import { holds, ParameterState } from '../page/parameter_state.js';

/** @import { Context, Payload, Values } from '../types.d.ts' */
/**
 * @typedef {object} Simple
 * @property {Node[]} nodes
 * @property {HTMLCanvasElement[]} canvases
 * @property {(values: Values, page: Lifecycle) => string} draw
 * @property {(state: ParameterState, page: Lifecycle) => void} [begin] it is on its page
 * @property {() => void} [stop]
 */

/**
 * What puts such a view on its page, and returns what takes it away.
 * @param {new (payload: Payload) => Simple} View
 */
export const simple =
  (View) =>
  /** @param {Context} context */
  ({ model, el }) => {
    const state = new ParameterState(model);
    const { presets, initial, system, colors } = state.payload;
    const view = new View(state.payload);
    const made = presets.map(({ name, label, values }) => {
      const node = button(name, () => state.set(values), { title: label, 'aria-pressed': 'false' });
      return { values, node };
    });
    const reset = button('Reset', () => state.set(initial), { title: 'back to the start' });
    const page = new Lifecycle(el, system, {
      state,
      colors,
      canvases: view.canvases,
      draw() {
        const { values } = state;
        for (const preset of made) press(preset.node, holds(preset.values, values));
        return view.draw(values, page);
      },
      stop: () => view.stop?.(),
    });
    const undo = state.own.length ? page.history.buttons : [];
    const nodes = [...made.map(({ node }) => node), reset, ...undo];
    const tried = group('buttons', 'Presets', element('span', {}, 'Try'), ...nodes);
    el.append(tried, ...view.nodes, page.live);
    view.begin?.(state, page);
    return page.stop;
  };
