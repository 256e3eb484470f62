// Things that are so far away that a box looks like them. Where a scene has very many triangles, most belong to things
// of a few pixels; to draw boxes for these takes a tenth of the time without a graphics card.
import { BoxGeometry, Triangle, Vector3 } from 'three';

const kFewTriangles = 300_000;  // in a scene; so many are quick everywhere
const kLeastPixels = 8;         // of a thing's diagonal; below, it is far
const kBoxTriangles = 12;
const kAttributes = new Set(['position', 'normal', 'uv']);  // those that a box has

function triangles({ index, attributes }) {
  return (index ?? attributes.position).count / 3;
}

function areaOf({ index, attributes: { position } }) {
  const triangle = new Triangle();
  const corner = (at) => (index ? index.getX(at) : at);
  let area = 0;
  for (let at = 0; at + 2 < (index ?? position).count; at += 3) {
    triangle.setFromAttributeAndIndices(position, corner(at), corner(at + 1), corner(at + 2));
    area += triangle.getArea();
  }
  return area;
}

/** Returns a box in the middle of a shape with as much surface as the shape has, so that it is seen as much as that. */
function boxFor(geometry) {
  const { x, y, z } = geometry.boundingBox.getSize(new Vector3());
  const scale = Math.min(1, Math.sqrt(areaOf(geometry) / (2 * (x * y + y * z + z * x))));
  const center = geometry.boundingBox.getCenter(new Vector3());
  const box = new BoxGeometry(x * scale, y * scale, z * scale).translate(center.x, center.y, center.z);
  box.computeBoundingBox();
  return box;
}

/** The boxes that stand for shapes. */
export class Boxes {
  constructor() {
    this.boxes = new Map();  // by geometry
  }

  /** Returns the box, or the shape itself where that is no simpler or has what a box lacks. */
  of(geometry) {
    const isPlain = Object.keys(geometry.attributes).every((name) => kAttributes.has(name));
    if (!isPlain || triangles(geometry) <= kBoxTriangles) return geometry;
    if (!this.boxes.has(geometry)) this.boxes.set(geometry, boxFor(geometry));
    return this.boxes.get(geometry);
  }

  clear() {
    for (const box of this.boxes.values()) box.dispose();
    this.boxes.clear();
  }
}

/** Tells whether a scene has so many triangles that what is far should be told apart. */
export function hasManyTriangles(objects) {
  const count = (sum, { geometry }) => sum + triangles(geometry);
  return objects.reduce((sum, { parts }) => parts.reduce(count, sum), 0) > kFewTriangles;
}

/** Returns the objects that a perspective camera sees as less than a few pixels of a picture of this height. */
export function farObjects(objects, camera, height) {
  const pixels = height / (2 * Math.tan(camera.fov * Math.PI / 360));  // of a metre that is a metre away
  const diagonal = new Vector3();
  const isFar = ({ box }) =>
    box.getSize(diagonal).length() * pixels < kLeastPixels * box.distanceToPoint(camera.position);
  return new Set(objects.filter(isFar));
}
