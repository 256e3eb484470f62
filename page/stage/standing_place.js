// Where somebody who comes into a scene can stand.
const kSteps = 24;          // points that are tried along each side
const kEnough = 0.7;        // metres of free room around a place; more is not better
const kFlat = 0.15;         // metres: what is not higher is walked on

function distanceTo(box, x, z) {
  return Math.hypot(Math.max(box.min.x - x, 0, x - box.max.x), Math.max(box.min.z - z, 0, z - box.max.z));
}

/** Returns the boxes that somebody of this height on the ground would stand in. */
function obstacles(boxes, bounds, eye) {
  return boxes.filter((box) => box.min.y < bounds.min.y + eye && box.max.y > bounds.min.y + kFlat);
}

/** Returns {x, z}: of the places with room around them the one that is nearest to the front and far from the middle,
 * so that one sees much. Boxes are three.js' Box3. */
export function standingPlace(boxes, bounds, eye) {
  const inTheWay = obstacles(boxes, bounds, eye);
  const width = bounds.max.x - bounds.min.x, depth = bounds.max.z - bounds.min.z;
  const middle = { x: bounds.min.x + width / 2, z: bounds.min.z + depth / 2 };
  let best = { x: middle.x, z: bounds.max.z, worth: -Infinity };
  for (let i = 1; i < kSteps; ++i) {
    for (let j = 1; j < kSteps; ++j) {
      const x = bounds.min.x + width * i / kSteps, z = bounds.min.z + depth * j / kSteps;
      const room = Math.min(...inTheWay.map((box) => distanceTo(box, x, z)), kEnough);
      const away = Math.hypot(x - middle.x, z - middle.z) / Math.hypot(width, depth);
      const worth = 4 * room / kEnough + away + (z - middle.z) / depth;
      if (worth > best.worth) best = { x, z, worth };
    }
  }
  return best;
}
