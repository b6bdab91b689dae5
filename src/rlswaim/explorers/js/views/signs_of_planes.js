// The legend of a workbench's planes.

/** @import { System } from '../types.d.ts' */

/** What the signs of the planes mean. @param {System} system @returns {[string, string][]} */
export const signsOf = ({ running, maps, given }) => [
  ['×', 'open-loop pole'],
  ['○', 'open-loop zero'],
  ['■ ● ▲ ◆ ▼', 'closed-loop poles, as in the table'],
  ['▸', 'rising gain'],
  ['◇', 'crossing: gain and ω'],
  [
    '•',
    maps.length
      ? `break-away; in the map, every ${running[maps[0]].every ?? 100} ${running[maps[0]].unit}`
      : 'break-away',
  ],
  ['╌', 'a pair whose roots left different poles'],
  .../** @type {[string, string][]} */ (given ? [] : [['+', 'printed in the report']]),
];
