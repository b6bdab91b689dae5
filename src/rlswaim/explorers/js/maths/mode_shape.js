// The closed-loop motion at one pole, along the vehicle, from the numerators that Python sends.
import { evaluate } from './polynomials.js';
import { factorsOf, polynomial } from './terms.js';

const size = ([re, im]) => Math.hypot(re, im);
const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
const over = (z, w) => times(z, [w[0] / (w[0] ** 2 + w[1] ** 2), -w[1] / (w[0] ** 2 + w[1] ** 2)]);

// At a pole every input leaves the outputs in the same proportion; the one that rounding spoils least is taken: that whose
// values are largest beside the terms that they are sums of.
function proportions(system, state, { re, im }) {
  const factors = factorsOf(system, state);
  const radius = Math.hypot(re, im);
  let best = { clear: -Infinity };
  for (const outputs of Object.values(system.numerators)) {
    const values = {};
    let [clear, largest] = [0, 0];
    for (const [name, terms] of Object.entries(outputs)) {
      const N = polynomial(terms, factors);
      values[name] = evaluate(N, re, im);
      const all = evaluate(N.map(Math.abs), radius, 0)[0];
      const share = all > 0 ? size(values[name]) / all : 0;
      clear += Math.log(share + 1e-16);
      largest = Math.max(largest, share);
    }
    if (clear > best.clear && largest > 1e-12) best = { clear, values };
  }
  return best.values ?? null;
}

// The mode at a pole { re, im }: each output, the share of each coordinate in the deflection (root of mean square along the
// vehicle), and the deflection at each foot, down as z is, scaled to a largest size of 1 reached as a real number.
// null where the pole moves no output (an actuator's on its own).
export function modeShape(system, state, pole) {
  const values = proportions(system, state, pole);
  if (!values) return null;
  const { U, l_CG, phi_1, phi_2 } = system.vehicle;
  // z' = U (alpha - theta): a motion at s = 0 goes on sideways for good, and nothing else counts beside that.
  const p = [pole.re, pole.im];
  const sideways = values.alpha.map((v, k) => U * (v - values.theta[k]));
  const still = size(p) === 0 && size(sideways) > 0;
  const scale = still ? [0, 0] : [1, 0];
  const coordinates = {
    translation: [still || size(p) === 0 ? sideways : over(sideways, p), () => 1],
    theta: [times(scale, values.theta), (l) => l - l_CG],
    q1: [times(scale, values.q1), (l) => -phi_1[l]],
    q2: [times(scale, values.q2), (l) => -phi_2[l]],
  };
  const feet = Array.from(phi_1.keys());
  const shape = { re: new Float64Array(feet.length), im: new Float64Array(feet.length) };
  const weights = Object.entries(coordinates).map(([name, [value, along]]) => {
    let squares = 0;
    for (const l of feet) {
      const at = along(l);
      shape.re[l] += value[0] * at;
      shape.im[l] += value[1] * at;
      squares += at * at;
    }
    return [name, size(value) * Math.sqrt(squares / feet.length)];
  });
  const total = weights.reduce((sum, [, weight]) => sum + weight, 0);
  if (total === 0) return null;
  const largest = feet.reduce(
    (best, l) =>
      Math.hypot(shape.re[l], shape.im[l]) > Math.hypot(shape.re[best], shape.im[best]) ? l : best,
    0,
  );
  const unit = [shape.re[largest], shape.im[largest]];
  for (const l of feet) [shape.re[l], shape.im[l]] = over([shape.re[l], shape.im[l]], unit);
  return {
    ...Object.fromEntries(Object.entries(values).map(([name, value]) => [name, over(value, unit)])),
    shares: Object.fromEntries(weights.map(([name, weight]) => [name, weight / total])),
    shape,
  };
}
