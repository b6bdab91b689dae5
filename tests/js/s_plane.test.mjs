// The numbers beside a plane whose two scales differ.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const drawing = (name) =>
  import(new URL(`../../src/rlswaim/explorers/js/drawing/${name}.js`, import.meta.url).href);
const { sPlane } = await drawing('s_plane');
const { SvgContext } = await drawing('svg');
const { frameOf, viewOf } = await drawing('view');

const theme = { plane: '#fff', unstable: '#fee', grid: '#eee', axis: '#888', ink: '#000', muted: '#666' };

for (const [side, top] of [
  [0.4, 5],
  [5, 5],
  [12, 0.5],
]) {
  test(`numbers stand apart at ${side} by ${top}`, () => {
    const g = new SvgContext(640, 400);
    sPlane(g, viewOf([-side, side], [-0.05 * top, top], frameOf(640, 400), 640, 400), theme);
    const beside = g.parts
      .filter((part) => part.includes('text-anchor="end"'))
      .map((part) => Number(/ y="([\d.-]+)"/.exec(part)[1]))
      .sort((a, b) => a - b);
    assert.ok(beside.length >= (side === 12 ? 1 : 3), `${beside}`);
    for (let k = 1; k < beside.length; k++) assert.ok(beside[k] - beside[k - 1] >= 12, `${beside}`);
  });
}
