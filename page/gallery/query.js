// The language of the filter: conditions such as "cost<5" or "value[0] >= 7", and words that must occur; all must hold.

const kTerm = /([^\s<>=!"]+)\s*(<=|>=|!=|==|=|<|>)\s*("[^"]*"|[^\s"]+)|"([^"]*)"|(\S+)/g;

const kHolds = {
  '<': (a, b) => a < b,
  '>': (a, b) => a > b,
  '<=': (a, b) => a <= b,
  '>=': (a, b) => a >= b,
  '=': (a, b) => a === b,
  '!=': (a, b) => a !== b,
};

function valueOf(text) {
  if (text.startsWith('"')) return text.slice(1, -1);
  if (text === 'true' || text === 'false') return text === 'true';
  const number = Number(text);
  return Number.isNaN(number) ? text : number;
}

/** Returns the terms of a filter: {name, operator, value} or {word}. */
export function parseQuery(text) {
  return [...text.matchAll(kTerm)].map(([, name, operator, value, quoted, word]) =>
    name === undefined
      ? { word: (quoted ?? word).toLowerCase() }
      : { name, operator: operator === '==' ? '=' : operator, value: valueOf(value) });
}

/** Returns the names that conditions of the terms are about. */
export function namesIn(terms) {
  return terms.filter((term) => term.name !== undefined).map((term) => term.name);
}

function comparable(left, right) {
  return typeof left === typeof right ? [left, right] : [Number(left), Number(right)];
}

/** Tells whether a solution passes. `valueOfName` gives the value under a name, or undefined; `text` is all of its
 * text. */
export function passes(terms, valueOfName, text) {
  const lower = text.toLowerCase();
  return terms.every((term) => {
    if (term.word !== undefined) return lower.includes(term.word);
    const value = valueOfName(term.name);
    return value !== undefined && kHolds[term.operator](...comparable(value, term.value));
  });
}
