// Comes closer to a drawing and moves it: by wheel, by dragging, by two fingers, by the keys.
const kMost = 60;       // times as large as the whole
const kStep = 1.25;
const kClick = 6;       // pixels that a pointer may move during a click
const kWheel = 0.0015;  // of the logarithm of the size, for each pixel of a turned wheel

const kMoves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Returns the box around so much of the point that stays where it is. Boxes are {x, y, w, h}. */
export function scaledBox({ x, y, w, h }, factor, at) {
  return { x: at.x - (at.x - x) * factor, y: at.y - (at.y - y) * factor, w: w * factor, h: h * factor };
}

/** Returns the part of the whole that is nearest to the box: no larger than the whole, and with its middle in it. */
export function keptWithin(box, whole) {
  const factor = Math.min(Math.max(box.w, whole.w / kMost), whole.w) / box.w;
  const { x, y, w, h } = scaledBox(box, factor, { x: box.x + box.w / 2, y: box.y + box.h / 2 });
  if (w >= whole.w) return whole;
  const kept = (at, size, from, length) => Math.min(Math.max(at, from - size / 2), from + length - size / 2);
  return { x: kept(x, w, whole.x, whole.w), y: kept(y, h, whole.y, whole.h), w, h };
}

export class Zoom {
  /** The element holds the drawings, one at a time. `moved()` is called when somebody has moved one. */
  constructor(element, moved) {
    Object.assign(this, { element, moved });
    this.pointers = new Map();  // where each is, by its id
    const on = (type, act, options) => element.addEventListener(type, (event) => this.svg && act(event), options);
    on('wheel', (event) => this.#wheel(event), { passive: false });
    on('pointerdown', (event) => this.#grab(event));
    on('pointermove', (event) => this.#drag(event));
    for (const type of ['pointerup', 'pointercancel']) on(type, (event) => this.pointers.delete(event.pointerId));
    on('keydown', (event) => this.#key(event) && event.preventDefault());
    // What ends a drag is no click on what lies there.
    on('click', (event) => this.isDragged && event.stopImmediatePropagation(), { capture: true });
  }

  show(svg) {
    this.svg = svg;
    this.pointers.clear();
    if (!svg) return;
    const { x, y, width, height } = svg.viewBox.baseVal;
    this.whole = this.box = { x, y, w: width, h: height };
  }

  reset() {
    if (this.svg) this.#move(this.whole);
  }

  /** Shows the same part as another one does of its own drawing. */
  follow({ svg, box, whole }) {
    if (!this.svg || !svg) return;
    const scale = this.whole.w / whole.w;
    this.#show({ x: this.whole.x + (box.x - whole.x) * scale, y: this.whole.y + (box.y - whole.y) * scale,
                 w: box.w * scale, h: box.h * scale * (this.whole.h / this.whole.w) / (whole.h / whole.w) });
  }

  #move(box) {
    this.#show(box);
    this.moved();
  }

  #show(box) {
    this.box = keptWithin(box, this.whole);
    this.svg.setAttribute('viewBox', [this.box.x, this.box.y, this.box.w, this.box.h].join(' '));
  }

  /** Returns where a point of the window is in the drawing. */
  #at({ clientX, clientY }) {
    return new DOMPoint(clientX, clientY).matrixTransform(this.svg.getScreenCTM().inverse());
  }

  #wheel(event) {
    event.preventDefault();
    this.#move(scaledBox(this.box, Math.exp(event.deltaY * kWheel), this.#at(event)));
  }

  #grab(event) {
    this.pointers.set(event.pointerId, event);
    this.start = event;
    if (this.pointers.size === 1) this.isDragged = false;
  }

  #drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    this.isDragged ||= Math.hypot(event.clientX - this.start.clientX, event.clientY - this.start.clientY) > kClick;
    if (!this.isDragged) return;
    if (!this.element.hasPointerCapture(event.pointerId)) this.element.setPointerCapture(event.pointerId);
    const other = [...this.pointers.values()].find(({ pointerId }) => pointerId !== event.pointerId);
    if (other) this.#pinch(before, event, other);
    else this.#shift(this.#at(before), this.#at(event));
    this.pointers.set(event.pointerId, event);
  }

  #shift(from, to) {
    this.#move({ ...this.box, x: this.box.x + from.x - to.x, y: this.box.y + from.y - to.y });
  }

  #pinch(before, now, other) {
    const apart = (event) => Math.max(Math.hypot(event.clientX - other.clientX, event.clientY - other.clientY), 1);
    this.#move(scaledBox(this.box, apart(before) / apart(now), this.#at(other)));
  }

  #key({ key, ctrlKey, metaKey, altKey }) {
    if (ctrlKey || metaKey || altKey) return false;
    const { x, y, w, h } = this.box;
    const middle = { x: x + w / 2, y: y + h / 2 };
    if (key === '+' || key === '=') this.#move(scaledBox(this.box, 1 / kStep, middle));
    else if (key === '-') this.#move(scaledBox(this.box, kStep, middle));
    else if (kMoves[key]) this.#move({ ...this.box, x: x + kMoves[key][0] * w / 10, y: y + kMoves[key][1] * h / 10 });
    else return false;
    return true;
  }
}
