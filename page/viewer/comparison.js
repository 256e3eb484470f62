// How the solutions in two panes differ, object by object and choice by choice.
import { compareChoices, compareObjects, hasOnlyMoved } from './compare.js';

const kStyles = { same: 'faded', changed: 'changed', left: 'only', right: 'only' };

function styleOf(entry) {
  return hasOnlyMoved(entry) ? 'moved' : kStyles[entry.kind];
}

export class Comparison {
  constructor(left, right) {
    this.entries = compareObjects(left.objects, right.objects);
    this.choices = compareChoices(left.about.choices, right.about.choices);
    this.byObject = new Map(this.entries.flatMap((entry) => [[entry.left, entry], [entry.right, entry]]));
    this.byObject.delete(undefined);
  }

  /** Returns the entries of what differs. */
  differences() {
    return this.entries.filter(({ kind }) => kind !== 'same');
  }

  /** Returns how many objects differ in which way, in words. */
  summary([first, second]) {
    const moved = this.entries.filter(hasOnlyMoved).length;
    const count = (kind) => this.entries.filter((entry) => entry.kind === kind).length;
    const counts = [
      [moved, 'moved'], [count('changed') - moved, 'changed'], [count('left'), `only in ${first.name}`],
      [count('right'), `only in ${second.name}`], [count('same'), 'the same'],
    ];
    return counts.filter(([number]) => number > 0).map((parts) => parts.join(' ')).join(', ');
  }

  pairOf(object) {
    return this.byObject.get(object);
  }

  /** Returns which style each object of a side is drawn in. */
  styles() {
    return (object) => styleOf(this.byObject.get(object));
  }
}
