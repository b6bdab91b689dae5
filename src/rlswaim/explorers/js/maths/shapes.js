// What a station enters the equations by: arms, deflections and slopes at each foot of the vehicle.

/** @import { Values } from '../types.d.ts' */
/** @import { Bent } from './vehicle_data.js' */
/** @typedef {{ at: string, kind?: string, mode?: number, values: ArrayLike<number> }} Shape */

const FEET = 421;

/** @param {Bent} bent @param {string} kind @param {number} mode @param {number} station */
function valueAt({ l_CG, phi }, kind, mode, station) {
  if (kind === 'arm') return station - l_CG;
  const [deflection, derivative] = phi(mode, station);
  return kind === 'slope' ? -derivative : deflection;
}

/** @param {Bent} bent @param {string} kind @param {number} mode */
const valuesAtFeet = (bent, kind, mode) =>
  Float64Array.from({ length: FEET }, (_, foot) => valueAt(bent, kind, mode, foot));

/** The deflections of both modes at each foot, by the names of `System.vehicle`. @param {Bent} bent */
export const deflectionsAlong = (bent) => ({
  phi_1: valuesAtFeet(bent, 'deflection', 0),
  phi_2: valuesAtFeet(bent, 'deflection', 1),
});

/**
 * The shapes of a system along the whole vehicle.
 * @param {Record<string, Shape>} shapes @param {Bent} bent
 */
export const shapesAlong = (shapes, bent) =>
  Object.fromEntries(
    Object.entries(shapes).map(([factor, shape]) => [
      factor,
      { ...shape, values: valuesAtFeet(bent, shape.kind, shape.mode) },
    ]),
  );

/**
 * The same at the two feet beside each station alone.
 * @param {{ shapes: Record<string, Shape> }} system @param {Bent} bent @param {Values} state
 */
export const shapesNear = ({ shapes }, bent, state) =>
  Object.fromEntries(
    Object.entries(shapes).map(([factor, shape]) => {
      const left = Math.max(0, Math.min(Math.floor(state[shape.at]), FEET - 2));
      /** @type {Record<number, number> & { length: number }} */
      const values = { length: FEET };
      for (const foot of [left, left + 1]) values[foot] = valueAt(bent, shape.kind, shape.mode, foot);
      return [factor, { ...shape, values }];
    }),
  );
