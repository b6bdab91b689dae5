// Numbers as text, and from the text that a reader types.

const grouped = new Intl.NumberFormat('en', { maximumFractionDigits: 20 });

/** For a reader, with so many digits: 1,234, −0.05, 6.7·10⁻⁴. @param {number} value */
export function number(value, count = 4) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (value === 0) return '0';
  if (size >= 1e-3 && size < 1e9) {
    const rounded = Number(value.toPrecision(count));
    const text = size < 999 ? String(rounded) : grouped.format(rounded); // grouping takes its time
    return text.replace('-', '−');
  }
  const [digits, power] = value.toExponential(count - 1).split('e');
  const raised = [...power.replace('+', '')].map((d) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(d)]).join('');
  return `${Number(digits)}·10${raised}`.replace('-', '−');
}

/** @param {number} value @param {number} [count] */
export const signed = (value, count) => (value > 0 ? '+' : '') + number(value, count);

/** @param {number} re @param {number} im */
export const complex = (re, im) =>
  im === 0 ? number(re) : `${number(re)} ${im < 0 ? '−' : '+'} ${number(Math.abs(im))}j`;

/** For a table that programs read too: always so many digits. @param {number} value @param {number} count */
export function digits(value, count) {
  if (Number.isNaN(value)) return '–';
  if (value !== 0 && Math.abs(value) < 1e-3) return value.toExponential(count - 1);
  return value === 0 ? '0' : value.toPrecision(count);
}

/** What a reader typed, with a point or a comma; NaN for what is no number. @param {string} text */
export const typedNumber = (text) => (text.trim() === '' ? NaN : Number(text.replace(',', '.')));
