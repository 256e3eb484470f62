// What solutions are sorted and filtered by: named facts, each a number, a bool or a text.

const kMost = 60;  // parts of a value; more than that nobody can choose from

function* parts(name, value) {
  if (Array.isArray(value)) {
    for (const [at, item] of value.entries()) yield* parts(`${name}[${at}]`, item);
  } else if (value !== null && typeof value === 'object') {
    for (const [field, item] of Object.entries(value)) yield* parts(`${name}.${field}`, item);
  } else if (value !== null && value !== undefined) {
    yield [name, value];
  }
}

/** Returns the facts of a solution as a Map from names such as "cost" and "value[0].w"; a param has its own name. */
export function columnsOf(facts, params = {}) {
  const columns = new Map([['number', facts.index]]);
  for (const name of ['cost', 'broken']) {
    if (facts[name] !== undefined) columns.set(name, facts[name]);
  }
  for (const [name, value] of parts('value', facts.value)) {
    if (columns.size < kMost) columns.set(name, value);
  }
  for (const [param, value] of Object.entries(params)) {
    for (const [name, part] of parts(param, value)) {
      if (!columns.has(name)) columns.set(name, part);
    }
  }
  return columns;
}

/** Returns the names of all solutions' columns, in the order in which they come, those that differ first. */
export function columnNames(allColumns) {
  const values = new Map();
  for (const columns of allColumns) {
    for (const [name, value] of columns) values.set(name, (values.get(name) ?? new Set()).add(value));
  }
  const names = [...values.keys()];
  const varies = (name) => values.get(name).size > 1;
  return [...names.filter(varies), ...names.filter((name) => !varies(name))];
}
