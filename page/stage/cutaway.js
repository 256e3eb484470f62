// Which walls are cut off low, so that one sees into rooms from where the camera is.
//
// Boxes are three.js' Box3, with y up.
const kCutHeight = 0.3;  // metres that are left of a wall
const kOverlap = 0.25;   // metres of a thing that a wall may hide or stand on
const kMostComparisons = 1e6;

function isWithin(point, box) {
  return point.x > box.min.x && point.x < box.max.x && point.z > box.min.z && point.z < box.max.z && point.y < box.max.y;
}

/** Returns the part of 0..1 in which low <= at + step * t <= high, cut with `reach`. */
function limited([from, to], low, high, at, step) {
  if (Math.abs(step) < 1e-9) return at < low || at > high ? [1, 0] : [from, to];
  const a = (low - at) / step, b = (high - at) / step;
  return [Math.max(from, Math.min(a, b)), Math.min(to, Math.max(a, b))];
}

/** Tells whether the wall hides a part of the box from a camera in a direction. */
function hides(wall, box, toCamera) {
  const length = (wall.max.y - wall.min.y) / toCamera.y;
  let reach = [0, 1];
  for (const axis of ['x', 'z']) {
    const margin = Math.min(kOverlap, (box.max[axis] - box.min[axis]) / 2);
    const low = box.min[axis] + margin - (wall.max[axis] - wall.min[axis]), high = box.max[axis] - margin;
    reach = limited(reach, low, high, wall.min[axis], -toCamera[axis] * length);
  }
  return reach[0] <= reach[1] && box.min.y < wall.max.y;
}

export class Cutaway {
  /** `walls` holds the addresses of the scene's walls. */
  constructor(objects, walls) {
    const isWall = new Set(walls);
    this.walls = objects.filter((object) => isWall.has(object.address)).map((object) => ({ object, fixtures: [] }));
    this.hidden = [];
    if (this.walls.length * objects.length > kMostComparisons) this.walls = [];
    for (const object of objects) {
      if (!isWall.has(object.address)) this.#sort(object);
    }
  }

  /** Returns a Map from the objects that are cut, seen from the direction, to the height that is left. */
  heights(toCamera) {
    const heights = new Map();
    if (toCamera.y <= 0.05) return heights;
    for (const { object, fixtures } of this.walls) {
      if (!this.hidden.some((box) => hides(object.box, box, toCamera))) continue;
      const height = object.box.min.y + kCutHeight;
      for (const each of [object, ...fixtures]) heights.set(each, height);
    }
    return heights;
  }

  /** What is in a wall goes with it; anything else may be hidden. Doors are neither: one wants to see them. */
  #sort(object) {
    const base = object.box.getCenter(object.box.min.clone()).setY(object.box.min.y);
    const around = this.walls.find((wall) => isWithin(base, wall.object.box));
    if (!around) this.hidden.push(object.box);
    else if (!/\bdoor/i.test(object.name)) around.fixtures.push(object);
  }
}
