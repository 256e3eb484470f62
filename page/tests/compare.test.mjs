// What differs between two solutions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { changes, compareChoices, compareObjects, hasOnlyMoved } from '../viewer/compare.js';

function thing(address, change = {}) {
  const made = { address, name: address, shape: 'box', paint: 'red', center: [0, 0, 0], size: [1, 1, 1], turn: 0, ...change };
  const { shape, paint, center, size, turn } = made;
  return { ...made, look: JSON.stringify([shape, paint, center, size, turn]) };
}

const kindsOf = (entries) => entries.map(({ kind, left, right }) => `${kind} ${left?.address ?? ''} ${right?.address ?? ''}`);

test('what looks the same is the same, also where addresses changed places', () => {
  const [a, b] = [{ center: [0, 0, 0] }, { center: [5, 0, 0] }];
  const entries = compareObjects([thing('p', a), thing('q', b)], [thing('p', b), thing('q', a)]);
  assert.deepEqual(kindsOf(entries).sort(), ['same p q', 'same q p']);
});

test('of alike things each has one counterpart', () => {
  const entries = compareObjects([thing('p'), thing('q'), thing('r')], [thing('x'), thing('y')]);
  assert.equal(entries.filter(({ kind }) => kind === 'same').length, 2);
  assert.equal(entries.filter(({ kind }) => kind === 'left').length, 1);
});

test('what has the same address and looks otherwise has changed; the rest is on one side only', () => {
  const entries = compareObjects([thing('p'), thing('l')], [thing('p', { center: [0, 0, 2] }), thing('r', { paint: 'blue' })]);
  assert.deepEqual(kindsOf(entries), ['changed p p', 'left l ', 'right  r']);
  assert.deepEqual(entries[0].words, ['moved 2.00 m']);
});

test('what has another address and looks the same has moved', () => {
  const chair = (address, x) => thing(address, { name: `chair[${x}]`, center: [x, 0, 0] });
  const entries = compareObjects([chair('p', 1), chair('q', 2)], [chair('r', 3), thing('s', { shape: 'sofa' })]);
  assert.deepEqual(entries.map(({ kind }) => kind).sort(), ['changed', 'left', 'right']);
  assert.equal(hasOnlyMoved(entries.find(({ kind }) => kind === 'changed')), true);
});

test('of things that look the same, the nearest has moved', () => {
  const chair = (address, x) => thing(address, { name: 'chair', center: [x, 0, 0] });
  const entries = compareObjects([chair('p', 1), chair('q', 5)], [chair('r', 5.2), chair('s', 1.1), chair('t', 9)]);
  assert.deepEqual(entries.map(({ words }) => words.join()).sort(), ['', 'moved 10 cm', 'moved 20 cm']);
});

test('what is elsewhere or larger has only moved; what looks otherwise, or is the same, has not', () => {
  const [moved, larger, painted, same] = [{ center: [1, 0, 0] }, { size: [2, 1, 1] }, { paint: 'blue' }, {}]
    .map((change) => compareObjects([thing('p')], [thing('p', change)])[0]);
  assert.deepEqual([moved, larger, painted, same].map(hasOnlyMoved), [true, true, false, false]);
});

test('changes in words', () => {
  assert.deepEqual(changes(thing('p'), thing('p', { center: [0.25, 0, 0], turn: 270 })), ['moved 25 cm', 'turned 90°']);
  assert.deepEqual(changes(thing('p', { turn: 350 }), thing('p', { turn: 10 })), ['turned 20°']);
  assert.deepEqual(changes(thing('p'), thing('p', { size: [1, 2, 1], paint: 'blue' })), ['another size', 'another colour']);
  assert.deepEqual(changes(thing('p'), thing('p', { shape: 'chair', size: [2, 2, 2] })), ['another shape']);
  assert.deepEqual(changes(thing('p', { name: 'coin (3)' }), thing('p', { name: 'air', paint: 'blue' })), ['now air', 'another colour']);
  assert.deepEqual(changes(thing('p', { name: 'chair[0][3]' }), thing('p', { name: 'chair', turn: 90 })), ['turned 90°']);
});

test('choices that differ, and those that one solution does not meet', () => {
  const left = [{ at: 'x', value: 1 }, { at: 'y', value: true }, { at: 'z', value: 0.5 }];
  const right = [{ at: 'x', value: 2 }, { at: 'z', value: 0.5 }];
  assert.deepEqual(compareChoices(left, right), [
    { address: 'x', left: 1, right: 2 }, { address: 'y', left: true, right: undefined },
  ]);
});
