// Opens solutions in a dialog over the gallery: one in 3D and in drawings, or two side by side. The page's address says
// what is open, so that links, bookmarks and the way back work.
import { button, element } from '../dom.js';
import { Comparison } from './comparison.js';
import { Controls } from './controls.js';
import { Pane } from './pane.js';
import { Panel } from './panel.js';

const kOpen = /^#open-(\d+)$/;
const kCompare = /^#compare-(\d+)-(\d+)$/;

export class Viewer {
  constructor(document, source, gallery) {
    Object.assign(this, { document, source, gallery });
    this.panes = [];
    this.solutions = [];
    this.#build();
    addEventListener('hashchange', () => this.followAddress());
  }

  /** Opens what the page's address says, or closes. */
  followAddress() {
    const open = kOpen.exec(location.hash), compare = kCompare.exec(location.hash);
    const indices = (open ?? compare)?.slice(1).map(Number) ?? [];
    const solutions = indices.map((index) => this.gallery.solution(index));
    if (solutions.length > 0 && solutions.every(Boolean)) this.#open(solutions);
    else if (this.dialog.open) this.dialog.close();
  }

  #build() {
    this.title = element('h2', { id: 'viewer-title' });
    this.controls = new Controls({
      step: (by) => this.#step(by),
      view: (title) => this.panes.forEach((pane) => pane.setView(title)),
      mode: (mode) => this.panes.forEach((pane) => pane.setMode(mode)),
      reset: () => this.panes.forEach((pane) => pane.reset()),
      hold: (movement, isHeld) => this.panes.forEach((pane) => pane.hold(movement, isHeld)),
    });
    this.stageArea = element('div', { className: 'panes' });
    this.panel = new Panel({ selected: (object, side) => this.#select(object, side) });
    this.other = element('select', { 'aria-label': 'Compare with', onchange: () => this.#compareWith(Number(this.other.value)) });
    this.close = button('Close', () => this.dialog.close(), { className: 'close' });
    this.dialog = element('dialog', { className: 'viewer', 'aria-labelledby': 'viewer-title' },
      element('header', { className: 'bar' }, this.title, this.controls.element,
              this.other, this.close),
      element('div', { className: 'body' },
              element('div', { className: 'scene' }, this.stageArea, this.controls.walkPad), this.panel.element));
    this.dialog.addEventListener('close', () => this.#closed());
    this.dialog.addEventListener('keydown', (event) => this.#key(event));
    this.document.body.append(this.dialog);
  }

  async #open(solutions) {
    this.#release();
    this.solutions = solutions;
    this.title.textContent = solutions.map(({ name }) => name).join(' and ');
    this.#listOthers();
    this.panel.clear();
    this.controls.begin(solutions.length);
    this.panes = solutions.map((solution) => new Pane(this.source, solution, {
      selected: (object, pane) => this.#select(object, this.panes.indexOf(pane)),
      moved: (pane) => this.panes.filter((each) => each !== pane).forEach((each) => each.follow(pane)),
    }));
    this.stageArea.replaceChildren(...this.panes.map((pane) => pane.element));
    if (!this.dialog.open) this.dialog.showModal();
    this.dialog.dataset.ready = 'false';
    const opened = this.panes;
    await Promise.all(opened.map((pane) => pane.load()));
    if (opened !== this.panes) return;  // somebody was faster and opened another one
    this.#show();
    this.dialog.dataset.ready = 'true';
  }

  #show() {
    const [left, right] = this.panes;
    this.comparison = right ? new Comparison(left, right) : null;
    this.panes.forEach((pane) => pane.show(this.comparison?.styles()));
    this.controls.offer(this.panes);
    if (this.comparison) this.panel.showComparison(this.comparison, this.solutions);
    else this.panel.showSolution(left, this.solutions[0]);
    left.focus();
  }

  /** `side` is that of the pane that the object belongs to. */
  #select(object, side) {
    const pair = this.comparison?.pairOf(object) ?? (side === 0 ? { left: object } : { right: object });
    [pair.left, pair.right].forEach((each, at) => this.panes[at]?.select(each ?? null));
    this.panel.showObject(object, this.comparison && object ? pair : null);
  }

  #listOthers() {
    const [first, second] = this.solutions;
    const options = this.gallery.solutions.filter((each) => each !== first)
      .map(({ index, name }) => element('option', { value: index }, name));
    this.other.replaceChildren(element('option', { value: 0 }, 'Compare with …'), ...options);
    this.other.value = second?.index ?? 0;
  }

  #compareWith(index) {
    const first = this.solutions[0].index;
    location.hash = index === 0 ? `#open-${first}` : `#compare-${first}-${index}`;
  }

  #step(by) {
    location.hash = `#open-${this.gallery.neighbour(this.solutions[0], by).index}`;
  }

  #key(event) {
    const writes = ['INPUT', 'SELECT', 'TEXTAREA'].includes(event.target.tagName);
    if (writes || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === ',' || event.key === '.') {
      if (this.panes.length === 1) this.#step(event.key === '.' ? 1 : -1);
    }
  }

  #release() {
    for (const pane of this.panes) pane.dispose();
    this.panes = [];
  }

  #closed() {
    this.#release();
    const [first] = this.solutions;
    location.hash = `#solution-${first.index}`;
    first.card.querySelector('h2 a').focus({ preventScroll: true });
  }
}
