// Values that depend on a few places of the sliders alone, kept while other sliders move: the last ones of each system.

const MOST = 24;
/** @type {WeakMap<object, Map<string, any>>} */
const memory = new WeakMap();

/**
 * The value of a key, made when it is asked for first.
 * @template T
 * @param {object} system
 * @param {string} key
 * @param {() => T} make
 * @returns {T}
 */
export function once(system, key, make) {
  const values = memory.get(system) ?? new Map();
  memory.set(system, values);
  const value = values.get(key) ?? make();
  values.delete(key);
  values.set(key, value);
  if (values.size > MOST) values.delete(values.keys().next().value);
  return value;
}

/**
 * A function that makes its value at its first call and keeps it.
 * @template T
 * @param {() => T} make
 * @returns {() => T}
 */
export function lazy(make) {
  /** @type {T | undefined} */
  let value;
  return () => {
    value ??= make();
    return value;
  };
}
