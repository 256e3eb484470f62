// Boxes that stand for shapes that are far away.
import { BoxGeometry, Triangle, Vector3 } from 'three';
import { triangles } from './far.js';

const kBoxTriangles = 12;
const kAttributes = new Set(['position', 'normal', 'uv']);  // those that a box has

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
