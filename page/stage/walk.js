// Walks through a scene at eye height: by the keys, by dragging, by buttons that are held.
import { Raycaster, Vector3 } from 'three';
import { standingPlace } from './standing_place.js';

const kEyeHeight = 1.6;       // metres
const kSpeed = 1.6;           // metres a second
const kTurn = 1.4;            // radians a second
const kStep = 0.35;           // metres: the highest step that one climbs
const kRoom = 0.25;           // metres that are kept to what stands in the way
const kLookSpeed = 0.004;     // radians for each pixel that is dragged
const kLongestTick = 0.1;     // seconds

const kDirections = {
  forward: [0, 1], back: [0, -1], left: [-1, 0], right: [1, 0],
};

const kKeys = {
  ArrowUp: 'forward', w: 'forward', ArrowDown: 'back', s: 'back', a: 'left', d: 'right',
  ArrowLeft: 'turnLeft', q: 'turnLeft', ArrowRight: 'turnRight', e: 'turnRight', PageUp: 'up', PageDown: 'down',
};

export class Walk {
  /** `obstacles` is a group of meshes, `isPassable(hit)` tells what one may walk through. */
  constructor(camera, canvas, obstacles, isPassable, changed) {
    Object.assign(this, { camera, canvas, obstacles, isPassable, changed });
    this.active = false;
    this.held = new Set();
    this.yaw = 0;
    this.pitch = 0;
    this.foot = new Vector3();
    this.ray = new Raycaster();
    this.listeners = { pointerdown: (event) => this.#grab(event), pointermove: (event) => this.#drag(event) };
    for (const [type, listener] of Object.entries(this.listeners)) canvas.addEventListener(type, listener);
  }

  /** Stands at a free place near the front of the scene and looks into it. */
  enter(objects, box) {
    const extent = box.getSize(new Vector3());
    const largest = Math.max(extent.x, extent.z);
    this.scale = Math.min(1, largest / 4);  // models smaller than a room are walked through by somebody small
    const place = standingPlace(objects.map((object) => object.box), box, this.#eye());
    this.foot.set(place.x, box.min.y, place.z);
    this.foot.y = this.#ground(this.foot.clone().setY(box.min.y + this.#eye())) ?? box.min.y;
    const middle = box.getCenter(new Vector3());
    this.yaw = Math.atan2(this.foot.x - middle.x, this.foot.z - middle.z);
    this.pitch = -0.08;
    this.active = true;
    this.#apply();
  }

  leave() {
    this.active = false;
    this.held.clear();
  }

  /** Starts or ends a movement: "forward", "turnLeft", ... Returns true if there is such a movement. */
  hold(movement, isHeld) {
    if (isHeld) this.held.add(movement);
    else this.held.delete(movement);
    if (isHeld && !this.ticking) this.#startTicking();
  }

  /** Returns true if the key means something. */
  press(key, isDown) {
    const movement = kKeys[key.length === 1 ? key.toLowerCase() : key];
    if (!movement) return false;
    this.hold(movement, isDown);
    return true;
  }

  /** Where one stands, in metres, and where one looks, in radians. */
  state() {
    return { foot: this.foot.toArray(), yaw: this.yaw, eye: this.#eye() };
  }

  dispose() {
    this.leave();
    for (const [type, listener] of Object.entries(this.listeners)) this.canvas.removeEventListener(type, listener);
  }

  #eye() {
    return kEyeHeight * this.scale;
  }

  #grab(event) {
    if (this.active) this.canvas.setPointerCapture(event.pointerId);
  }

  #drag(event) {
    if (!this.active || event.buttons === 0) return;
    this.yaw += event.movementX * kLookSpeed;
    this.pitch = Math.min(Math.max(this.pitch + event.movementY * kLookSpeed, -1.4), 1.4);
    this.#apply();
  }

  #startTicking() {
    this.ticking = true;
    let last = performance.now();
    const tick = (now) => {
      this.#move(Math.min((now - last) / 1000, kLongestTick));
      last = now;
      this.ticking = this.active && this.held.size > 0;
      if (this.ticking) requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  #move(seconds) {
    const turn = (this.held.has('turnLeft') ? 1 : 0) - (this.held.has('turnRight') ? 1 : 0);
    this.yaw += turn * kTurn * seconds;
    const step = new Vector3();
    for (const [movement, [across, ahead]] of Object.entries(kDirections)) {
      if (this.held.has(movement)) step.x += across, step.z -= ahead;
    }
    step.applyAxisAngle(new Vector3(0, 1, 0), this.yaw).setLength(step.lengthSq() > 0 ? kSpeed * this.scale * seconds : 0);
    this.#step(step);
    this.#climb();
    this.#apply();
  }

  /** Goes as far as nothing stands in the way, along the obstacle if need be. */
  #step(step) {
    for (const part of [step, new Vector3(step.x, 0, 0), new Vector3(0, 0, step.z)]) {
      if (part.lengthSq() === 0 || this.#isBlocked(part)) continue;
      this.foot.add(part);
      this.foot.y = this.#ground(this.foot) ?? this.foot.y;
      return;
    }
  }

  /** Goes to the floor above or below. */
  #climb() {
    for (const [movement, heights] of [['up', [1.5, 6]], ['down', [-6, -1.5]]]) {
      if (!this.held.delete(movement)) continue;
      const [low, high] = heights.map((height) => this.foot.y + height * this.scale);
      const floors = this.#hits(this.foot.clone().setY(high), new Vector3(0, -1, 0), high - low);
      const floor = movement === 'up' ? floors.at(-1) : floors[0];
      if (floor) this.foot.y = floor.point.y;
    }
  }

  #isBlocked(step) {
    const direction = step.clone().normalize();
    const reach = step.length() + kRoom * this.scale;
    return [0.3, 0.9].some((part) => {
      const from = this.foot.clone().setY(this.foot.y + part * this.#eye());
      return this.#hits(from, direction, reach).some((hit) => !this.isPassable(hit));
    });
  }

  /** Returns the height of what one stands on there, or undefined above nothing. */
  #ground(foot) {
    const from = foot.clone().setY(foot.y + kStep * this.scale);
    return this.#hits(from, new Vector3(0, -1, 0), 2 * kStep * this.scale + 0.01)[0]?.point.y;
  }

  #hits(from, direction, reach) {
    this.ray.set(from, direction);
    this.ray.far = reach;
    return this.ray.intersectObject(this.obstacles, true);
  }

  #apply() {
    this.camera.position.copy(this.foot).setY(this.foot.y + this.#eye());
    this.camera.rotation.set(this.pitch, this.yaw, 0, 'YXZ');
    this.changed();
  }
}
