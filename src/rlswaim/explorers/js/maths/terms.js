// The table of terms that Python sends: (product of factors) x (polynomial). Nothing here knows any physics.

/** @typedef {{ factors: string[], coefficients: ArrayLike<number> }} Term constant term first */
/** @typedef {Record<string, any>} State the value of each parameter by its name */
/** @typedef {Record<string, number>} Factors */
/** @typedef {{ re: number, im: number, branch: string, at?: string, each?: ArrayLike<number> }} OpenPole */
/**
 * What Python sends of a control system (see payload in control_systems.py).
 * @typedef {{ terms: Term[], shapes: Record<string, import('./shapes.js').Shape>,
 *   choice?: { name: string, zero: Record<string, string[]> }, locus_gains: string[], maps: string[],
 *   parameters: { name: string }[], poles: OpenPole[],
 *   actuators: { factor: string, branch: string }[], numerators: Record<string, Record<string, Term[]>>,
 *   running: Record<string, any>, vehicle: Record<string, any>,
 *   plant?: import('./vehicle_data.js').Plant, base?: any,
 *   loop?: import('../reading/given_loop.js').GivenRoots, through?: Through }} System loop: one that a reader
 *   gave; through: the compensator N/D in the path of the gain at its place
 * @typedef {{ place: string, N: number[], D: number[] }} Through
 */

/**
 * The value of each factor of the table: a parameter itself, or a mode's shape at the station that a
 * parameter gives.
 * @param {System} system
 * @param {State} state
 * @returns {Factors}
 */
export function factorsOf(system, state) {
  const factors = { ...state };
  for (const [factor, shape] of Object.entries(system.shapes))
    factors[factor] = along(shape.values, state[shape.at]);
  for (const factor of leftOut(system, state)) factors[factor] = 0;
  return factors;
}

/**
 * The factors that the present choice sets to 0.
 * @param {System} system
 * @param {State} state
 * @returns {string[]}
 */
export const leftOut = ({ choice }, state) => (choice ? (choice.zero[state[choice.name]] ?? []) : []);

/**
 * The table has one value a foot; between two of them the picture takes the straight line, at an end and
 * beyond it the value there.
 * @param {ArrayLike<number>} values
 * @param {number} station (ft)
 */
export function along(values, station) {
  const last = values.length - 1;
  const at = Math.max(0, Math.min(station, last));
  const left = Math.min(Math.floor(at), last - 1);
  return values[left] + (at - left) * (values[left + 1] - values[left]);
}

/** What excites a system. @param {System} system @returns {string[]} */
export const inputsOf = ({ plant, numerators }) =>
  numerators ? Object.keys(numerators) : [...plant.inputs, ...plant.initial.map((name) => `${name}(0)`)];

/** @param {Term[]} terms */
export const longest = (terms) => terms.reduce((most, term) => Math.max(most, term.coefficients.length), 1);

/**
 * The product of a term's factors.
 * @param {Term} term
 * @param {Factors} factors
 */
export function weightOf(term, factors) {
  let weight = 1;
  for (const f of term.factors) weight *= factors[f];
  return weight;
}

/**
 * Multiplies out all factors but the free ones: a shorter table of the same kind.
 * @param {Term[]} terms
 * @param {Factors} factors
 * @param {string[]} free
 * @returns {Term[]}
 */
export function collapse(terms, factors, free) {
  /** @type {Map<string, { factors: string[], coefficients: Float64Array }>} */
  const merged = new Map();
  const size = longest(terms);
  for (const term of terms) {
    const left = term.factors.filter((f) => free.includes(f));
    const held = { ...term, factors: term.factors.filter((f) => !free.includes(f)) };
    const key = left.join();
    const sum = merged.get(key) ?? { factors: left, coefficients: new Float64Array(size) };
    merged.set(key, sum);
    addTerm(sum.coefficients, term, weightOf(held, factors));
  }
  return [...merged.values()];
}

/**
 * @param {Float64Array} sum
 * @param {Pick<Term, 'coefficients'>} term
 * @param {number} weight
 */
export function addTerm(sum, { coefficients }, weight) {
  for (let k = 0; k < coefficients.length; k++) sum[k] += weight * coefficients[k];
}

/**
 * Fills c with the polynomial of a table at the values of its factors.
 * @param {Term[]} table
 * @param {Factors} factors
 * @param {Float64Array} c
 */
export function fill(table, factors, c) {
  c.fill(0);
  for (const term of table) addTerm(c, term, weightOf(term, factors));
  return c;
}

/**
 * The polynomial of a list of terms at the values of its factors, constant term first.
 * @param {Term[]} terms
 * @param {Factors} factors
 */
export const polynomial = (terms, factors) => fill(terms, factors, new Float64Array(longest(terms)));

/**
 * The closed-loop characteristic polynomial.
 * @param {System} system
 * @param {State} state
 */
export const polynomialOf = (system, state) => polynomial(system.terms, factorsOf(system, state));
