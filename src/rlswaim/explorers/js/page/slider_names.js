// What a screen reader says of a slider: its parameter's meaning, and the value with its unit instead of the
// slider's place. The book's pages name all controls by themselves; JupyterLab does not.

/** @import { Model, Parameter } from '../types.d.ts' */

/**
 * Names the sliders that have no name yet. Returns what stops it.
 * @param {Element} panel with a row for each of the parameters
 * @param {Parameter[]} parameters @param {Model} model
 */
export function nameSliders(panel, parameters, model) {
  const numbers = parameters.filter(({ grid }) => typeof grid[0] !== 'string');
  const stops = [...panel.querySelectorAll('.widget-hbox')].map((row, k) => {
    const handle = row.querySelector('[role=slider]');
    if (!numbers[k] || !handle || handle.hasAttribute('aria-label')) return () => {};
    const { name, meaning = name, unit = '' } = numbers[k];
    const tell = () => handle.setAttribute('aria-valuetext', `${model.get(name)} ${unit}`.trim());
    handle.setAttribute('aria-label', meaning);
    tell();
    model.on(`change:${name}`, tell);
    return () => model.off(`change:${name}`, tell);
  });
  return () => {
    for (const stop of stops) stop();
  };
}
