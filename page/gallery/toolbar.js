// What stands above the grid: the filter, the order, the colours.
import { button, element, labelled } from '../dom.js';
import { themeChoice } from '../theme.js';

const kTypingPause = 150;  // milliseconds

export class Toolbar {
  /** `changed` is called when the reader wants another selection or order. */
  constructor(columnNames, solutions, changed) {
    this.total = solutions.length;
    this.descending = false;
    this.awaited = 0;  // changes that the grid does not show yet
    this.changed = changed;
    this.filter = this.#makeFilter(columnNames);
    this.sort = this.#makeSort(columnNames);
    this.anchor = element('select', { onchange: () => this.#change() },
                          solutions.map(({ index, name }) => element('option', { value: index }, name)));
    this.anchorLabel = labelled('from', this.anchor);
    this.anchorLabel.hidden = true;
    this.direction = button('Ascending', () => this.#turn(), { className: 'direction' });
    this.status = element('p', { className: 'status', role: 'status' });
    this.names = element('datalist', { id: 'names' }, columnNames.map((name) => element('option', { value: name })));
    this.element = element('search', { className: 'toolbar', 'aria-label': 'Solutions' },
      labelled('Filter', this.filter), this.names,
      labelled('Sort by', this.sort), this.anchorLabel, this.direction,
      labelled('Colours', themeChoice(element)), this.status);
  }

  wanted() {
    return {
      filter: this.filter.value,
      sort: this.sort.value,
      anchor: Number(this.anchor.value),
      descending: this.descending,
    };
  }

  /** Says how many solutions are shown, and which names of the filter are not known. */
  report(shown, unknown) {
    const count = shown === this.total ? '' : `${shown} of ${this.total} solutions`;
    const unknownText = unknown.map((name) => `no solution has “${name}”`).join(', ');
    this.say([count, unknownText].filter((text) => text !== '').join('; '));
  }

  say(text) {
    this.status.textContent = text;
  }

  /** The grid shows one more of the changes. */
  settle() {
    this.awaited -= 1;
    if (this.awaited === 0) this.element.removeAttribute('aria-busy');
  }

  #makeFilter(columnNames) {
    const example = columnNames.find((name) => name !== 'number') ?? 'number';
    const filter = element('input', {
      type: 'search', placeholder: `${example} > 3, words`, autocomplete: 'off', spellcheck: false, id: 'filter',
    });
    filter.setAttribute('list', 'names');
    filter.oninput = () => {
      if (this.pause) {
        clearTimeout(this.pause);
        this.settle();
      }
      this.#await();
      this.pause = setTimeout(() => {
        this.pause = null;
        this.changed();
      }, kTypingPause);
    };
    return filter;
  }

  #makeSort(columnNames) {
    const names = ['number', ...columnNames.filter((name) => name !== 'number'), 'distance'];
    const texts = { number: 'order found', distance: 'distance' };
    const sort = element('select', {}, names.map((name) =>
      element('option', { value: name }, texts[name] ?? name)));
    sort.onchange = () => {
      this.anchorLabel.hidden = sort.value !== 'distance';
      this.#change();
    };
    return sort;
  }

  #turn() {
    this.descending = !this.descending;
    this.direction.textContent = this.descending ? 'Descending' : 'Ascending';
    this.#change();
  }

  #change() {
    this.#await();
    this.changed();
  }

  #await() {
    this.awaited += 1;
    this.element.setAttribute('aria-busy', 'true');
  }
}
