// Which part of a drawing is shown.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { keptWithin, scaledBox } from '../viewer/zoom.js';

const whole = { x: -10, y: 0, w: 100, h: 50 };

test('the point that one zooms about stays where it is', () => {
  const at = { x: 15, y: 10 };
  const near = scaledBox(whole, 0.5, at);
  assert.deepEqual(near, { x: 2.5, y: 5, w: 50, h: 25 });
  assert.equal((at.x - near.x) / near.w, (at.x - whole.x) / whole.w);
  assert.equal((at.y - near.y) / near.h, (at.y - whole.y) / whole.h);
});

test('never more than the whole is shown, and its middle never leaves it', () => {
  assert.deepEqual(keptWithin({ x: -99, y: -99, w: 200, h: 100 }, whole), whole);
  assert.deepEqual(keptWithin({ x: -60, y: 500, w: 50, h: 25 }, whole), { x: -35, y: 37.5, w: 50, h: 25 });
  assert.deepEqual(keptWithin({ x: 0, y: 10, w: 50, h: 25 }, whole), { x: 0, y: 10, w: 50, h: 25 });
});

test('one comes no closer than sixty times', () => {
  const { x, w } = keptWithin({ x: 40, y: 20, w: 0.001, h: 0.0005 }, whole);
  assert.equal(w, 100 / 60);
  assert.ok(Math.abs(x + w / 2 - 40.0005) < 1e-9);
});
