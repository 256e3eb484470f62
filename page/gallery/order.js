// The order of solutions.

function compareValues(a, b) {
  if (typeof a !== typeof b) return typeof a < typeof b ? -1 : 1;
  if (typeof a === 'string') return a.localeCompare(b, 'en', { numeric: true });
  return Number(a) - Number(b);
}

/** Returns the items by ascending or descending key; those without a key come last, and equal ones stay in order. */
export function sorted(items, keyOf, descending = false) {
  const keyed = items.map((item) => ({ item, key: keyOf(item) }));
  keyed.sort((a, b) => {
    if (a.key === undefined || b.key === undefined) return (a.key === undefined) - (b.key === undefined);
    return descending ? compareValues(b.key, a.key) : compareValues(a.key, b.key);
  });
  return keyed.map(({ item }) => item);
}
