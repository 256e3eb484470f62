// What is said beside the scene: the selected object, what differs, the list of objects, choices, broken asserts.
import { button, element } from '../dom.js';
import { objectDetails } from './details.js';

const kMostChoices = 500;

function section(title, ...content) {
  return element('section', {}, element('h3', {}, title), content);
}

function textOf(value) {
  return value === undefined ? '–' : JSON.stringify(value);
}

function objectText({ name, path, broken, unmet }) {
  const where = path.length > 1 ? ` (in ${path.slice(1).join(' / ')})` : '';
  return `${broken.length > 0 ? '⚠ ' : unmet.length > 0 ? '△ ' : ''}${name}${where}`;
}

function differenceText({ kind, left, right, words }, [first, second]) {
  if (kind === 'left') return `${left.name}: only in ${first.name}`;
  if (kind === 'right') return `${right.name}: only in ${second.name}`;
  return `${left.name}: ${words.join(', ')}`;
}

function table(caption, heads, rows) {
  const cells = (row) => row.map((text, at) => element(at === 0 ? 'th' : 'td', at === 0 ? { scope: 'row' } : {}, text));
  return element('table', {}, element('caption', {}, caption),
    element('thead', {}, element('tr', {}, heads.map((text) => element('th', { scope: 'col' }, text)))),
    element('tbody', {}, rows.map((row) => element('tr', {}, cells(row)))));
}

function choiceTable(heads, rows) {
  const left = rows.length - kMostChoices;
  const caption = left > 0 ? `The first ${kMostChoices} of ${rows.length}` : `${rows.length} in all`;
  return element('div', { className: 'scroll', tabIndex: 0, role: 'region', 'aria-label': 'Choices' },
                 table(caption, heads, rows.slice(0, kMostChoices)));
}

function conditionsSection(title, conditions, className) {
  if (!conditions?.length) return null;
  return section(title, element('ul', { className }, conditions.map(({ source, condition, wish, message, cost }) =>
    element('li', {}, message ? `${message}: ` : '', element('code', {}, condition ?? wish), ` (${source})`,
            cost === undefined ? '' : `, cost ${cost}`))));
}

export class Panel {
  /** `told.selected(object, side)` is called when somebody chooses from a list. */
  constructor(told) {
    this.told = told;
    this.details = element('div', { className: 'details', 'aria-live': 'polite' });
    this.lists = element('div', { className: 'lists' });
    this.element = element('aside', { className: 'panel', 'aria-label': 'About the solution', tabIndex: 0 },
                           this.details, this.lists);
  }

  clear() {
    this.details.replaceChildren();
    this.lists.replaceChildren();
    this.objectList = null;
  }

  showSolution({ objects, about }, { card }) {
    this.#listObjects(objects);
    const value = card.querySelector('.value');
    this.lists.replaceChildren(
      ...[
        value && section('Value', element('p', { className: 'value' }, value.textContent)),
        conditionsSection('Broken asserts', about.broken, 'broken'),
        conditionsSection('Unmet wishes', about.unmet, 'unmet'),
        objects.length > 0 && section('Objects', this.objectList),
        about.choices.length > 0 && section('Choices', choiceTable(['choice', 'value'],
          about.choices.map(({ at, value: chosen }) => [at, textOf(chosen)]))),
      ].filter(Boolean));
    this.showObject(null, null);
  }

  showComparison(comparison, solutions) {
    this.objectList = null;
    const differences = comparison.differences();
    const items = differences.map((entry) => element('li', { className: entry.kind },
      button(differenceText(entry, solutions), () => this.#choose(entry))));
    const rows = comparison.choices.map(({ address, left, right }) => [address, textOf(left), textOf(right)]);
    this.lists.replaceChildren(
      section('What differs', ...items.length > 0
        ? [element('p', { className: 'summary' }, `${comparison.summary(solutions)}.`),
           element('ul', { className: 'differences' }, items)]
        : [element('p', {}, 'The scenes look the same.')]),
      section('Choices that differ', rows.length > 0
        ? choiceTable(['choice', ...solutions.map(({ name }) => name)], rows) : element('p', {}, 'None.')));
    this.showObject(null, null);
  }

  /** Says what is known of an object, and of a comparison what became of it. */
  showObject(object, pair) {
    if (this.objectList) this.objectList.value = object ? String(object.index) : '';
    this.details.replaceChildren(object ? objectDetails(object, pair)
      : element('p', { className: 'hint' }, 'Click an object, or choose one from the list, to see what it is.'));
  }

  #listObjects(objects) {
    this.objectList = element('select', {
      size: 8, 'aria-label': 'Objects',
      onchange: () => this.told.selected(objects[Number(this.objectList.value)], 0),
    }, objects.map((object) => element('option', { value: object.index }, objectText(object))));
  }

  #choose(entry) {
    this.told.selected(entry.left ?? entry.right, entry.left ? 0 : 1);
  }
}
