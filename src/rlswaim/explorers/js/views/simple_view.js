// A view that is its parameters' picture: presets and undo above, what it shows below.
import { drawnOn } from '../drawing/context.js';
import { SvgContext } from '../drawing/svg.js';
import { button, element, group, panel, press } from '../page/elements.js';
import { Lifecycle } from '../page/lifecycle.js';
import { LinkCopier } from '../page/link_copier.js';
import { holds, ParameterState } from '../page/parameter_state.js';
import { download, fileName, tableAsText } from '../page/take_away.js';
import { BenchPanel } from './bench_panel.js';

/** @import { Context, Payload, Values } from '../types.d.ts' */
/** @import { PageBench } from './page_bench.js' */
/**
 * @typedef {object} Simple
 * @property {Node[]} nodes
 * @property {HTMLCanvasElement[]} canvases
 * @property {(values: Values, page: Lifecycle) => string} draw
 * @property {(state: ParameterState, page: Lifecycle) => void} [begin] it is on its page
 * @property {() => void} [stop]
 * @property {(bench: PageBench | null, state: ParameterState, page: Lifecycle) => void} [benched] a bench on
 *   its vehicle is open, or none
 */

const CAPTION = 22; // px above each picture

/**
 * All pictures of a view in one SVG, each under its caption.
 * @param {Simple} view @param {ParameterState} state @param {Lifecycle} page
 */
function picturesOf(view, state, page) {
  const sizes = view.canvases.map((canvas) => page.sizeOf(canvas));
  const tops = sizes.map((_, k) => sizes.slice(0, k).reduce((sum, [, h]) => sum + h + CAPTION, CAPTION));
  const height = sizes.reduce((sum, [, h]) => sum + h + CAPTION, 0);
  const g = new SvgContext(Math.max(...sizes.map(([w]) => w)), height);
  let words = '';
  drawnOn(
    (canvas) => {
      g.matrix = [1, 0, 0, 1, 0, tops[view.canvases.indexOf(canvas)]];
      return g;
    },
    () => {
      words = view.draw(state.values, page);
    },
  );
  g.matrix = [1, 0, 0, 1, 0, 0];
  g.textAlign = 'left';
  g.fillStyle = page.theme.ink;
  view.canvases.forEach((canvas, k) => {
    const caption = canvas.closest('figure')?.querySelector('figcaption')?.textContent ?? '';
    g.fillText(caption, 8, tops[k] - CAPTION / 2);
  });
  return g.document(words, page.theme.plane);
}

/**
 * What a reader takes away: the pictures, and the first table with the parameters.
 * @param {Simple} view @param {ParameterState} state @param {Lifecycle} page
 */
function takeAway(view, state, page) {
  /** @param {string} what */
  const name = (what) => fileName(state.payload.system, state.values, what);
  const pictures = button('Pictures (SVG)', () =>
    download(name('pictures.svg'), 'image/svg+xml', picturesOf(view, state, page)),
  );
  const table = button('Table (CSV)', () =>
    download(name('table.csv'), 'text/csv', tableAsText(page.el.querySelector('table'), state.values)),
  );
  const row = element('div', { class: 'controls' }, pictures, table);
  return panel('takeaway', 'Take away: pictures, table', () => {}, row).node;
}

/**
 * What puts such a view on its page, and returns what takes it away.
 * @param {new (payload: Payload) => Simple} View
 */
export const simple =
  (View) =>
  /** @param {Context} context */
  ({ model, el }) => {
    const state = new ParameterState(model);
    const { presets, system, colors } = state.payload;
    const view = new View(state.payload);
    const made = presets.map(({ name, label, values }) => {
      const node = button(name, () => state.set(values), { title: label, 'aria-pressed': 'false' });
      return { values, node };
    });
    const reset = button('Reset', () => state.reset(), { title: 'back to the start' });
    const page = new Lifecycle(el, system, {
      state,
      colors,
      canvases: view.canvases,
      draw() {
        const { values } = state;
        for (const preset of made) press(preset.node, holds(preset.values, values));
        return view.draw(values, page);
      },
      stop: () => {
        bench?.stop();
        view.stop?.();
      },
    });
    const undo = state.own.length ? page.history.buttons : [];
    const { link, said } = new LinkCopier(() => page.writeAddress());
    const nodes = [...made.map(({ node }) => node), reset, ...undo, link, said];
    const tried = group('buttons', 'Presets', element('span', {}, 'Try'), ...nodes);
    const bench = state.payload.bench
      ? new BenchPanel(state, (opened) => view.benched?.(opened, state, page))
      : undefined;
    el.append(tried, ...view.nodes, page.live, ...(bench ? [bench.node] : []), takeAway(view, state, page));
    view.begin?.(state, page);
    return page.stop;
  };
