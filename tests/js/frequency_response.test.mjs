// The response of one loop over frequency: resonances, phase, discrete time.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';

const { factored } = await maths('factored_loop');
const { marginsOf } = await maths('margins');
const { crossings: axisCrossings } = await maths('crossings');
const { marginsOnCurve } = await maths('margins_on_curve');
const { frequencyResponse, responseAt, sampleAt } = await maths('frequency_response');

/** @param {number[][]} poles @param {number[][]} zeros */
const loopOf = (poles, zeros, gain = 1, period = 0) => ({
  parts: factored({
    poles: { x: poles.map(([x]) => x), y: poles.map(([, y]) => y) },
    zeros: { x: zeros.map(([x]) => x), y: zeros.map(([, y]) => y) },
    gain: 1,
  }),
  gain,
  period,
});

/** @param {number} actual @param {number} wanted @param {number} part */
const close = (actual, wanted, part) =>
  assert.ok(Math.abs(actual - wanted) <= part * Math.abs(wanted), `${actual}, wanted ${wanted}`);

for (const zeta of [0.1, 0.005, 0.0005]) {
  test(`the peak of a mode with damping ${zeta} is exact`, () => {
    const omega = 3.051;
    const [x, y] = [-zeta * omega, omega * Math.sqrt(1 - zeta * zeta)];
    const curve = frequencyResponse(
      loopOf(
        [
          [x, y],
          [x, -y],
        ],
        [],
        omega * omega,
      ),
    );
    const most = 1 / (2 * zeta * Math.sqrt(1 - zeta * zeta));
    close(10 ** (Math.max(...curve.dB) / 20), most, 1e-12);
    const steps = Array.from(curve.degrees.subarray(1), (angle, k) => Math.abs(angle - curve.degrees[k]));
    assert.ok(Math.max(...steps) < 30, 'its circle in the plane of L is drawn as one');
  });
}

test('a peak that another root moves is found too', () => {
  const [x, y] = [-0.015, 3];
  const loop = loopOf(
    [
      [x, y],
      [x, -y],
      [-1, 0],
      [-1, 0],
    ],
    [],
  );
  const curve = frequencyResponse(loop);
  const fine = Array.from({ length: 200001 }, (_, k) => 2.9 + k * 1e-6);
  const most = fine.reduce((best, w) => Math.max(best, Math.hypot(...responseAt(loop, w))), 0);
  const found = 10 ** (Math.max(...curve.dB) / 20);
  assert.ok(found >= most * (1 - 1e-14), 'no place of a fine grid is higher');
  close(found, most, 1e-9);
});

test('integrators begin at -90 degrees each, and a mode takes 180', () => {
  const poles = [
    [0, 0],
    [-0.01, 2],
    [-0.01, -2],
  ];
  const { degrees } = frequencyResponse(loopOf(poles, []));
  close(degrees[0], -90, 0.01);
  close(degrees.at(-1), -270, 0.01);
});

test('at the first frequency that has to be seen the phase is between -360 and 0', () => {
  const lag = Array.from({ length: 6 }, () => [-1, 0]);
  const curve = frequencyResponse(loopOf(lag, []), [2.5]);
  const at = curve.omega.indexOf(2.5);
  close(curve.degrees[at] + 720, 720 - 6 * ((Math.atan(2.5) * 180) / Math.PI) + 360, 1e-9);
});

test('in discrete time it is taken on the unit circle, up to half the sampling rate', () => {
  const period = 0.1;
  const loop = loopOf([[0.9, 0]], [], 0.2, period);
  const curve = frequencyResponse(loop);
  close(curve.omega.at(-1), Math.PI / period, 1e-12);
  const { re, im } = sampleAt(loop, curve, 5);
  const [c, s] = [Math.cos(0.5) - 0.9, Math.sin(0.5)];
  close(re, (0.2 * c) / (c * c + s * s), 1e-12);
  close(im, (-0.2 * s) / (c * c + s * s), 1e-12);
});

test('margins read off the curve are those of the polynomials', () => {
  // 20 / (s (s + 2) (s^2 + 0.4 s + 16))
  const im = Math.sqrt(16 - 0.04);
  const poles = [
    [0, 0],
    [-2, 0],
    [-0.2, im],
    [-0.2, -im],
  ];
  const loop = loopOf(poles, [], 20);
  const D = [0, 32, 16.8, 2.4, 1];
  const wanted = marginsOf({ D, N: [1, 0, 0, 0, 0], crossings: () => axisCrossings(loop.parts) }, 20);
  const found = marginsOnCurve(loop);
  assert.deepEqual([found.gain.length, found.phase.length], [wanted.gain.length, wanted.phase.length]);
  assert.ok(found.phase.length > 0 && found.gain.length > 0);
  found.gain.forEach((margin, k) => {
    close(margin.omega, wanted.gain[k].omega, 1e-9);
    close(margin.dB, wanted.gain[k].dB, 1e-9);
  });
  found.phase.forEach((margin, k) => {
    close(margin.degrees, wanted.phase[k].degrees, 1e-8);
    close(margin.delay, wanted.phase[k].delay, 1e-8);
  });
});

test('in discrete time an integrator with one step of delay has 60 degrees at 1/3 of half the rate', () => {
  // L = 1/(z - 1): its size is 1 where |z - 1| = 1, at 60 degrees, where its phase is -120.
  const { phase } = marginsOnCurve(loopOf([[1, 0]], [], 1, 0.5));
  assert.equal(phase.length, 1);
  close(phase[0].omega, Math.PI / 3 / 0.5, 1e-12);
  close(phase[0].degrees, 60, 1e-10);
});
