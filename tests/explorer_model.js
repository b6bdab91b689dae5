// Stands in for the notebook: loads the views' one module and gives it a model with get, set and on.
/** @param {[string, string, Record<string, unknown>]} given code, style sheet and traits */
async ([code, css, state]) => {
  const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  const module = await import(address);
  /** @type {Record<string, (() => void)[]>} */
  const listeners = {};
  const model = {
    /** @param {string} name */
    get: (name) => state[name],
    /** @param {string} name @param {unknown} value */
    set(name, value) {
      if (state[name] === value) return;
      state[name] = value;
      for (const act of [...(listeners[`change:${name}`] ?? [])]) act();
    },
    save_changes() {},
    /** @param {string} event @param {() => void} act */
    on(event, act) {
      listeners[event] = [...(listeners[event] ?? []), act];
    },
    /** @param {string} event @param {() => void} act */
    off(event, act) {
      listeners[event] = listeners[event].filter((other) => other !== act);
    },
  };
  document.head.append(Object.assign(document.createElement('style'), { textContent: css }));
  const el = document.createElement('div');
  document.body.append(el);
  /** The next drawing; one that never comes fails a test and doesn't hold it up. */
  const drawn = () =>
    new Promise((done, fail) => {
      const late = setTimeout(() => fail(new Error('nothing was drawn in 30 s')), 30000);
      const act = (/** @type {Event} */ e) => {
        clearTimeout(late);
        done(/** @type {CustomEvent} */ (e).detail);
      };
      el.addEventListener('rlswaim:drawn', act, { once: true });
    });
  Object.assign(globalThis, { module, model, drawn, el, state });
  const first = drawn();
  module.default.initialize({ model });
  module.default.render({ model, el });
  return first;
};
