// A drawing of a scene, in which things can be picked.
import { element } from '../dom.js';
import { Zoom } from './zoom.js';

const kKeys = 'Plus and minus zoom, arrow keys move. The list of objects selects what is in the drawing.';

export class Drawing {
  constructor(name, picked, moved) {
    this.element = element('div', {
      className: 'drawing', hidden: true, tabIndex: 0, role: 'application', 'aria-label': name,
      'aria-description': kKeys,
      onclick: (event) => {
        const thing = event.target.closest('[data-address]');
        if (thing) picked(thing.dataset.address);
      },
    });
    this.zoom = new Zoom(this.element, moved);
  }

  /** Shows the text of an SVG, or nothing. */
  show(svg) {
    this.element.hidden = svg === null;
    this.element.replaceChildren();
    if (svg === null) {
      this.zoom.show(null);
      return;
    }
    const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    this.element.append(document.importNode(parsed, true));
    this.zoom.show(this.element.firstChild);
  }

  /** Shows the whole drawing again. */
  reset() {
    this.zoom.reset();
  }

  /** Shows the same part as another drawing does. */
  follow(other) {
    this.zoom.follow(other.zoom);
  }

  /** Marks the thing with this address, or none. */
  mark(address) {
    for (const thing of this.element.querySelectorAll('[data-address]')) {
      thing.classList.toggle('selected', thing.dataset.address === address);
    }
  }
}
