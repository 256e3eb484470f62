// How an object is drawn beside as it is: faded, marked as different, cut off low.
import { BackSide, Color, DoubleSide, MeshBasicMaterial, Plane, Vector3 } from 'three';

const kCutFill = 0x3a3d42;  // of cut walls, as pictures have it
const kMarks = { changed: 0xf08a24, only: 0x2f7fe0 };

function faded(material) {
  const variant = material.clone();
  variant.map = null;
  variant.color = new Color(0x8b9098);
  variant.emissive?.set(0);
  Object.assign(variant, { transparent: true, opacity: 0.13, depthWrite: false, metalness: 0, roughness: 1 });
  return [{ material: variant, shadow: false }];
}

function marked(material, color) {
  const variant = material.clone();
  variant.color.lerp(new Color(color), 0.55);
  variant.emissive?.set(color);
  variant.emissiveIntensity = 0.15;
  return [{ material: variant, shadow: true }];
}

function inStyle(material, name) {
  if (name === 'faded') return faded(material);
  return name in kMarks ? marked(material, kMarks[name]) : [{ material, shadow: !material.transparent }];
}

/** The part below a height. Seen from above, the inner sides look like a closed cut. */
function cutBelow(material, height) {
  const clippingPlanes = [new Plane(new Vector3(0, -1, 0), height)];
  const variant = material.clone();
  Object.assign(variant, { clippingPlanes, clipShadows: true });
  const inside = new MeshBasicMaterial({
    color: kCutFill, side: BackSide, clippingPlanes, toneMapped: false,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  return [{ material: variant, shadow: true }, { material: inside, shadow: false }];
}

/** Returns the text of a style that has a name ("plain", "faded", "moved", "changed" or "only"), and perhaps a height in metres
 * above which things are cut off, and whether they are far: "plain", "changed:0.3", "plain::far". */
export function styleOf(name, height, far) {
  return [name, height?.toFixed(3) ?? '', far ? 'far' : ''].join(':').replace(/:+$/, '');
}

/** Returns the layers {material, shadow} that draw a material in a style. A layer has the material itself, or a variant
 * that has to be disposed of. */
export function layersFor(material, style) {
  const name = style.split(':')[0], height = cutHeight(style);
  const layers = inStyle(material, name);
  if (height === Infinity || name === 'faded') return layers;
  return layers.flatMap((layer) => cutBelow(layer.material, height));
}

/** Returns the height at which a style cuts things off, or infinity. */
export function cutHeight(style) {
  const height = style.split(':')[1];
  return height ? Number(height) : Infinity;
}

export function isFar(style) {
  return style.endsWith(':far');
}

/** Returns a material that lies over an object to say that it is the selected one. */
export function selectionMaterial() {
  return new MeshBasicMaterial({
    color: 0x2f7fe0, transparent: true, opacity: 0.45, depthWrite: false, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2,
  });
}
