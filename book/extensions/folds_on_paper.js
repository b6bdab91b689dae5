/** Open the folds of a page for paper: solutions of exercises, and tables; what was closed closes again. */

const FOLDS = '.bd-article :is(details.sd-dropdown, details.hide):not([open])';
/** @type {HTMLDetailsElement[]} */
let opened = [];

window.addEventListener('beforeprint', () => {
  const closed = /** @type {HTMLDetailsElement[]} */ ([...document.querySelectorAll(FOLDS)]);
  for (const fold of closed) fold.open = true;
  opened.push(...closed);
});

window.addEventListener('afterprint', () => {
  for (const fold of opened) fold.open = false;
  opened = [];
});
