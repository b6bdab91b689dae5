// What is wrong with a loop that was typed or pasted: what, where, got, wanted.

const LONGEST = 40; // characters of a text that are shown

/** @param {string} text */
export const quoted = (text) => {
  const flat = text.trim().replace(/\s+/g, ' ');
  return `“${flat.length > LONGEST ? `${flat.slice(0, LONGEST)}…` : flat}”`;
};

export class LoopError extends Error {
  /** @param {string} what and where @param {string} got @param {string} wanted */
  constructor(what, got, wanted) {
    super(`${what}: got ${got}, wanted ${wanted}`);
  }
}
