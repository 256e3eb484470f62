// Which walls are cut off low, so that one sees into rooms from where the camera is, and what goes with them: as in
// pictures (scene/picture/cutaway.cpp).
//
// Boxes are three.js' Box3, with y up.
const kCutHeight = 0.3;    // metres that are left of a wall
const kTableHeight = 0.8;  // metres that are left of what stands at a wall that is cut
const kTallest = 1.2;      // metres, of what stands there whole
const kAtWall = 0.15;      // metres between a wall and what stands at it
const kFooting = 0.05;     // metres between a thing and what it stands on
const kOverlap = 0.25;     // metres of a thing that a wall may hide or stand on
const kWidestOnTop = 2;    // times as wide as the wall is what goes with it, standing on it
const kMostAsked = 2000;   // things that are asked what they stand on
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

/** Tells whether the thing is at one of the wall's sides. */
function isAt(thing, wall) {
  const isDeep = wall.max.x - wall.min.x < wall.max.z - wall.min.z;
  const [across, along] = isDeep ? ['x', 'z'] : ['z', 'x'];
  const gap = Math.max(wall.min[across] - thing.max[across], thing.min[across] - wall.max[across]);
  const middle = (thing.min[along] + thing.max[along]) / 2;
  return gap < kAtWall && wall.min[along] < middle && middle < wall.max[along];
}

/** Tells whether the thing stands on the same floor as the wall, at one of its sides, and is tall. */
function towersAt(thing, wall) {
  return thing.min.y <= wall.min.y + kCutHeight && thing.max.y - wall.min.y >= kTallest && isAt(thing, wall);
}

function standsOn(thing, below) {
  const middle = thing.getCenter(thing.min.clone()).setY(below.min.y);
  return isWithin(middle, below) && Math.abs(thing.min.y - below.max.y) < kFooting;
}

/** Tells whether the thing is at the wall above what is left of it, and stands on none of the boxes. */
function hangsAt(thing, wall, boxes) {
  if (thing.min.y <= wall.min.y + kCutHeight || thing.min.y >= wall.max.y || !isAt(thing, wall)) return false;
  return !boxes.some((box) => standsOn(thing, box));
}

/** Tells whether the thing is in a wall, or stands on it and is not much wider, as a tower's roof. */
function belongsTo(thing, wall) {
  const base = thing.getCenter(thing.min.clone()).setY(thing.min.y);
  const isNarrow = (axis) => thing.max[axis] - thing.min[axis] < kWidestOnTop * (wall.max[axis] - wall.min[axis]);
  return isWithin(base, wall) || (standsOn(thing, wall) && isNarrow('x') && isNarrow('z'));
}

export class Cutaway {
  /** `walls` holds the addresses of the scene's walls. */
  constructor(objects, walls) {
    const isWall = new Set(walls);
    this.walls = objects.filter((object) => isWall.has(object.address))
      .map((object) => ({ object, fixtures: [], towers: [] }));
    this.hidden = [];
    this.others = [];
    if (this.walls.length * objects.length > kMostComparisons) this.walls = [];
    for (const object of objects) {
      if (!isWall.has(object.address)) this.#sort(object);
    }
    for (const object of this.others) this.#findWalls(object);
  }

  /** Returns a Map from the objects that are cut, seen from the direction, to the height that is left. */
  heights(toCamera) {
    const heights = new Map();
    if (toCamera.y <= 0.05) return heights;
    for (const { object, fixtures, towers } of this.walls) {
      if (!this.hidden.some((box) => hides(object.box, box, toCamera))) continue;
      const foot = object.box.min.y;
      for (const each of [object, ...fixtures]) heights.set(each, foot + kCutHeight);
      for (const each of towers) heights.set(each, foot + kTableHeight);
    }
    return heights;
  }

  /** What is in a wall goes with it; anything else may be hidden. */
  #sort(object) {
    const around = this.walls.find((wall) => belongsTo(object.box, wall.object.box));
    if (around) {
      around.fixtures.push(object);
      return;
    }
    this.hidden.push(object.box);
    this.others.push(object);
  }

  /** What hangs at a wall goes with it; what is tall and stands at one is cut off higher. */
  #findWalls(object) {
    for (const wall of this.walls) {
      if (towersAt(object.box, wall.object.box)) wall.towers.push(object);
      if (this.others.length <= kMostAsked && hangsAt(object.box, wall.object.box, this.hidden)) wall.fixtures.push(object);
    }
  }
}
