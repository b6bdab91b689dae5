// Reads an expression in s or z: 5 (s+1)/(s (s^2 + 2s + 5)), (s+1)^2, z^-1. Nothing is run: it is taken apart
// letter by letter.
import { added, constant, divided, multiplied, raised, variable } from './fractions.js';
import { LoopError, quoted } from './loop_error.js';
import { bounded, UNSIGNED } from './numbers.js';

/** @typedef {import('./fractions.js').Fraction} Fraction */
/** @typedef {{ kind: 'number' | 'unit' | 'name' | 'sign', text: string, at: number }} Token */

const DEEPEST = 60; // brackets within brackets
const TOKEN = new RegExp(
  String.raw`\s*(?:(?<number>${UNSIGNED})|(?<unit>[ij])(?![A-Za-z])|` +
    String.raw`(?<name>[A-Za-z_]\w*)|(?<sign>\*\*|[-+*/^()]))`,
  'y',
);

/** @param {string} text @param {string} where @returns {Token[]} */
function tokensOf(text, where) {
  const found = [];
  TOKEN.lastIndex = 0;
  while (text.slice(TOKEN.lastIndex).trim()) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match) throw new LoopError(where, quoted(text.slice(at)), 'an expression in s or z');
    const [kind, token] = Object.entries(match.groups).find(([, part]) => part !== undefined);
    found.push({ kind: /** @type {Token['kind']} */ (kind), text: token, at });
  }
  return found;
}

class Reader {
  /** @param {string} text @param {string} where */
  constructor(text, where) {
    this.text = text;
    this.where = where;
    this.tokens = tokensOf(text, where);
    this.place = 0;
    this.depth = 0;
    this.letter = '';
  }

  get next() {
    return this.tokens[this.place];
  }

  /** @param {...string} signs */
  takes(...signs) {
    const { next } = this;
    if (next?.kind !== 'sign' || !signs.includes(next.text)) return '';
    this.place++;
    return next.text;
  }

  /** @param {string} wanted @returns {never} */
  refuse(wanted) {
    const got = this.next ? quoted(this.text.slice(this.next.at)) : 'its end';
    throw new LoopError(this.where, got, wanted);
  }

  /** @returns {Fraction} */
  sum() {
    if (++this.depth > DEEPEST) this.refuse(`at most ${DEEPEST} brackets within each other`);
    let found = this.takes('-') ? multiplied(constant([-1, 0]), this.product()) : this.product();
    for (let sign = this.takes('+', '-'); sign; sign = this.takes('+', '-'))
      found = added(found, this.product(), sign === '+' ? 1 : -1);
    this.depth--;
    return found;
  }

  /** @returns {Fraction} */
  product() {
    let found = this.power();
    let divides = false;
    for (;;) {
      const sign = this.takes('*', '/');
      if (!sign && !this.#startsFactor()) return found;
      if (!sign && divides) this.refuse('brackets after a “/”: 1/(s (s+1)) or (1/s) (s+1)');
      divides = sign === '/';
      const other = this.power();
      found = divides ? divided(found, other) : multiplied(found, other);
    }
  }

  #startsFactor() {
    const { next } = this;
    return next && (next.kind !== 'sign' || next.text === '(');
  }

  /** @returns {Fraction} */
  power() {
    if (this.takes('+')) return this.power();
    if (this.takes('-')) return multiplied(constant([-1, 0]), this.power());
    const base = this.factor();
    if (!this.takes('^', '**')) return base;
    const isBracketed = this.takes('(');
    const minus = this.takes('-');
    const { next } = this;
    const size = next?.kind === 'number' ? Number(next.text) : NaN;
    if (!Number.isInteger(size) || size > 60) this.refuse('a whole power up to 60');
    this.place++;
    if (isBracketed && !this.takes(')')) this.refuse('“)”');
    return raised(base, minus ? -size : size);
  }

  /** @returns {Fraction} */
  factor() {
    const { next } = this;
    if (!next) this.refuse('a number, a letter or a bracket');
    if (this.takes('(')) {
      const found = this.sum();
      if (!this.takes(')')) this.refuse('“)”');
      return found;
    }
    if (next.kind === 'sign') this.refuse('a number, a letter or a bracket');
    if (next.kind === 'name') return this.#letter(next.text);
    this.place++;
    if (next.kind === 'unit') return constant([0, 1]);
    const value = bounded(Number(next.text), this.where, next.text);
    const after = this.next;
    if (after?.kind === 'unit' && this.text[after.at] === after.text) {
      this.place++;
      return constant([0, value]);
    }
    return constant([value, 0]);
  }

  /** @param {string} name @returns {Fraction} */
  #letter(name) {
    const letter = name.toLowerCase();
    if (letter !== 's' && letter !== 'z' && letter !== 'p') this.refuse('s or z as the only letter');
    if (this.letter && this.letter !== letter) this.refuse(`${this.letter} alone, as before`);
    this.letter = letter;
    this.place++;
    return variable();
  }
}

/**
 * The fraction that an expression is, and its letter ('' for a mere number).
 * @param {string} text
 * @param {string} where
 */
export function fractionFrom(text, where) {
  const reader = new Reader(text, where);
  const fraction = reader.sum();
  if (reader.next) reader.refuse('the end of the expression');
  return { fraction, letter: reader.letter };
}
