// Where the scripts under test are.
const folder = new URL('../../src/rlswaim/explorers/js/maths/', import.meta.url);

/** @param {string} name */
export const maths = (name) => import(new URL(`${name}.js`, folder).href);
