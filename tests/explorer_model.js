// Stands in for the notebook: loads the views' one module and gives it a model with get, set and on.
async ([code, css, state]) => {
  const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  const module = await import(address);
  const listeners = {};
  const model = {
    get: (name) => state[name],
    set(name, value) {
      if (state[name] === value) return;
      state[name] = value;
      for (const act of [...(listeners[`change:${name}`] ?? [])]) act();
    },
    save_changes() {},
    on: (event, act) => (listeners[event] ??= []).push(act),
    off: (event, act) => (listeners[event] = listeners[event].filter((other) => other !== act)),
  };
  document.head.append(Object.assign(document.createElement('style'), { textContent: css }));
  const el = document.createElement('div');
  document.body.append(el);
  const drawn = () =>
    new Promise((done) => el.addEventListener('rlswaim:drawn', (e) => done(e.detail), { once: true }));
  Object.assign(globalThis, { module, model, drawn, el, state });
  const first = drawn();
  module.default.initialize({ model });
  module.default.render({ model, el });
  return first;
};
