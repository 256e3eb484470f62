// One opened solution: its scene in 3D, or one of its drawings.
import { element } from '../dom.js';
import { isDark, onThemeChange } from '../theme.js';
import { Drawing } from './drawing.js';

const k3d = '3D';
const kKeys = 'Arrow keys turn the view, + and - zoom; while walking, arrow keys and W, A, S, D go. ' +
  'The list of objects selects what is in the scene.';

export class Pane {
  /** `told.selected(object, pane)` is called when somebody picks, `told.moved(pane)` when the view has moved. */
  constructor(source, solution, told) {
    Object.assign(this, { source, solution, told });
    this.canvas = element('canvas', {
      tabIndex: 0, role: 'application', 'aria-label': `Scene of ${solution.name}`, 'aria-description': kKeys,
      onkeydown: (event) => this.#key(event, true), onkeyup: (event) => this.#key(event, false),
    });
    this.drawing = new Drawing(`Drawing of ${solution.name}`, (address) => this.#pickAddress(address),
                               () => told.moved(this));
    this.message = element('p', { className: 'message', role: 'status' }, 'Loading …');
    this.caption = element('p', { className: 'caption', 'aria-hidden': 'true' }, solution.name);
    this.element = element('section', { className: 'pane', 'aria-label': solution.name },
                           this.caption, this.canvas, this.drawing.element, this.message);
    this.about = { views: [], choices: [], walls: [] };
    this.objects = [];
  }

  /** Reads the solution; what goes wrong is said in the pane. */
  async load() {
    try {
      const { about, glb } = await this.source.solution(this.solution);
      Object.assign(this.about, about);
      if (glb) await this.#loadScene(glb);
      this.message.textContent = glb ? '' : this.solution.card.querySelector('.value')?.textContent ?? '';
    } catch (error) {
      this.message.textContent = error.message;
    }
  }

  /** Shows what was loaded, each object in its style. */
  show(styleOf) {
    this.stage?.show(this.model, this.about.walls ?? [], styleOf);
  }

  views() {
    return [...(this.stage ? [k3d] : []), ...this.about.views.map(({ title }) => title)];
  }

  setView(title) {
    const view = this.about.views.find((each) => each.title === title);
    this.canvas.hidden = Boolean(view) || !this.stage;
    this.drawing.show(view?.svg ?? null);
    if (this.selected) this.drawing.mark(this.selected.address);
    if (this.stage && view) this.setMode('orbit');
  }

  setMode(mode) {
    if (this.stage) this.stage.mode = mode;
    this.canvas.focus();
  }

  reset() {
    if (this.canvas.hidden) this.drawing.reset();
    else this.stage.reset();
  }

  hold(movement, isHeld) {
    if (this.stage?.mode === 'walk') this.stage.walk.hold(movement, isHeld);
  }

  follow(pane) {
    if (this.stage && pane.stage) this.stage.follow(pane.stage);
    this.drawing.follow(pane.drawing);
  }

  select(object) {
    this.selected = object;
    this.stage?.select(object);
    this.drawing.mark(object?.address);
  }

  focus() {
    [this.canvas, this.drawing.element].find((each) => !each.hidden)?.focus();
  }

  dispose() {
    this.endTheme?.();
    this.stage?.dispose();
    this.model?.dispose();
    this.stage = this.model = null;
  }

  async #loadScene(glb) {
    const { Stage, readScene } = await this.source.stage();
    this.model = await readScene(glb);
    this.objects = this.model.objects;
    try {
      this.stage = new Stage(this.canvas, {
        picked: (object) => this.told.selected(object, this),
        moved: () => this.told.moved(this),
      });
    } catch {
      return;  // no WebGL: there are still the drawings
    }
    this.stage.dark = isDark();
    this.endTheme = onThemeChange(() => (this.stage.dark = isDark()));
  }

  #pickAddress(address) {
    this.told.selected(this.objects.find((each) => each.address === address) ?? null, this);
  }

  #key(event, isDown) {
    if (!this.stage || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.stage.key(event.key, isDown)) event.preventDefault();
  }
}
