// Finds what somebody clicks on.
import { Raycaster, Vector2 } from 'three';
import { cutHeight } from './styles.js';

const kClick = 6;  // pixels that a pointer may move during a click

export class Picker {
  /** Calls `picked(object or null)` at a click and `focused(object)` at a double click. */
  constructor(canvas, camera, batches, { picked, focused }) {
    Object.assign(this, { canvas, camera, batches });
    this.raycaster = new Raycaster();
    this.listeners = {
      pointerdown: (event) => (this.start = [event.clientX, event.clientY]),
      pointerup: (event) => this.#isClick(event) && picked(this.objectAt(event.offsetX, event.offsetY)),
      dblclick: (event) => {
        const object = this.objectAt(event.offsetX, event.offsetY);
        if (object) focused(object);
      },
    };
    for (const [type, listener] of Object.entries(this.listeners)) canvas.addEventListener(type, listener);
  }

  /** Returns the object that is seen at a point of the canvas, in pixels of the page, or null. */
  objectAt(x, y) {
    const point = new Vector2(x / this.canvas.clientWidth * 2 - 1, 1 - y / this.canvas.clientHeight * 2);
    this.raycaster.setFromCamera(point, this.camera);
    const hit = this.raycaster.intersectObject(this.batches.group, true).find((each) => this.#isShown(each));
    return hit ? this.batches.objectAt(hit) : null;
  }

  dispose() {
    for (const [type, listener] of Object.entries(this.listeners)) this.canvas.removeEventListener(type, listener);
  }

  #isClick({ clientX, clientY }) {
    return this.start !== undefined && Math.hypot(clientX - this.start[0], clientY - this.start[1]) < kClick;
  }

  /** What is cut off cannot be hit. */
  #isShown(hit) {
    return hit.point.y <= cutHeight(this.batches.styleOf(this.batches.objectAt(hit)));
  }
}
