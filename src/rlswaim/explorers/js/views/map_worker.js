// Runs beside the page: { id, plan } in, { id, parts } out every few milliseconds; a new plan ends the old
// one.
import { rows } from '../maths/abscissa.js';
import { inSlices } from '../page/slices.js';

const SLICE = 20; // ms

let stop = () => {};

addEventListener('message', ({ data: { id, plan } }) => {
  stop();
  stop = inSlices(rows(plan), SLICE, ({ parts }) => postMessage({ id, parts }));
});
