// How the solutions in two panes differ, object by object and choice by choice.
import { compareChoices, compareObjects } from './compare.js';

const kStyles = { same: 'faded', changed: 'changed', left: 'only', right: 'only' };

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

  pairOf(object) {
    return this.byObject.get(object);
  }

  /** Returns which style each object of a side is drawn in. */
  styles() {
    return (object) => kStyles[this.byObject.get(object).kind];
  }
}
