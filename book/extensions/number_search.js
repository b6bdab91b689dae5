/**
 * Lets the page of the search find numbers, and show no source code in its excerpts.
 *
 * Sphinx's own script is there already and starts to search after this one.  `WORDS_AND_NUMBERS`
 * stands in language_data.js; number_search.py writes it and makes the same words for the index.
 */

const EXCERPT = 240;

/** The index's word for a match of the pattern. @param {RegExpMatchArray} found */
function indexWord(found) {
  const [whole, power = '', mantissa = '', ...exponents] = found;
  if (!power && !mantissa) return whole;
  const digits = mantissa.replace(/[^0-9.]/g, '') || '1';
  const exponent = [power, ...exponents].join('').replace('\u2212', '-') || '0';
  return `=${Number(`${digits}e${exponent}`)}`;
}

/** A page's text as it is searched and shown. @param {string} page @param {string} anchor */
function textOf(page, anchor) {
  const parsed = new DOMParser().parseFromString(page, 'text/html');
  for (const left of parsed.querySelectorAll('.headerlink, script, style, .cell_input, .highlight'))
    left.remove();
  for (const raised of parsed.querySelectorAll('sup')) raised.prepend('^');
  const main = parsed.querySelector('[role="main"]');
  const part = anchor ? main?.querySelector(anchor) : null;
  return ((part ?? main)?.textContent ?? '').replace(/\\class\{[^}]*\}/g, '').replace(/\s+/g, ' ');
}

/**
 * The place of a word of the index in a text: of the whole number, else of one that starts so; -1 without.
 *
 * @param {string} text
 * @param {string} word
 */
function placeOf(text, word) {
  if (!word.startsWith('=')) return text.toLowerCase().indexOf(word);
  const numbers = [...text.matchAll(WORDS_AND_NUMBERS)];
  const whole = numbers.find((found) => indexWord(found) === word);
  return (whole ?? numbers.find((found) => indexWord(found).startsWith(word)))?.index ?? -1;
}

/** @param {string} query */
splitQuery = (query) => [...query.matchAll(WORDS_AND_NUMBERS)].map(indexWord);

Search.htmlToText = textOf;

/**
 * The excerpt around the first word that is found.
 * @param {string} page
 * @param {Set<string>} words
 * @param {string} anchor
 */
Search.makeSearchSummary = (page, words, anchor) => {
  const text = Search.htmlToText(page, anchor);
  if (!text) return null;
  const place = [...words].map((word) => placeOf(text, word)).find((at) => at > -1) ?? 0;
  const start = Math.max(place - EXCERPT / 2, 0);
  const excerpt = document.createElement('p');
  excerpt.classList.add('context');
  const shown = text.slice(start, start + EXCERPT).trim();
  excerpt.textContent = `${start ? '...' : ''}${shown}${start + EXCERPT < text.length ? '...' : ''}`;
  return excerpt;
};
