// What the stage computes without a canvas: which walls are cut, where one stands.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Cutaway } from '../stage/cutaway.js';
import { farObjects, hasManyTriangles } from '../stage/far.js';
import { standingPlace } from '../stage/standing_place.js';

function point(x, y, z) {
  return { x, y, z, setY(to) { this.y = to; return this; }, clone() { return point(this.x, this.y, this.z); } };
}

function box(x0, y0, z0, x1, y1, z1) {
  return {
    min: point(x0, y0, z0), max: point(x1, y1, z1),
    getCenter: (target) => Object.assign(target, { x: (x0 + x1) / 2, y: (y0 + y1) / 2, z: (z0 + z1) / 2 }),
  };
}

// A room of 4 x 4 m seen from above, its front towards +z, with a table in the middle.
const objects = [
  { address: 'front', name: 'wall', box: box(0, 0, 3.9, 4, 2.5, 4.1) },
  { address: 'back', name: 'wall', box: box(0, 0, -0.1, 4, 2.5, 0.1) },
  { address: 'table', name: 'table', box: box(1.5, 0, 1.5, 2.5, 0.75, 2.5) },
  { address: 'window', name: 'window', box: box(1, 1, 3.95, 2, 2, 4.05) },
  { address: 'door', name: 'door', box: box(3, 0, 3.95, 3.8, 2, 4.05) },
  { address: 'bookcase', name: 'bookcase', box: box(0.2, 0, 3.55, 1.1, 1.9, 3.85) },  // at the front wall
  { address: 'cupboard', name: 'cupboard', box: box(1.2, 0, 3.55, 2.1, 1.1, 3.85) },  // so is this, but it is low
  { address: 'shelf', name: 'shelf', box: box(0.2, 0, 1, 0.5, 1.9, 2) },              // tall, but away from walls
  { address: 'sign', name: 'sign', box: box(2.4, 1.4, 3.8, 2.8, 2, 3.9) },            // hangs there
  { address: 'desk', name: 'desk', box: box(3, 0, 3.2, 3.9, 0.75, 3.85) },
  { address: 'lamp', name: 'lamp', box: box(3.2, 0.75, 3.6, 3.4, 1.2, 3.8) },         // stands on the desk
];
const cutFrom = (x, y, z) => {
  const length = Math.hypot(x, y, z);
  const heights = new Cutaway(objects, ['front', 'back']).heights(point(x / length, y / length, z / length));
  return Object.fromEntries([...heights].map(([{ address }, height]) => [address, height]));
};

test('cutaway: the wall before the table goes, with its window and its door, and what towers at it', () => {
  assert.deepEqual(cutFrom(0, 1, 1), { front: 0.3, window: 0.3, door: 0.3, sign: 0.3, bookcase: 0.8 });
  assert.deepEqual(cutFrom(0, 1, -1), { back: 0.3 });
});

test('cutaway: from straight above, and from below, nothing is in the way', () => {
  assert.deepEqual(cutFrom(0, 1, 0.01), {});
  assert.deepEqual(cutFrom(0, -1, 1), {});
});

test('cutaway: what stands on a wall goes with it, unless it is much wider', () => {
  const above = [
    { address: 'cap', name: 'cone', box: box(1, 2.5, 3.92, 1.2, 2.8, 4.08) },
    { address: 'slab', name: 'slab', box: box(0, 2.5, 3, 4, 2.6, 5) },
  ];
  const heights = new Cutaway([...objects, ...above], ['front']).heights(point(0, Math.SQRT1_2, Math.SQRT1_2));
  const cut = [...heights.keys()].map(({ address }) => address);
  assert.ok(cut.includes('cap') && !cut.includes('slab'));
});

test('one stands in the open, near the front, and not in a thing', () => {
  const bounds = box(0, 0, 0, 6, 2.5, 6);
  const things = [box(0, 0, 5, 3, 1, 6), box(0, 0, 0, 6, 0.05, 6)];  // something at the front left, a floor
  const { x, z } = standingPlace(things, bounds, 1.6);
  assert.ok(z > 3 && x > 3);
  const boxed = standingPlace([box(-1, 0, -1, 7, 2, 7)], bounds, 1.6);
  assert.ok(Number.isFinite(boxed.x) && Number.isFinite(boxed.z));
});

test('far is what is seen as less than eight pixels', () => {
  // A metre that is d metres away is 500 / d pixels high.
  const camera = { position: point(0, 0, 0), fov: 90 };
  const cube = (z) => ({ box: box(0, 0, -z - 1, 1, 1, -z) });  // its diagonal is 1.73 m
  const near = cube(108), far = cube(109), around = { box: box(-1, -1, -1, 1, 1, 1) };
  assert.deepEqual([...farObjects([near, far, around], camera, 1000)], [far]);
});

test('a scene of few triangles has nothing that is far', () => {
  const chairs = (count) => Array(count).fill({ parts: [{ geometry: { index: { count: 552 }, attributes: {} } }] });
  assert.equal(hasManyTriangles(chairs(1000)), false);
  assert.equal(hasManyTriangles(chairs(10000)), true);
});
