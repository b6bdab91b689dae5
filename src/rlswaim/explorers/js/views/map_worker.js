// Runs beside the page: { id, plan } in, { id, rows } out every few milliseconds; a new plan ends the old one.
import { rows } from '../maths/abscissa.js';

let current = 0;

onmessage = ({ data: { id, plan } }) => {
  current = id;
  const left = rows(plan);
  const work = () => {
    if (current !== id) return;
    const found = [];
    const until = performance.now() + 20;
    let next = { done: false };
    while (!next.done && performance.now() < until) {
      next = left.next();
      if (!next.done) found.push(next.value);
    }
    postMessage({ id, rows: found });
    if (!next.done) setTimeout(work);
  };
  work();
};
