// The light and the ground: a sun at the right, a bright sky, soft shadows.
import {
  CircleGeometry, DataTexture, DirectionalLight, EquirectangularReflectionMapping, Group, HemisphereLight, Mesh,
  ShadowMaterial, SRGBColorSpace, Vector3,
} from 'three';

const kToSun = new Vector3(0.55, 1, 0.42).normalize();
const kShadowMap = 2048;  // pixels along a side; it is drawn anew only when things change

/** Returns what polished things reflect: a bright sky with a window's light in it, above a dim ground. It is small,
 * since nothing that is shown is a mirror, and to prepare a large one takes long without a graphics card. */
export function surroundings() {
  const width = 64, height = 32;
  const data = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const up = y / (height - 1);  // rows come from below
      const isWindow = up > 0.62 && up < 0.85 && x % 21 < 8;
      const light = isWindow ? 255 : up < 0.5 ? 90 + 80 * up : 165 + 60 * up;
      data.set([light, light, Math.min(255, light * 1.03), 255], 4 * (y * width + x));
    }
  }
  const texture = new DataTexture(data, width, height);
  Object.assign(texture, { mapping: EquirectangularReflectionMapping, colorSpace: SRGBColorSpace, needsUpdate: true });
  return texture;
}

function sunFor(box) {
  const sun = new DirectionalLight(0xfffaf2, 2.1);
  const center = box.getCenter(new Vector3());
  const radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-3);
  sun.target.position.copy(center);
  sun.position.copy(center).addScaledVector(kToSun, radius * 2);
  sun.castShadow = true;
  sun.shadow.mapSize.set(kShadowMap, kShadowMap);
  sun.shadow.radius = 5;
  sun.shadow.normalBias = radius * 0.002;
  Object.assign(sun.shadow.camera, {
    left: -radius, right: radius, top: radius, bottom: -radius, near: radius * 0.5, far: radius * 3.5,
  });
  return sun;
}

function groundFor(box) {
  const size = box.getSize(new Vector3());
  const ground = new Mesh(new CircleGeometry(Math.max(size.length(), 1e-3) * 4, 48), new ShadowMaterial({ opacity: 0.28 }));
  ground.rotation.x = -Math.PI / 2;
  ground.position.copy(box.getCenter(new Vector3())).setY(box.min.y - size.length() * 2e-4);
  ground.receiveShadow = true;
  return ground;
}

/** Returns what lights a scene that fills the box. */
export function lightingFor(box) {
  const group = new Group();
  const sun = sunFor(box);
  group.add(new HemisphereLight(0xffffff, 0xd8d3cb, 1.9), sun, sun.target, groundFor(box));
  return group;
}

/** Frees what a scene's lighting holds. */
export function disposeOfLighting(group) {
  group.traverse((each) => {
    each.shadow?.dispose();
    each.geometry?.dispose();
    each.material?.dispose();
  });
}
