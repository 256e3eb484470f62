// Which things are so far away that a box looks like them. Where a scene has very many triangles, most belong to things
// of a few pixels; to draw boxes for these takes a tenth of the time without a graphics card.
//
// Boxes are three.js' Box3.
const kFewTriangles = 300_000;  // in a scene; so many are quick everywhere
const kLeastPixels = 8;         // of a thing's diagonal; below, it is far
const kAxes = ['x', 'y', 'z'];

/** Returns how many triangles a geometry has. */
export function triangles({ index, attributes }) {
  return (index ?? attributes.position).count / 3;
}

/** Tells whether a scene has so many triangles that what is far should be told apart. */
export function hasManyTriangles(objects) {
  const count = (sum, { geometry }) => sum + triangles(geometry);
  return objects.reduce((sum, { parts }) => parts.reduce(count, sum), 0) > kFewTriangles;
}

function diagonal({ min, max }) {
  return Math.hypot(...kAxes.map((axis) => max[axis] - min[axis]));
}

function distance({ min, max }, point) {
  return Math.hypot(...kAxes.map((axis) => Math.max(min[axis] - point[axis], 0, point[axis] - max[axis])));
}

/** Returns the objects that a perspective camera sees as less than a few pixels of a picture of this height. */
export function farObjects(objects, { position, fov }, height) {
  const pixels = height / (2 * Math.tan(fov * Math.PI / 360));  // of a metre that is a metre away
  return new Set(objects.filter(({ box }) => diagonal(box) * pixels < kLeastPixels * distance(box, position)));
}
