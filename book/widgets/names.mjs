// Names for screen readers. ipywidgets draws a slider's label beside it but does not tie the two together,
// gives no name to readouts and groups of buttons, and reads a log slider's value as its exponent.

/**
 * @typedef {any} WidgetView a view of a control of ipywidgets, whose own types leave out the parts used here
 */

/** "Gain \(K_{za}\)" -> "Gain K za" @param {unknown} text */
export function plain(text) {
  return String(text ?? '')
    .replace(/<[a-z/][^>]*>/gi, '')
    .replace(/\\[()[\],;:! ]|\\(?:text|mathrm|mathit|mathbf|left|right)\b|[$\\{}_^]/g, ' ')
    .replace(/\s+/g, ' ')
    .trim();
}

/** @param {Element | null | undefined} element @param {string} attribute @param {string | undefined} value */
function set(element, attribute, value) {
  if (element && value && element.getAttribute(attribute) !== value) element.setAttribute(attribute, value);
}

/** @param {WidgetView} view @param {string} name @param {Element | null} readout */
function nameSlider({ el, model, handleTextChange }, name, readout) {
  /** @type {NodeListOf<Element>} */
  const handles = el.querySelectorAll('.noUi-handle');
  handles.forEach((handle, i) => {
    set(handle, 'aria-label', handles.length > 1 ? `${name}, ${i ? 'upper' : 'lower'} end` : name);
    set(handle, 'aria-valuetext', readout?.textContent);
    set(handle, 'aria-disabled', String(model.get('disabled')));
  });
  // Typing in it would change nothing.
  if (readout && !handleTextChange) set(readout, 'contenteditable', 'false');
  if (readout instanceof HTMLElement && readout.isContentEditable) {
    set(readout, 'role', 'textbox');
    set(readout, 'aria-label', `${name}, value`.replace(/^, /, ''));
  }
}

/** @param {Element} el @param {string} name */
function nameButtons(el, name) {
  if (el.matches('.widget-toggle-buttons, .widget-radio')) {
    set(el, 'role', el.matches('.widget-radio') ? 'radiogroup' : 'group');
    set(el, 'aria-label', name);
  }
  for (const button of el.querySelectorAll('.widget-toggle-button'))
    set(button, 'aria-pressed', String(button.classList.contains('mod-active')));
}

/** @param {WidgetView} view */
export function nameControls(view) {
  const { el, label, model } = view;
  set(view.playPauseButton, 'aria-label', 'play or pause');
  set(view.stopButton, 'aria-label', 'stop');
  set(view.repeatButton, 'aria-label', 'repeat');
  if (!label) return; // boxes and other buttons are named by what they hold
  const readout = el.querySelector('.widget-readout');

  function apply() {
    const name = plain(model.get('tooltip') || model.get('description'));
    if (!model.get('tooltip')) label.removeAttribute('title'); // ipywidgets writes the word "null" there
    nameSlider(view, name, readout);
    for (const input of el.querySelectorAll('select, textarea, input:not([type=radio])'))
      set(input, 'aria-label', name);
    nameButtons(el, name);
  }

  apply();
  view.listenTo(model, 'change', apply); // after the view's own update: ipywidgets listens first
  // A drag with continuous_update=False changes only the readout.
  view.$slider?.noUiSlider.on('update', apply);
}
