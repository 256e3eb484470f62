// A drawing of a scene, in which things can be picked.
import { element } from '../dom.js';

export class Drawing {
  constructor(picked) {
    this.element = element('div', {
      className: 'drawing', hidden: true,
      onclick: (event) => {
        const thing = event.target.closest('[data-address]');
        if (thing) picked(thing.dataset.address);
      },
    });
  }

  /** Shows the text of an SVG, or nothing. */
  show(svg) {
    this.element.hidden = svg === null;
    this.element.replaceChildren();
    if (svg === null) return;
    const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    this.element.append(document.importNode(parsed, true));
  }

  /** Marks the thing with this address, or none. */
  mark(address) {
    for (const thing of this.element.querySelectorAll('[data-address]')) {
      thing.classList.toggle('selected', thing.dataset.address === address);
    }
  }
}
