// Reads the .glb of a solution: its objects with what the program says of each, and what to draw for them.
import { Box3, Euler, Matrix4, Quaternion, Vector3 } from 'three';
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

/** Returns the meshes of a node of instances, each at the place of one of them. */
function partsOfInstance(meshes, index) {
  return meshes.map((mesh) => {
    const matrix = new Matrix4();
    mesh.getMatrixAt(index, matrix);
    return { geometry: mesh.geometry, material: mesh.material, matrix: matrix.premultiply(mesh.matrixWorld) };
  });
}

/** Returns the degrees that what has this matrix is turned about the upward axis, 0 to 360. */
function turnOf(matrix) {
  const rotation = new Quaternion();
  matrix.decompose(new Vector3(), rotation, new Vector3());
  const turn = new Euler().setFromQuaternion(rotation, 'YXZ').y;
  return (Math.round(turn * 18000 / Math.PI) / 100 + 360) % 360;
}

function objectOf(about, name, parts, matrix, path, index) {
  const box = boxOf(parts);
  const object = {
    index,
    name,
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
    turn: turnOf(matrix),
    shape: parts.map(({ geometry }) => shapeOf(geometry)).join('+'),
    paint: parts.map(({ material }) => paintOf(material)).join('+'),
  };
  object.look = JSON.stringify([object.shape, object.paint, object.center, object.size, object.turn]);
  return object;
}

/** Of instances the node holds what each would say by itself. */
function collectInstances(node, path, objects) {
  const meshes = [];
  node.traverse((each) => each.isInstancedMesh && meshes.push(each));
  JSON.parse(node.userData.instances).forEach((about, index) => {
    const parts = partsOfInstance(meshes, index);
    objects.push(objectOf(about, about.name, parts, parts[0].matrix, path, objects.length));
  });
}

function collect(node, path, objects) {
  if (typeof node.userData.address === 'string') {
    const { userData: about, matrixWorld } = node;
    objects.push(objectOf(about, about.name ?? node.name, partsOf(node), matrixWorld, path, objects.length));
    return;
  }
  if (typeof node.userData.instances === 'string') return collectInstances(node, path, objects);
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
