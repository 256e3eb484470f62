// Reads the .glb of a solution: its objects with what the program says of each, and what to draw for them.
import { Box3, Euler, Quaternion, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { paintOf, shapeOf } from './looks.js';

const kOwnFacts = new Set(['name', 'address', 'source', 'choices', 'broken', 'unmet']);

function rounded(numbers) {
  return numbers.map((number) => Math.round(number * 1e4) / 1e4);
}

/** A list that a program calls so, or that a file holds as JSON text. */
function textsOf(list) {
  const read = typeof list === 'string' ? JSON.parse(list) : list ?? [];
  return Array.isArray(read) ? read.map(String) : [String(read)];
}

/** Returns the meshes at and below a node, each with its place in the world. */
function partsOf(node) {
  const parts = [];
  node.traverse((each) => {
    if (each.isMesh) parts.push({ geometry: each.geometry, material: each.material, matrix: each.matrixWorld });
  });
  return parts;
}

function boxOf(parts) {
  const box = new Box3();
  for (const { geometry, matrix } of parts) {
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    box.union(geometry.boundingBox.clone().applyMatrix4(matrix));
  }
  return box;
}

/** Returns the degrees that a node is turned about the upward axis, 0 to 360. */
function turnOf(node) {
  const turn = new Euler().setFromQuaternion(node.getWorldQuaternion(new Quaternion()), 'YXZ').y;
  return (Math.round(turn * 18000 / Math.PI) / 100 + 360) % 360;
}

function objectOf(node, path, index) {
  const about = node.userData;
  const parts = partsOf(node);
  const box = boxOf(parts);
  const object = {
    index,
    name: about.name ?? node.name,
    path,
    address: about.address,
    source: about.source ?? '',
    choices: about.choices ?? [],
    broken: textsOf(about.broken),
    unmet: textsOf(about.unmet),
    facts: Object.entries(about).filter(([name]) => !kOwnFacts.has(name)),
    parts,
    box,
    center: rounded(box.getCenter(new Vector3()).toArray()),
    size: rounded(box.getSize(new Vector3()).toArray()),
    turn: turnOf(node),
    shape: parts.map(({ geometry }) => shapeOf(geometry)).join('+'),
    paint: parts.map(({ material }) => paintOf(material)).join('+'),
  };
  object.look = JSON.stringify([object.shape, object.paint, object.center, object.size, object.turn]);
  return object;
}

function collect(node, path, objects) {
  if (typeof node.userData.address === 'string') {
    objects.push(objectOf(node, path, objects.length));
    return;
  }
  const within = [...path, node.userData.name ?? node.name];
  for (const child of node.children) collect(child, within, objects);
}

/** Returns the scene {objects, box, dispose()} that the bytes of a .glb hold. Objects are in the order of the file. */
export async function readScene(bytes) {
  const gltf = await new GLTFLoader().parseAsync(bytes, '');
  gltf.scene.updateMatrixWorld(true);
  const objects = [];
  for (const root of gltf.scene.children) collect(root, [], objects);
  const box = objects.reduce((all, object) => all.union(object.box), new Box3());
  const resources = new Set(objects.flatMap(({ parts }) => parts.flatMap((part) => [part.geometry, part.material])));
  return { objects, box, dispose: () => resources.forEach((each) => each.dispose()) };
}
