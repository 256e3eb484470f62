// What stands above the grid: the filter, the order, the colours.
import { button, element, labelled } from '../dom.js';
import { themeChoice } from '../theme.js';

const kTypingPause = 150;  // milliseconds

export class Toolbar {
  /** `changed` is called when the reader wants another selection or order. */
  constructor(columnNames, solutions, changed) {
    this.total = solutions.length;
    this.descending = false;
    this.changed = changed;
    this.filter = this.#makeFilter(columnNames);
    this.sort = this.#makeSort(columnNames);
    this.anchor = element('select', { onchange: changed },
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

  #makeFilter(columnNames) {
    const example = columnNames.find((name) => name !== 'number') ?? 'number';
    const filter = element('input', {
      type: 'search', placeholder: `${example} > 3, words`, autocomplete: 'off', spellcheck: false, id: 'filter',
    });
    filter.setAttribute('list', 'names');
    filter.oninput = () => {
      clearTimeout(this.pause);
      this.pause = setTimeout(this.changed, kTypingPause);
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
      this.changed();
    };
    return sort;
  }

  #turn() {
    this.descending = !this.descending;
    this.direction.textContent = this.descending ? 'Descending' : 'Ascending';
    this.changed();
  }
}
