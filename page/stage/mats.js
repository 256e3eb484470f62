// Mats that things lie on which stand elsewhere in the other of two solutions: the things keep their colours, and one
// sees from afar which they are.
import { DoubleSide, Group, InstancedMesh, Matrix4, MeshBasicMaterial, PlaneGeometry, Quaternion, Vector3 } from 'three';

const kColour = 0xf5a030;
const kShare = 0.014;   // of the scene's extent: how far a mat reaches beyond its thing
const kWidest = 0.15;   // metres
const kHeight = 0.1;    // of that, above the thing's foot

/** Returns where the mat of a box lies. */
function placeOf(box, margin) {
  const center = box.getCenter(new Vector3()).setY(box.min.y + kHeight * margin);
  const size = box.getSize(new Vector3()).addScalar(2 * margin).setY(1);
  return new Matrix4().compose(center, new Quaternion(), size);
}

export class Mats {
  constructor() {
    this.group = new Group();
    this.geometry = new PlaneGeometry(1, 1).rotateX(-Math.PI / 2);
    this.material = new MeshBasicMaterial({ color: kColour, side: DoubleSide, toneMapped: false });
  }

  /** Lays mats under boxes (three.js' Box3) in place of those that lie there; `extent` is that of the scene. */
  lay(boxes, extent) {
    this.clear();
    if (boxes.length === 0) return;
    const margin = Math.min(kShare * extent, kWidest);
    this.mesh = new InstancedMesh(this.geometry, this.material, boxes.length);
    boxes.forEach((box, index) => this.mesh.setMatrixAt(index, placeOf(box, margin)));
    this.group.add(this.mesh);
  }

  clear() {
    this.group.clear();
    this.mesh?.dispose();
    this.mesh = null;
  }

  dispose() {
    this.clear();
    this.geometry.dispose();
    this.material.dispose();
  }
}
