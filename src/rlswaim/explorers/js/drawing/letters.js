// The letters that names stand for.

/** @type {Record<string, string>} */
const LETTER = {
  eta: 'η',
  alpha: 'α',
  theta: 'θ',
  q1: 'q₁',
  q2: 'q₂',
  delta: 'δ',
  delta_r: 'δᵣ',
  omega: 'ω',
};

/** A name as its letter, or as it is where it stands for none. @param {string} name */
export const letterOf = (name) => LETTER[name] ?? name;
