// A part of the page that fills the window, and goes back to its place: nothing is moved in the document, so
// that the focus and all that is typed stay.

/**
 * All that lies beside an element, up to the page's body.
 * @param {Element} inner
 */
function around(inner) {
  const found = [];
  for (let at = inner; at.parentElement && at !== document.body; at = at.parentElement)
    found.push(
      ...[...at.parentElement.children].filter((other) => other !== at && !other.matches('script, style')),
    );
  return /** @type {HTMLElement[]} */ (found);
}

export class Layer {
  /** @param {HTMLElement} node @param {() => void} left it was left by the Escape key */
  constructor(node, left) {
    this.node = node;
    this.left = left;
    /** @type {HTMLElement[]} */
    this.rest = [];
    this.keys = (/** @type {KeyboardEvent} */ event) => {
      if (event.key === 'Escape' && !event.defaultPrevented) this.left();
    };
  }

  get isOpen() {
    return this.node.classList.contains('rlswaim-desk');
  }

  open() {
    if (this.isOpen) return;
    const { node } = this;
    const { activeElement } = document;
    this.rest = around(node).filter((other) => !other.inert);
    node.parentElement.style.minHeight = `${node.offsetHeight}px`; // the page under it keeps its length
    node.classList.add('rlswaim-desk');
    node.popover = 'manual';
    node.showPopover?.(); // above all else, whatever the page's own layers are
    for (const other of this.rest) other.inert = true;
    document.documentElement.classList.add('rlswaim-has-desk');
    if (node.contains(activeElement))
      /** @type {HTMLElement} */ (activeElement).focus({ preventScroll: true });
    addEventListener('keydown', this.keys, true); // boxes and sliders keep their keys to themselves
  }

  close() {
    if (!this.isOpen) return;
    const { node } = this;
    const { activeElement } = document;
    for (const other of this.rest) other.inert = false;
    node.removeAttribute('popover');
    node.classList.remove('rlswaim-desk');
    node.parentElement.style.minHeight = '';
    document.documentElement.classList.remove('rlswaim-has-desk');
    removeEventListener('keydown', this.keys, true);
    const { top, bottom } = node.getBoundingClientRect();
    if (top > innerHeight || bottom < 0) node.scrollIntoView({ block: 'start', behavior: 'instant' });
    if (node.contains(activeElement))
      /** @type {HTMLElement} */ (activeElement).focus({ preventScroll: true });
  }
}
