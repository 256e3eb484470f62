// The buttons above and upon the scene: which view, how to move.
import { button, element, labelled } from '../dom.js';

const kMovements = [
  ['turnLeft', '↶', 'Turn left'], ['forward', '↑', 'Forward'], ['turnRight', '↷', 'Turn right'],
  ['left', '←', 'Step left'], ['back', '↓', 'Back'], ['right', '→', 'Step right'],
];

export class Controls {
  /** `act` has a function for each thing that a button does. */
  constructor(act) {
    this.act = act;
    this.previous = button('‹', () => act.step(-1), { 'aria-label': 'Previous solution' });
    this.next = button('›', () => act.step(1), { 'aria-label': 'Next solution' });
    this.view = element('select', { onchange: () => this.#changeView() });
    this.walk = button('Walk', () => this.#toggleWalk(), { 'aria-pressed': 'false' });
    this.resetButton = button('Reset view', () => act.reset());
    this.walkPad = this.#makeWalkPad();
    this.element = element('div', { className: 'controls' }, this.previous, this.next, labelled('View', this.view),
                           this.walk, this.resetButton);
  }

  /** Before so many solutions are opened. */
  begin(solutions) {
    this.previous.hidden = this.next.hidden = solutions > 1;
    this.#setWalking(false);
  }

  /** Offers the views that the panes have, the one that was chosen last among them if it is there. */
  offer(panes) {
    const wanted = this.view.value;
    const titles = [...new Set(panes.flatMap((pane) => pane.views()))];
    this.view.replaceChildren(...titles.map((title) => element('option', { value: title }, title)));
    this.view.disabled = titles.length < 2;
    if (titles.includes(wanted)) this.view.value = wanted;
    this.#changeView();
  }

  #changeView() {
    const is3d = this.view.value === '3D';
    this.walk.disabled = !is3d;
    this.resetButton.disabled = this.view.value === '';
    if (!is3d) this.#setWalking(false);
    this.act.view(this.view.value);
  }

  #toggleWalk() {
    const walking = this.walk.getAttribute('aria-pressed') !== 'true';
    this.#setWalking(walking);
    this.act.mode(walking ? 'walk' : 'orbit');
  }

  #setWalking(walking) {
    this.walk.setAttribute('aria-pressed', String(walking));
    this.walkPad.hidden = !walking;
  }

  /** Buttons that are held, for those who have no keys. */
  #makeWalkPad() {
    const buttons = kMovements.map(([movement, sign, name]) => {
      const hold = (isHeld) => () => this.act.hold(movement, isHeld);
      return button(sign, null, {
        'aria-label': name, onpointerdown: hold(true), onpointerup: hold(false), onpointerleave: hold(false),
        onpointercancel: hold(false), onkeydown: (event) => event.key === 'Enter' && hold(true)(), onkeyup: hold(false),
      });
    });
    return element('div', { className: 'walk-pad', hidden: true, role: 'group', 'aria-label': 'Walk' }, buttons);
  }
}
