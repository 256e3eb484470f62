// What the gallery computes: columns, filters, orders, distances.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ChoiceTable } from '../gallery/choices.js';
import { columnNames, columnsOf } from '../gallery/columns.js';
import { sorted } from '../gallery/order.js';
import { namesIn, parseQuery, passes } from '../gallery/query.js';

test('columns: parts of values have paths, params their names, what the solution says comes first', () => {
  const columns = columnsOf({ index: 3, cost: 0, value: [1, { w: 2.5, tags: ['a'] }, null] }, { seats: 4, cost: 9 });
  assert.deepEqual([...columns], [
    ['number', 3], ['cost', 0], ['value[0]', 1], ['value[1].w', 2.5], ['value[1].tags[0]', 'a'], ['seats', 4],
  ]);
  assert.deepEqual([...columnsOf({ index: 1, value: true })], [['number', 1], ['value', true]]);
});

test('columns: the names that differ come first', () => {
  const all = [columnsOf({ index: 1, cost: 2, value: 7 }), columnsOf({ index: 2, cost: 2, value: 8 })];
  assert.deepEqual(columnNames(all), ['number', 'value', 'cost']);
});

test('query: conditions with and without spaces, quoted texts, words', () => {
  assert.deepEqual(parseQuery('cost<=5 value[0] != -2 name="two words" Chair "a b" f==true'), [
    { name: 'cost', operator: '<=', value: 5 },
    { name: 'value[0]', operator: '!=', value: -2 },
    { name: 'name', operator: '=', value: 'two words' },
    { word: 'chair' },
    { word: 'a b' },
    { name: 'f', operator: '=', value: true },
  ]);
  assert.deepEqual(namesIn(parseQuery('a>1 b')), ['a']);
  assert.deepEqual(parseQuery(' '), []);
});

test('query: all terms must hold, and a solution without the name does not pass', () => {
  const values = { cost: 3, flag: true, kind: 'oak' };
  const pass = (text) => passes(parseQuery(text), (name) => values[name], 'A Chair of oak');
  for (const text of ['', 'cost>2 cost<4', 'cost>=3', 'flag=true', 'flag=1', 'kind=oak', 'chair OAK', 'cost!=4'])
    assert.equal(pass(text), true, text);
  for (const text of ['cost>3', 'cost<3', 'flag=false', 'kind=elm', 'table', 'height>0', 'height!=0', 'chair cost=4'])
    assert.equal(pass(text), false, text);
});

test('order: by number and by text, stable, those without a key last both ways', () => {
  const keys = { a: 10, b: 9, c: undefined, d: 9 };
  const order = (descending) => sorted(['a', 'b', 'c', 'd'], (name) => keys[name], descending).join('');
  assert.equal(order(false), 'bdac');
  assert.equal(order(true), 'abdc');
  assert.deepEqual(sorted(['x10', 'x9'], (text) => text), ['x9', 'x10']);
});

test('distance: the share of the addresses of either solution where they differ', () => {
  // x = 1, y = 2 and x = 1, z = 5 agree in one of three addresses.
  const table = new ChoiceTable({ addresses: ['x', 'y', 'z'], solutions: [[0, 1, 1, 2], [0, 1, 2, 5], []] });
  assert.equal(table.distance(1, 2), 2 / 3);
  assert.equal(table.distance(1, 1), 0);
  assert.equal(table.distance(1, 3), 1);
  assert.equal(table.distance(3, 3), 0);
  assert.equal(table.value(2, 'z'), 5);
  assert.equal(table.value(2, 'y'), undefined);
  assert.equal(table.value(2, 'unknown'), undefined);
});
