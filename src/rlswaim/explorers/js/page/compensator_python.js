// The call of the library and of python-control that gives the same closed loop with a compensator.
import { KINDS } from '../maths/compensator.js';
import { pythonOf } from './take_away.js';

/** @import { Compensator } from '../maths/compensator.js' */
/** @import { System, Values } from '../types.d.ts' */

/** A polynomial as python-control takes it, highest power first. @param {ArrayLike<number>} c */
const listOf = (c) => `[${Array.from(c).reverse().join(', ')}]`;

/**
 * The lines that make C.
 * @param {Compensator} compensator @param {string} [dt] what comes after the coefficients in discrete time
 */
export const linesOfC = ({ gain, sections }, dt = '') => [
  `C = control.tf([${gain}], [1]${dt})`,
  ...sections.map(({ kind, values }) => {
    const { N, D } = KINDS[kind].ratio(values);
    const told = `${KINDS[kind].text.toLowerCase()}: ${values.join(', ')}`;
    return `C *= control.tf(${listOf(N)}, ${listOf(D)}${dt})  # ${told}`;
  }),
];

/** @param {System} system @param {Values} values @param {Compensator | null} compensator in the loop */
export function pythonWith(system, values, compensator) {
  if (!compensator) return pythonOf(system, values);
  const { place } = compensator;
  const [before, call] = pythonOf(system, { ...values, [place]: null }).split('loop = ');
  const closed = call.split('\n')[0].replace(`${place}=null`, `${place}=${place}`);
  return [
    'import control',
    'from rlswaim.loops.cut_loop import cut_loop',
    before.trimEnd(),
    `L = cut_loop(lambda ${place}: ${closed}, ${values[place]})`,
    ...linesOfC(compensator),
    'loop = control.feedback(control.ss(C) * L)',
    'loop.poles()\n',
  ].join('\n');
}
