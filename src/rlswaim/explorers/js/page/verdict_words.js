// The state of the system in words and numbers.
import { complex, number } from './dom.js';

const READ_OFF = 0.05; // of a root's size, at least of .1 1/s: what a plotted locus tells

function spoken(pole, poles) {
  const at = `${pole.re > 0 ? '+' : ''}${number(pole.re)}`;
  if (pole.im === 0) return `a real root at ${at} 1/s (from ${pole.name})`;
  const off = poles.map((p) => Math.hypot(p.re - pole.re, p.im + pole.im));
  const twin = poles[off.indexOf(Math.min(...off))].name;
  return `a pair at ${at} ± ${number(pole.im)}j 1/s (from ${twin === pole.name ? twin : `${pole.name} and ${twin}`})`;
}

// In words: is it stable, and why.
export function verdict(poles) {
  const upper = poles.filter((p) => p.im >= 0).sort((a, b) => b.re - a.re);
  const bad = upper.filter((p) => p.re > 0);
  const worst = bad[0] ?? upper[0];
  if (bad.length) {
    const count = poles.filter((p) => p.re > 0).length;
    const also = bad.slice(1).map((p) => spoken(p, poles));
    return {
      word: 'unstable',
      short: `Unstable: ${count} of ${poles.length} roots ${count > 1 ? 'lie' : 'lies'} right of the imaginary axis.`,
      long: ` because of ${spoken(worst, poles)}: its motion doubles every ${number(Math.LN2 / worst.re, 3)} s.${
        also.length ? ` Also right of the axis: ${also.join('; ')}.` : ''
      }`,
    };
  }
  if (worst.re === 0) {
    return {
      word: 'neutral',
      short: 'Neutrally stable: a root lies on the imaginary axis.',
      long: `: ${spoken(worst, poles)} neither grows nor decays.`,
    };
  }
  return {
    word: 'stable',
    short: 'Stable: all roots lie left of the imaginary axis.',
    long: `: all roots lie left of the imaginary axis. The slowest is ${spoken(worst, poles)}; its motion halves every ${number(-Math.LN2 / worst.re, 3)} s.`,
  };
}

// Where the branches cross the imaginary axis, after the name of what runs.
export function crossingWords(crossings) {
  const list = crossings.map(
    (c) => `${number(c.gain)} (ω = ${number(c.omega)} rad/s, to the ${c.direction > 0 ? 'right' : 'left'})`,
  );
  return list.length
    ? `: imaginary axis crossed at ${list.join(', ')}.`
    : ': no branch crosses the imaginary axis.';
}

const signed = (value, count) => `${value > 0 ? '+' : ''}${number(value, count)}`;

export function marginWords(margins) {
  if (!margins) return '';
  const gain = margins.gain.map(
    (m) => `${signed(m.dB, 3)} dB (×${number(m.factor, 3)}, ω = ${number(m.omega, 3)} rad/s)`,
  );
  const phase = margins.phase.map((m) => `${signed(m.degrees, 3)}° (ω = ${number(m.omega, 3)} rad/s)`);
  const list = (words) => (words.length ? words.join(', ') : 'none');
  return `Gain margins: ${list(gain)}. Phase margins: ${list(phase)}.`;
}

// The report's roots beside those of the loop that is drawn, each with the one nearest to it.
export function printedWords(printed, { x, y }) {
  if (printed.length === 0) return '';
  const off = [];
  for (const { re, im, text } of printed) {
    const far = Array.from(x, (v, i) => Math.hypot(v - re, y[i] - im));
    const at = far.indexOf(Math.min(...far));
    if (far[at] > READ_OFF * Math.max(Math.hypot(re, im), 0.1))
      off.push(`${text} (nearest here ${complex(x[at], y[at])})`);
  }
  const count = `Printed roots (+): ${printed.length}, `;
  return off.length
    ? `${count}of which ${off.length} more than a plot’s reading off: ${off.join('; ')}.`
    : `${count}all within a plot’s reading of the roots here.`;
}
