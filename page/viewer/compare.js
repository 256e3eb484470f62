// What differs between two scenes, or between the choices of two solutions. Knows nothing of how they are shown.

const kSamePlace = 1e-3;      // metres
const kSameTurn = 0.05;       // degrees
const kMostCandidates = 200;  // among which the nearest is looked for

function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

function metres(length) {
  return length >= 1 ? `${length.toFixed(2)} m` : `${Math.round(length * 100)} cm`;
}

function turnedBy(from, to) {
  return (((to - from) % 360) + 540) % 360 - 180;
}

/** Tells whether an entry is of one thing that is elsewhere, or of another size, and else looks the same. */
export function hasOnlyMoved({ kind, left, right }) {
  return kind === 'changed' && left.shape === right.shape && left.paint === right.paint &&
    kindOf(left.name) === kindOf(right.name);
}

/** Returns a name without the number that tells things of that name apart. */
function kindOf(name) {
  return name?.replace(/( \(\d+\)|\[\d+\])+$/, '');
}

/** Returns in words how one object became the other: "moved 1.50 m", "turned 90°". */
export function changes(left, right) {
  const words = [];
  if (kindOf(left.name) !== kindOf(right.name)) words.push(`now ${kindOf(right.name)}`);
  if (left.shape !== right.shape) words.push('another shape');
  const moved = distance(left.center, right.center);
  if (moved > kSamePlace) words.push(`moved ${metres(moved)}`);
  const turned = turnedBy(left.turn, right.turn);
  if (Math.abs(turned) > kSameTurn) words.push(`turned ${Math.round(Math.abs(turned))}°`);
  if (left.shape === right.shape && distance(left.size, right.size) > kSamePlace) words.push('another size');
  if (left.paint !== right.paint) words.push('another colour');
  return words;
}

function last(left, candidates) {
  return candidates.length - 1;
}

function nearest(left, candidates) {
  const ways = candidates.slice(0, kMostCandidates).map(({ center }) => distance(left.center, center));
  return ways.indexOf(Math.min(...ways));
}

/** Takes from both lists what has the same key, pair by pair. Of several, `choose` says which by its index. */
function paired(lefts, rights, keyOf, choose = last) {
  const waiting = new Map(rights.map((right) => [keyOf(right), []]));
  for (const right of rights) waiting.get(keyOf(right)).push(right);
  const pairs = [], restLeft = [];
  for (const left of lefts) {
    const candidates = waiting.get(keyOf(left)) ?? [];
    if (candidates.length === 0) restLeft.push(left);
    else pairs.push({ left, right: candidates.splice(choose(left, candidates), 1)[0] });
  }
  const taken = new Set(pairs.map(({ right }) => right));
  return { pairs, restLeft, restRight: rights.filter((right) => !taken.has(right)) };
}

function looksOf({ name, shape, paint }) {
  return JSON.stringify([kindOf(name), shape, paint]);
}

/** Compares the objects of two scenes: {kind, left, right, words} where kind is "same", "changed", "left" or "right".
 * What looks the same at the same place is the same, whatever its address: two chairs that changed places do not
 * differ. Of the rest, those with the same address are one object that changed, and then those that look the same and
 * are near: where a program chooses how many chairs there are, their addresses say little. */
export function compareObjects(lefts, rights) {
  const alike = paired(lefts, rights, (object) => object.look);
  const named = paired(alike.restLeft, alike.restRight, (object) => object.address);
  const kin = paired(named.restLeft, named.restRight, looksOf, nearest);
  return [
    ...[...named.pairs, ...kin.pairs].map((pair) => ({ kind: 'changed', ...pair, words: changes(pair.left, pair.right) })),
    ...kin.restLeft.map((left) => ({ kind: 'left', left, words: [] })),
    ...kin.restRight.map((right) => ({ kind: 'right', right, words: [] })),
    ...alike.pairs.map((pair) => ({ kind: 'same', ...pair, words: [] })),
  ];
}

/** Returns the choices that differ: {address, left, right}, with undefined where one does not meet the choice. */
export function compareChoices(lefts, rights) {
  const right = new Map(rights.map(({ at, value }) => [at, value]));
  const left = new Map(lefts.map(({ at, value }) => [at, value]));
  const addresses = new Set([...left.keys(), ...right.keys()]);
  return [...addresses]
    .filter((address) => left.get(address) !== right.get(address))
    .map((address) => ({ address, left: left.get(address), right: right.get(address) }));
}
