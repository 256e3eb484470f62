// The choices of all solutions of a run, and how far apart two solutions are.

export class ChoiceTable {
  /** `addresses` are texts; each of `solutions` is [position in addresses, value, position, value, ...]. */
  constructor({ addresses, solutions }) {
    this.positions = new Map(addresses.map((address, position) => [address, position]));
    this.solutions = solutions.map((row) => {
      const choices = new Map();
      for (let at = 0; at < row.length; at += 2) choices.set(row[at], row[at + 1]);
      return choices;
    });
  }

  /** Returns what solution number `index` (from 1) chose at the address, or undefined. */
  value(index, address) {
    return this.solutions[index - 1].get(this.positions.get(address));
  }

  /** Returns the distance of choices: the share of the addresses met by either solution where they differ. */
  distance(index, other) {
    const [a, b] = [this.solutions[index - 1], this.solutions[other - 1]];
    let alike = 0;
    for (const [address, value] of a) alike += b.get(address) === value ? 1 : 0;
    const all = a.size + b.size - [...a.keys()].filter((address) => b.has(address)).length;
    return all === 0 ? 0 : (all - alike) / all;
  }
}
