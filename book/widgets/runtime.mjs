// Brings the widgets of a built page to life: no kernel, no server, nothing fetched.
//
// The page holds the state of all its widgets in one script tag and a second kind of tag wherever a widget is
// shown (myst-nb writes both). Each of the latter is replaced by its view; jslink and jsdlink are models in
// that state and need nothing more.
import * as base from '@jupyter-widgets/base';
import { ManagerBase } from '@jupyter-widgets/base-manager';
import * as controls from '@jupyter-widgets/controls';
import { Widget } from '@lumino/widgets';
import anywidget from 'anywidget';
import { fail } from './failure.mjs';
import { nameControls } from './names.mjs';

/** @type {Record<string, Record<string, any>>} */
const MODULES = {
  '@jupyter-widgets/base': base,
  '@jupyter-widgets/controls': controls,
  anywidget: anywidget(base),
};

// Play looks for the <i> of its button, but Font Awesome in the book's theme has put an <svg> in its place.
controls.PlayView.prototype.updatePlaying = function () {
  const icon = /** @type {any} */ (this).playPauseButton.firstElementChild;
  icon.classList.toggle('fa-play', !this.model.get('playing'));
  icon.classList.toggle('fa-pause', this.model.get('playing'));
};

// The readout is written four times a move, each time as a new node, and a new node makes the browser look
// through the style of the whole cell: change the text that is there.
controls.SelectionSliderView.prototype.updateReadout = function (index) {
  const text = this.model.get('_options_labels')[index];
  const node = /** @type {Text} */ (this.readout.firstChild ?? this.readout.appendChild(new Text()));
  if (node.data !== text) node.data = text;
};

const STATE = 'script[type="application/vnd.jupyter.widget-state+json"]';
const VIEW = 'script[type="application/vnd.jupyter.widget-view+json"]';

/**
 * A live view tells when it has drawn. One that draws nothing, or not now (in a tab in the background), is
 * not waited for.
 * @param {Element} place
 * @returns {Promise<void>}
 */
const drawn = (place) =>
  new Promise((resolve) => {
    place.addEventListener('rlswaim:drawn', () => setTimeout(() => resolve()), { once: true });
    setTimeout(resolve, 1000);
  });

// The page's formulas are long work: they wait until the views are there, which is short work.
/** @type {() => void} */
let viewsAreThere;
/** @type {Promise<void>} */
const views = new Promise((resolve) => {
  viewsAreThere = resolve;
});
if (!globalThis.MathJax?.startup) {
  const pageReady = () => views.then(() => globalThis.MathJax.startup.defaultPageReady());
  globalThis.MathJax = { ...globalThis.MathJax, startup: { pageReady } };
}

/** @type {Promise<void>} */
const pageLoaded = new Promise((resolve) => {
  if (document.readyState === 'complete') resolve();
  else addEventListener('load', () => resolve(), { once: true });
});

// Typesets labels, one after the other as MathJax 3 asks for. MathJax may arrive after this script, or not at
// all.
let typesetting = Promise.resolve();
/** @param {Element} el */
function typeset(el) {
  typesetting = typesetting
    .then(() => globalThis.MathJax?.startup?.promise ?? pageLoaded)
    .then(() => globalThis.MathJax?.startup?.promise)
    .then(() => globalThis.MathJax?.typesetPromise?.([el]))
    .then(() => {
      /** @type {NodeListOf<HTMLElement>} */
      const formulas = el.querySelectorAll('mjx-container');
      for (const formula of formulas) formula.tabIndex = -1; // no stop for Tab
    })
    .catch((error) => console.error(error));
}

class PageManager extends ManagerBase {
  // ipywidgets asks its manager for this first, and only without it calls MathJax.Hub.Queue of MathJax 2.
  _rendermime = { latexTypesetter: { typeset } };

  /** @param {string} name @param {string} module */
  async loadClass(name, module) {
    const found = MODULES[module]?.[name];
    if (!found) throw new Error(`${name} of ${module} is not part of this page's widgets`);
    return found;
  }

  /** @param {base.WidgetModel} model @param {unknown} [options] @returns {Promise<any>} */
  async create_view(model, options) {
    const view = /** @type {any} */ (await super.create_view(model, options));
    if (view instanceof base.ErrorWidgetView) {
      const { msg, stack } = view.generateErrorMessage();
      view.el.onclick = view.el.ondblclick = null;
      fail(view.el, Object.assign(new Error(msg), { stack }));
    } else {
      nameControls(view);
    }
    return view;
  }

  async _get_comm_info() {
    return {};
  }

  /** @returns {Promise<never>} */
  async _create_comm() {
    throw new Error('this page has no kernel');
  }
}

/** @param {PageManager} manager @param {Element} tag */
async function show(manager, tag) {
  const place = document.createElement('div');
  place.className = 'live-view';
  tag.replaceWith(place);
  try {
    const model = await manager.get_model(JSON.parse(tag.textContent).model_id);
    const view = await manager.create_view(model);
    Widget.attach(view.luminoWidget, place);
  } catch (error) {
    fail(place, error);
  }
  return place;
}

async function start() {
  const style = document.createElement('style');
  style.textContent = RUNTIME_CSS; // put in by build.mjs
  document.head.prepend(style); // before the page's own style sheets, so that they can override it

  const manager = new PageManager();
  for (const tag of document.querySelectorAll(STATE)) {
    try {
      await manager.set_state(JSON.parse(tag.textContent));
    } catch (error) {
      console.error(error); // its views say so in the page
    }
  }
  for (const tag of document.querySelectorAll(VIEW)) {
    await drawn(await show(manager, tag)); // each can be used before the next one is made
  }
}

// The page's text is there once it is `interactive`, before all scripts that wait for that.
const begin = () => start().finally(viewsAreThere);
if (document.readyState === 'loading') document.addEventListener('readystatechange', begin, { once: true });
else begin();
