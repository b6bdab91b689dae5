// Each parameter and the place of its slider keep each other: a slider that moves sets the value, a value set
// otherwise moves the slider to the nearest place and stays as it is.
/** @import { Context, Parameter } from '../types.d.ts' */

/** @param {Parameter} parameter @param {any} value */
export function nearest({ grid }, value) {
  const off = grid.map((place) =>
    typeof place === 'string' ? Number(place !== value) : Math.abs(place - value),
  );
  return off.indexOf(Math.min(...off));
}

/** @param {Context} context */
export function initialize({ model }) {
  for (const parameter of model.get('payload').parameters ?? []) {
    const { name, grid } = parameter;
    const place = `${name}_at`;
    model.on(`change:${name}`, () => {
      const at = nearest(parameter, model.get(name));
      if (at < 0 || at === model.get(place)) return;
      model.set(place, at);
      model.save_changes();
    });
    model.on(`change:${place}`, () => {
      const at = model.get(place);
      if (nearest(parameter, model.get(name)) === at) return;
      model.set(name, grid[at]);
      model.save_changes();
    });
  }
}
