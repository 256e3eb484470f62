// Finds the place from which a camera sees all of a scene.
import { Vector3 } from 'three';

const kMargin = 1.06;

function* corners(box) {
  for (const x of [box.min.x, box.max.x])
    for (const y of [box.min.y, box.max.y])
      for (const z of [box.min.z, box.max.z]) yield new Vector3(x, y, z);
}

/** Returns the unit vector from a scene to its viewer: from its front, its right and above. */
export function threeQuarterView() {
  return new Vector3(0.62, 1, 1.1).normalize();
}

/** Returns {position, target} of the perspective camera that sees all objects' boxes from a direction. */
export function fitted(boxes, toCamera, camera) {
  const forward = toCamera.clone().negate();
  const right = new Vector3().crossVectors(forward, new Vector3(0, 1, 0)).normalize();
  const up = new Vector3().crossVectors(right, forward);
  const slopeUp = Math.tan(camera.fov * Math.PI / 360) / kMargin, slopeRight = slopeUp * camera.aspect;
  const extent = { right: [Infinity, -Infinity], up: [Infinity, -Infinity], nearest: Infinity, middle: 0 };
  const include = (range, across, reach) => {
    range[0] = Math.min(range[0], across + reach);
    range[1] = Math.max(range[1], across - reach);
  };
  let count = 0;
  for (const box of boxes) {
    for (const corner of corners(box)) {
      const ahead = corner.dot(forward);
      include(extent.right, corner.dot(right), slopeRight * ahead);
      include(extent.up, corner.dot(up), slopeUp * ahead);
      extent.middle += ahead;
      ++count;
    }
  }
  const back = Math.max((extent.right[1] - extent.right[0]) / (2 * slopeRight),
                        (extent.up[1] - extent.up[0]) / (2 * slopeUp));
  const across = (extent.right[0] + extent.right[1]) / 2, above = (extent.up[0] + extent.up[1]) / 2;
  const at = (ahead) => new Vector3().addScaledVector(right, across).addScaledVector(up, above)
    .addScaledVector(forward, ahead);
  return { position: at(-back), target: at(extent.middle / count) };
}
