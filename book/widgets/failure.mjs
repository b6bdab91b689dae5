// Where a live view cannot be drawn: one readable line in its place, the error itself in the console.

/** @typedef {{ initialize?(context: object): unknown, render?(context: object): unknown }} ViewModule */

/** @param {Element} el @param {unknown} error */
export function fail(el, error) {
  console.error(error);
  const line = document.createElement('p');
  line.className = 'live-view-failure';
  line.setAttribute('role', 'alert');
  line.textContent = `This live view could not be drawn: ${error instanceof Error ? error.message : error}`;
  el.replaceChildren(line);
}

/**
 * anywidget calls this (see build.mjs) with the promise of a widget's own module. On its own it would leave
 * an error in that module as an unhandled rejection and an empty place in the page.
 * @param {Promise<ViewModule>} loading
 */
export async function guarded(loading) {
  /** @type {ViewModule | undefined} */
  let widget;
  /** @type {{ error: unknown } | undefined} */
  let broken;
  try {
    widget = await loading;
  } catch (error) {
    broken = { error };
  }
  return {
    /** @param {object} context */
    async initialize(context) {
      try {
        return await widget?.initialize?.(context);
      } catch (error) {
        broken = { error };
      }
    },
    /** @param {{ el: Element }} context */
    async render(context) {
      try {
        if (broken) throw broken.error;
        return await widget.render?.(context);
      } catch (error) {
        fail(context.el, error);
      }
    },
  };
}
