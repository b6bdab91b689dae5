// Reads one's own loop from a text that was typed or pasted, in any of the forms that it is written in.
import { listFrom, rowsFrom } from './arrays.js';
import { fractionFrom } from './expressions.js';
import { LoopError, quoted } from './loop_error.js';
import { loopOfFraction } from './loop_of_fraction.js';
import { realFrom } from './numbers.js';
import {
  assignments,
  callIn,
  partsOf,
  plainText,
  samplingTime,
  toldTime,
  withoutSurroundings,
} from './statements.js';

/** @typedef {import('./numbers.js').Complex} Complex */
/** @typedef {import('./statements.js').SamplingTime} SamplingTime */
/** @typedef {{ form: 'fraction', num: number[], den: number[], dt: SamplingTime }} FractionLoop */
/**
 * @typedef {{ form: 'factors', zeros: Complex[], poles: Complex[], gain: number, dt: SamplingTime }}
 *   FactorsLoop
 */
/**
 * @typedef {{ form: 'states', A: number[][], B: number[][], C: number[][], D: number, dt: SamplingTime }}
 *   StatesLoop
 */
/** A loop as it was given; polynomials have their highest power first. */
/** @typedef {FractionLoop | FactorsLoop | StatesLoop} GivenLoop */

const LONGEST = 20_000; // characters
/** @type {Record<string, string[]>} */
const NAMES = {
  num: ['num', 'numerator', 'N'],
  den: ['den', 'denominator'],
  zeros: ['zeros', 'z', 'Z'],
  poles: ['poles', 'p', 'P'],
  gain: ['gain', 'k', 'K'],
  dt: ['dt', 'Ts'],
};

/** @param {Complex[]} list @param {string} name */
function reals(list, name) {
  const at = list.findIndex(([, im]) => im !== 0);
  if (at >= 0) throw new LoopError(`${name}[${at}]`, `${list[at][0]} + ${list[at][1]}j`, 'a real number');
  return list.map(([re]) => re);
}

/** @param {string} text @param {string} name */
const realRows = (text, name) => rowsFrom(text, name).map((row) => reals(row, name));

/** @param {string} num @param {string} den @param {SamplingTime} dt @returns {FractionLoop} */
const fractionOf = (num, den, dt) => ({
  form: 'fraction',
  num: reals(listFrom(unnested(num), 'numerator'), 'numerator'),
  den: reals(listFrom(unnested(den), 'denominator'), 'denominator'),
  dt,
});

/** Without the brackets around a list's brackets: {[1 2]}, [[[1, 2]]]. @param {string} text */
function unnested(text) {
  let plain = text.trim();
  while (/^\{[\s\S]*\}$|^\[\s*\[[^[\]]*\]\s*\]$|^\[\s*\[\s*\[[^[\]]*\]\s*\]\s*\]$/.test(plain))
    plain = plain.slice(1, -1).trim();
  return plain;
}

/** @param {string} zeros @param {string} poles @param {string} gain @param {SamplingTime} dt */
const factorsOf = (zeros, poles, gain, dt) => ({
  form: /** @type {const} */ ('factors'),
  zeros: listFrom(unnested(zeros), 'zeros'),
  poles: listFrom(unnested(poles), 'poles'),
  gain: realFrom(gain.replace(/^\[+|\]+$/g, ''), 'gain'),
  dt,
});

/** @param {string[]} texts of A, B, C, D @param {SamplingTime} dt @returns {StatesLoop} */
function statesOf([a, b, c, d = '0'], dt) {
  const A = realRows(a, 'A');
  const [B, C] = [realRows(b, 'B'), realRows(c, 'C')];
  const n = A.length;
  const column = B.length === 1 && n > 1 ? B[0].map((value) => [value]) : B; // a list will do
  const row = C.length === n && n > 1 && C[0].length === 1 ? [C.map(([value]) => value)] : C;
  /** @type {[string, number[][], number, number][]} */
  const shapes = [
    ['A', A, n, n],
    ['B', column, n, 1],
    ['C', row, 1, n],
    ['D', realRows(d, 'D'), 1, 1],
  ];
  for (const [name, rows, height, width] of shapes)
    if (rows.length !== height || rows[0].length !== width)
      throw new LoopError(
        `shape of ${name}`,
        `${rows.length} × ${rows[0]?.length ?? 0}`,
        `${height} × ${width} (one input, one output)`,
      );
  return { form: 'states', A, B: column, C: row, D: shapes[3][1][0][0], dt };
}

/**
 * @param {NonNullable<ReturnType<typeof callIn>>} call
 * @param {Map<string, string>} values of names
 * @param {SamplingTime} told
 */
function fromCall({ kind, ordered, named }, values, told) {
  const inputs = /** @type {Record<string, number>} */ ({ tf: 2, zpk: 3, ss: 4 })[kind];
  /** @param {string} text */
  const known = (text) => values.get(text.trim()) ?? text;
  const time = named.dt ?? named.Ts ?? (ordered[inputs]?.startsWith("'") ? undefined : ordered[inputs]);
  const dt = time === undefined ? told : samplingTime(known(time));
  const given = ordered.slice(0, inputs).map(known);
  if (given.length < (kind === 'ss' ? 3 : inputs))
    throw new LoopError(`arguments of ${kind}`, String(given.length), String(inputs));
  if (kind === 'tf') return fractionOf(given[0], given[1], dt);
  if (kind === 'zpk') return factorsOf(given[0], given[1], given[2], dt);
  return statesOf(given, dt);
}

/**
 * From values of names; null if the names say nothing.
 * @param {Map<string, string>} values
 * @param {SamplingTime} dt
 */
function fromNames(values, dt) {
  /** @param {string} name */
  const of = (name) => NAMES[name].map((key) => values.get(key)).find((text) => text !== undefined);
  /** @param {string} name @param {string} other */
  const missing = (name, other) => new LoopError(name, 'nothing', `a value beside ${other}`);
  if (values.has('A')) {
    for (const name of ['B', 'C']) if (!values.has(name)) throw missing(name, 'A');
    return statesOf(
      ['A', 'B', 'C', 'D'].map((name) => values.get(name)),
      dt,
    );
  }
  const [num, den, poles, gain] = [of('num'), of('den'), of('poles'), of('gain')];
  if (num !== undefined || den !== undefined) {
    if (num === undefined) throw missing('numerator', 'the denominator');
    if (den === undefined) throw missing('denominator', 'the numerator');
    return fractionOf(num, den, dt);
  }
  if (poles !== undefined) return factorsOf(of('zeros') ?? '', poles, gain ?? '1', dt);
  if (of('zeros') !== undefined && values.size > 1) throw missing('poles', 'the zeros');
  return null;
}

/** A fraction as programs print it: above and below a line of dashes. @param {string} text */
function printedFraction(text) {
  const lines = text.split('\n');
  const rules = lines.flatMap((line, i) => (/^\s*-{3,}\s*$|^\s*-\s*$/.test(line) ? [i] : []));
  if (rules.length === 0) return null;
  if (rules.length > 1) throw new LoopError('fraction lines', String(rules.length), 'one: a single loop');
  /** @param {string[]} part */
  const joined = (part) => part.join(' ').trim();
  const [above, below] = [joined(lines.slice(0, rules[0])), joined(lines.slice(rules[0] + 1))];
  if (!above) throw new LoopError('numerator', 'nothing', 'an expression above the line');
  if (!below) throw new LoopError('denominator', 'nothing', 'an expression below the line');
  return `(${above.replace(/^[A-Za-z]\w*(?:\(\w\))?\s*=/, '')})/(${below})`;
}

/**
 * The loop that a text gives.
 * @param {string} given
 * @returns {GivenLoop}
 */
export function readLoop(given) {
  if (given.length > LONGEST)
    throw new LoopError('length of the text', `${given.length} characters`, `at most ${LONGEST}`);
  const text = plainText(given);
  const told = toldTime(text);
  const plain = withoutSurroundings(text);
  if (!plain.trim()) throw new LoopError('the loop', 'no text', 'a fraction, factors, or A, B, C, D');
  const values = assignments(plain);
  const time = values.get('dt') ?? values.get('Ts');
  const dt = time === undefined ? (told ?? 0) : samplingTime(partsOf(time, '\n')[0]);
  const call = callIn(plain);
  const found = call ? fromCall(call, values, dt) : (fromNames(values, dt) ?? fromTriple(plain, dt));
  if (found) return found;
  const formula = plain.replace(/^[^\S\n]*(?:dt|Ts)\s*[=:].*$/gm, '');
  const fraction = printedFraction(formula) ?? formula.trim().replace(/^[A-Za-z]\w*(?:\(\w\))?\s*=/, '');
  const isTold = time !== undefined || told !== undefined;
  return loopOfFraction(fractionFrom(fraction.replace(/;\s*$/, ''), 'the expression'), dt, isTold);
}

/** (zeros, poles, gain), as rlswaim takes it. @param {string} text @param {SamplingTime} dt */
function fromTriple(text, dt) {
  const first = text.trim().split('\n\n')[0];
  const inner = /^\(\s*(\[[\s\S]*\][\s\S]*)\)$/.exec(first)?.[1];
  if (!inner) return null;
  const [zeros, poles, gain, ...more] = partsOf(inner, ',').filter((part) => part.trim());
  if (gain === undefined || more.length) throw new LoopError('factors', quoted(text), '(zeros, poles, gain)');
  return factorsOf(zeros, poles, gain.trim(), dt);
}
