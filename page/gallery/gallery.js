// The grid of solutions: which are shown, in which order, and which two are to be compared.
import { button, element } from '../dom.js';
import { ChoiceTable } from './choices.js';
import { columnsOf, columnNames } from './columns.js';
import { sorted } from './order.js';
import { namesIn, parseQuery, passes } from './query.js';
import { Toolbar } from './toolbar.js';

/** Reads a solution off its card. */
function solutionOf(card, params) {
  const facts = JSON.parse(card.dataset.facts);
  return {
    index: facts.index,
    name: card.querySelector('h2').textContent,
    card,
    facts,
    columns: columnsOf(facts, params),
  };
}

export class Gallery {
  constructor(document, source) {
    this.source = source;
    this.grid = document.querySelector('main');
    this.run = JSON.parse(this.grid.dataset.facts);
    this.solutions = [...this.grid.querySelectorAll('article')].map((card) => solutionOf(card, this.run.params));
    this.shown = this.solutions;
    this.picked = [];  // at most two solutions to compare
    this.table = null;
    if (this.solutions.length === 0) return;
    this.toolbar = new Toolbar(columnNames(this.solutions.map((each) => each.columns)), this.solutions,
                               () => this.#arrange().finally(() => this.toolbar.settle()));
    this.grid.before(this.toolbar.element);
    this.#addCompareBar();
    for (const solution of this.solutions) this.#addPickButton(solution);
  }

  solution(index) {
    return this.solutions.find((each) => each.index === index);
  }

  /** Returns the solution so many places further on among those shown, round the end. */
  neighbour(solution, step) {
    const at = this.shown.indexOf(solution);
    return this.shown[(at + step + this.shown.length) % this.shown.length];
  }

  async #arrange() {
    const wanted = this.toolbar.wanted();
    const terms = parseQuery(wanted.filter);
    try {
      await this.#loadChoicesFor(terms, wanted.sort);
    } catch (error) {
      this.toolbar.say(error.message);
      return;
    }
    const unknown = namesIn(terms).filter((name) => !this.#isKnown(name));
    const passing = this.solutions.filter((each) =>
      passes(terms, (name) => this.#value(each, name), each.card.textContent));
    this.shown = sorted(passing, (each) => this.#sortKey(each, wanted), wanted.descending);
    this.#showDistances(wanted);
    this.#lay(passing);
    this.toolbar.report(this.shown.length, unknown);
  }

  /** Choices are a large file, so they are read when somebody asks for them. */
  async #loadChoicesFor(terms, sort) {
    const isColumn = (name) => this.solutions.some((each) => each.columns.has(name));
    if (sort !== 'distance' && namesIn(terms).every(isColumn)) return;
    this.table ??= new ChoiceTable(await this.source.choices());
  }

  #value(solution, name) {
    return solution.columns.get(name) ?? this.table?.value(solution.index, name);
  }

  #isKnown(name) {
    return this.solutions.some((each) => this.#value(each, name) !== undefined);
  }

  #sortKey(solution, { sort, anchor }) {
    return sort === 'distance' ? this.table.distance(solution.index, anchor) : this.#value(solution, sort);
  }

  #showDistances({ sort, anchor }) {
    for (const { index, card } of this.shown) {
      card.querySelector('.distance')?.remove();
      if (sort !== 'distance') continue;
      const text = `distance ${this.table.distance(index, anchor).toFixed(2)}`;
      card.querySelector('.facts').prepend(element('span', { className: 'distance' }, text));
    }
  }

  #lay(passing) {
    const stays = new Set(passing);
    for (const solution of this.solutions) solution.card.hidden = !stays.has(solution);
    this.grid.append(...this.shown.map(({ card }) => card));
  }

  #addPickButton(solution) {
    const pick = button('Compare', () => this.#togglePicked(solution), {
      className: 'pick', 'aria-pressed': 'false', 'aria-label': `Compare ${solution.name}`,
    });
    solution.pick = pick;
    solution.card.querySelector('h2').after(pick);
  }

  #togglePicked(solution) {
    const without = this.picked.filter((each) => each !== solution);
    this.picked = without.length < this.picked.length ? without : [...without.slice(-1), solution];
    for (const each of this.solutions) each.pick.setAttribute('aria-pressed', String(this.picked.includes(each)));
    this.#updateCompareBar();
  }

  #addCompareBar() {
    this.compareText = element('p', { role: 'status' });
    this.compareLink = element('a', { className: 'action' }, 'Open side by side');
    this.compareBar = element('section', { className: 'compare-bar', hidden: true, 'aria-label': 'Comparison' },
                              this.compareText, this.compareLink);
    document.body.append(this.compareBar);
  }

  #updateCompareBar() {
    const [first, second] = this.picked;
    this.compareBar.hidden = !first;
    if (!first) return;
    this.compareText.textContent = second ? `${first.name} and ${second.name}` : `${first.name} and … pick another one`;
    this.compareLink.hidden = !second;
    if (second) this.compareLink.href = `#compare-${first.index}-${second.index}`;
  }
}
