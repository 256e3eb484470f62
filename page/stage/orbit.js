// Turns the camera about the scene: by mouse, by touch, by the keys.
import { Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const kStep = Math.PI / 24;
const kZoom = 1.15;
const kSteepest = 0.02;  // radians from straight down

export class Orbit {
  constructor(camera, canvas, changed) {
    this.camera = camera;
    this.controls = new OrbitControls(camera, canvas);
    Object.assign(this.controls, { zoomToCursor: true, maxPolarAngle: Math.PI / 2 - 0.01, minPolarAngle: kSteepest });
    this.controls.addEventListener('change', changed);
  }

  set enabled(enabled) {
    this.controls.enabled = enabled;
  }

  get target() {
    return this.controls.target;
  }

  /** Looks from a position at a target in a scene of this extent. */
  look(position, target, extent) {
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    Object.assign(this.controls, { minDistance: extent * 0.02, maxDistance: extent * 8 });
    this.controls.update();
  }

  /** Moves so as to look at a box from the same direction. */
  focus(box) {
    const center = box.getCenter(new Vector3());
    const distance = Math.max(box.getSize(new Vector3()).length() * 2.2, this.controls.minDistance);
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    this.look(center.clone().addScaledVector(direction, distance), center, this.controls.maxDistance / 8);
  }

  /** Returns true if the key means something. */
  press(key) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (turns[key]) this.#turn(...turns[key]);
    else if (key === '+' || key === '=') this.#zoom(1 / kZoom);
    else if (key === '-') this.#zoom(kZoom);
    else return false;
    return true;
  }

  dispose() {
    this.controls.dispose();
  }

  #turn(around, over) {
    const place = this.#place();
    place.theta += around * kStep;
    place.phi = Math.min(Math.max(place.phi + over * kStep, this.controls.minPolarAngle), this.controls.maxPolarAngle);
    this.#move(place);
  }

  #zoom(factor) {
    const place = this.#place();
    place.radius *= factor;
    this.#move(place);
  }

  #place() {
    return new Spherical().setFromVector3(this.camera.position.clone().sub(this.target));
  }

  #move(place) {
    this.camera.position.setFromSpherical(place).add(this.target);
    this.controls.update();
  }
}
