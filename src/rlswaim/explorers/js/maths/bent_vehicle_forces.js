// The forces on the bent vehicle: sums of the motions by the coefficients that Python sends.

/** @typedef {Record<string, number>} Motions q_1, q_2 (ft), theta, alpha, delta (degrees) */
/** @typedef {{ name: string, station: number, rows: Record<string, Motions>, incidence: Motions }} Source */
/** @typedef {{ sources: Source[], shapes: Record<string, number[]>, l_CG: number }} Vehicle */
/** @typedef {Record<string, number>} Loads F_z (down), M_y (nose up), Q_1z and Q_2z as Z, M, F1, F2 */

export const ROWS = ['Z', 'M', 'F1', 'F2'];
export const RADIAN = Math.PI / 180;

/** @param {Motions} coefficients @param {Motions} motions */
const dot = (coefficients, motions) =>
  Object.entries(coefficients).reduce((sum, [name, c]) => sum + c * motions[name], 0);

/** The loads of each source, and their sums. @param {Vehicle} vehicle @param {Motions} motions */
export function loads({ sources }, motions) {
  const each = sources.map(({ name, rows, incidence }) => ({
    name,
    incidence: dot(incidence, motions),
    loads: /** @type {Loads} */ (Object.fromEntries(ROWS.map((row) => [row, dot(rows[row], motions)]))),
  }));
  /** @type {Loads} */
  const sum = Object.fromEntries(
    ROWS.map((row) => [row, each.reduce((total, source) => total + source.loads[row], 0)]),
  );
  return { each, sum };
}

/**
 * Height (ft, up) of the axis that pitch turns.
 * @param {Vehicle} vehicle @param {Motions} motions @param {number} at ft
 */
export const rigidHeight = (vehicle, motions, at) => motions.theta * RADIAN * (vehicle.l_CG - at);

/**
 * Height (ft, up) of the bent axis.
 * @param {Vehicle} vehicle @param {Motions} motions @param {number} at ft
 */
export function height(vehicle, motions, at) {
  const { phi_1, phi_2 } = vehicle.shapes;
  return rigidHeight(vehicle, motions, at) + motions.q_1 * phi_1[at] + motions.q_2 * phi_2[at];
}
