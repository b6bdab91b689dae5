// What mouse, fingers and keys do on a workbench.
import { element, panel } from '../page/elements.js';

const HELP = [
  ['drag a filled mark', 'move a closed-loop pole along its locus: the slider follows'],
  ['click the locus', 'set the running parameter; hover reads gain, ω and ζ'],
  ['click a filled mark, or Enter on it', 'show its mode shape along the vehicle'],
  ['click the pole map, or drag a mark on it', 'pick the station'],
  ['hover a frequency response', 'mark the frequency in Bode, Nichols, Nyquist and on the axis of the locus'],
  [
    'drag a frequency response',
    'up or down: set the running gain; so do the arrows, left and right the mark',
  ],
  ['drag a dotted ring', 'move a pole or zero of the compensator; on the Bode diagram its frequency'],
  ['hatched', 'where the requirements let no pole be'],
  ['wheel, pinch, + and −', 'zoom'],
  ['drag the plane, Shift + arrows', 'pan'],
  ['double click, 0', 'fit the window again'],
  ['Tab', 'from the plane to each pole'],
  ['arrows, Page Up, Page Down', 'on the plane or a pole: step the running parameter'],
  ['arrows on a slider', 'to the next round number; with Alt by the finest step, with Shift by decades'],
  ['Ctrl + Z, Ctrl + Shift + Z', 'undo, redo'],
];

export function helpPanel() {
  const entries = HELP.flatMap(([key, meaning]) => [element('dt', {}, key), element('dd', {}, meaning)]);
  return panel('help', 'Keys and gestures', () => {}, element('dl', {}, ...entries)).node;
}
