// One's own loop as it is typed, or as python-control and MATLAB print it.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const folder = new URL('../../src/rlswaim/explorers/js/reading/', import.meta.url);
const { readLoop } = await import(new URL('loop_text.js', folder).href);
const { givenRoots } = await import(new URL('given_loop.js', folder).href);

const fraction = (num, den, dt = 0) => ({ form: 'fraction', num, den, dt });
const factors = (zeros, poles, gain, dt = 0) => ({ form: 'factors', zeros, poles, gain, dt });
const states = (A, B, C, D, dt = 0) => ({ form: 'states', A, B, C, D, dt });
const TWO = states([[-1, 0], [0, -2]], [[1], [1]], [[1, 1]], 0); // biome-ignore format: as a matrix

test('expressions: factors stay factors, sums are multiplied out', () => {
  assert.deepEqual(readLoop('(s+1)/(s^2+2s+5)'), fraction([1, 1], [1, 2, 5]));
  const discrete = [
    [1, 0],
    [0.5, 0],
  ];
  assert.deepEqual(readLoop('G(s) = 1/(z-1)/(z-.5);'), factors([], discrete, 1, true));
  const found = readLoop('5 (s+1)/(s (s+2)^2 (s^2 + 2 s + 5))');
  const poles = [[0, 0], [-2, 0], [-2, 0], [-1, 2], [-1, -2]]; // biome-ignore format: pairs
  assert.deepEqual(found, factors([[-1, 0]], poles, 5));
  assert.deepEqual(readLoop('2·s⁻¹'.replace('⁻¹', '^-1')), fraction([2], [1, 0]));
});

test('values of names, in any brackets', () => {
  assert.deepEqual(readLoop('num = [1 2]; den = [1, 3, 2, 0]'), fraction([1, 2], [1, 3, 2, 0]));
  assert.deepEqual(readLoop('zeros = []\npoles = [-1, -2+3j, -2-3j]\ngain = 5\ndt = 0.1').dt, 0.1);
  assert.deepEqual(readLoop('A = [-1 0; 0 -2]\nB = [1;1]\nC=[1 1]\nD=0'), TWO);
  assert.deepEqual(readLoop('A = [[-1, 0], [0, -2]]; B = [[1], [1]]; C = [[1, 1]]'), TWO);
});

test('calls of both programs', () => {
  assert.deepEqual(readLoop('sys = tf([1 2],[1 3 3 1],0.1);'), fraction([1, 2], [1, 3, 3, 1], 0.1));
  assert.deepEqual(readLoop('G = control.tf([1, 2], [1, 3], dt=True)'), fraction([1, 2], [1, 3], true));
  const poles = [[-1, 0], [-2, 3], [-2, -3]]; // biome-ignore format: pairs
  assert.deepEqual(readLoop('zpk([],[-1 -2+3i -2-3i],5)'), factors([], poles, 5));
  assert.deepEqual(readLoop('A=[-1 0;0 -2]; sys = ss(A,[1;1],[1 1],0)'), TWO);
  const repr =
    'TransferFunction(\narray([1.0e-05, 2.5e+00]),\narray([ 1, 3, 0]),\ndt=0.1,\noutputs=1, inputs=1)';
  assert.deepEqual(readLoop(repr), fraction([1e-5, 2.5], [1, 3, 0], 0.1));
});

test('prints of both programs', () => {
  const head = "<TransferFunction>: sys[1]\nInputs (1): ['u[0]']\nOutputs (1): ['y[0]']\n";
  const printed = `${head}dt = 0.1\n\n      1e-05 z + 2.5\n  -----------\n  z^3 + 3 z^2 + 2e+05 z`;
  assert.deepEqual(readLoop(printed), fraction([1e-5, 2.5], [1, 3, 2e5, 0], 0.1));
  const zpk = `${head}\n   5 (s + 1)\n  --------\n  (s) (s + 2) (s + (3-1j)) (s + (3+1j))`;
  const poles = [[0, 0], [-2, 0], [-3, 1], [-3, -1]]; // biome-ignore format: pairs
  assert.deepEqual(readLoop(zpk), factors([[-1, 0]], poles, 5));
  const numpy = "<StateSpace>: sys[4]\nStates (2): ['x[0]', 'x[1]']\n\nA = [[-1.  0.]\n     [ 0. -2.]]\n";
  assert.deepEqual(readLoop(`${numpy}\nB = [[1.]\n     [1.]]\n\nC = [[1. 1.]]\n\nD = [[0.]]`), TWO);
  const A = 'sys =\n \n  A = \n       x1  x2\n   x1  -1   0\n   x2   0  -2\n \n';
  const rest = '  B = \n       u1\n   x1   1\n   x2   1\n \n  C = \n       x1  x2\n   y1   1   1\n \n';
  const end = '  D = \n       u1\n   y1   0\n \nSample time: 0.1 seconds\nDiscrete-time state-space model.';
  assert.deepEqual(readLoop(A + rest + end), { ...TWO, dt: 0.1 });
});

test('what is wrong is told, and nothing is run', () => {
  const refused = [
    ['', /the loop: got no text/],
    ['alert(1)', /got “alert\(1\)”, wanted s or z/],
    ['1/s(s+1)', /wanted brackets after a “\/”/],
    ['A = [1 2; 3]\nB = 1\nC = 1', /A, row 2: got 1 numbers, wanted 2/],
    ['A = [1]', /B: got nothing, wanted a value beside A/],
    ['num = [1, x]; den = [1]', /numerator: got “x”, wanted a number/],
    ['num = [1]; den = [1 2]; dt = -3', /dt: got “-3”/],
    ['s^2/(s+1)', /got a numerator of order 2 over one of order 1/],
    ['1/(s+1)^31', /order of the loop: got 31, wanted at most 30/],
    ['poles = [-1+2j]', /without its conjugate/],
    ['1e308/s', /wanted 0, or a size from/],
    ['(((((s', /wanted “\)”|its end/],
    ['('.repeat(5000), /at most 60 brackets/],
    ['x'.repeat(30_000), /length of the text/],
    ['<img src=x onerror=alert(1)>', /got “<img/],
  ];
  for (const [text, message] of refused) assert.throws(() => givenRoots(readLoop(text)), message, text);
});

test('states keep their poles to the last digit, also where coefficients lose them', () => {
  for (const n of [12, 20, 30]) {
    const A = Array.from({ length: n }, (_, i) =>
      Array.from({ length: n }, (_, j) => (i === j ? -1 - i : 0)),
    );
    const ones = Array(n).fill(1);
    const { poles, zeros } = givenRoots(
      states(
        A,
        ones.map((v) => [v]),
        [ones],
        0,
      ),
    );
    assert.deepEqual(
      [...poles.x].sort((a, b) => b - a),
      ones.map((_, i) => -1 - i),
    );
    assert.ok([...poles.y, ...zeros.y].every((v) => v === 0));
    [...zeros.x]
      .sort((a, b) => b - a)
      .forEach((z, i) => {
        assert.ok(z < -1 - i && z > -2 - i); // between each two poles
      });
  }
});
