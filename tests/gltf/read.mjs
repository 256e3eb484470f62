// node read.mjs FILE.glb...: reads the files with other programs' readers, three.js and assimp, and says where these find
// other nodes, meshes, names or extras than the file has. Exits 1 if they do.
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { isDeepStrictEqual } from 'node:util';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

// What three.js asks of a browser while it reads files without images.
globalThis.self = globalThis;

function documentOf(bytes) {
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
}

/// What a file says by itself: its named nodes with their extras, and what they show.
function expected(document) {
  const primitives = (node) => (node.mesh === undefined ? 0 : document.meshes[node.mesh].primitives.length);
  return {
    extras: new Map(document.nodes.map((node) => [node.name, node.extras ?? {}])),
    shown: document.nodes.reduce((sum, node) => sum + primitives(node), 0),
    primitives: document.meshes.reduce((sum, mesh) => sum + mesh.primitives.length, 0),
  };
}

async function* faultsOfThree(bytes, wanted) {
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const { scene } = await new GLTFLoader().parseAsync(buffer, '');
  const found = new Map();
  let shown = 0;
  scene.traverse((object) => {
    if (object.isMesh) shown += 1;
    const { name, ...extras } = object.userData;
    if (wanted.extras.has(name)) found.set(name, extras);
  });
  if (shown !== wanted.shown) yield `three.js shows ${shown} meshes, not ${wanted.shown}`;
  for (const [name, extras] of wanted.extras) {
    if (!found.has(name)) yield `three.js has no "${name}"`;
    else if (!isDeepStrictEqual(withoutName(extras), withoutName(found.get(name)))) yield `three.js has other extras of "${name}"`;
  }
}

function withoutName({ name, ...others }) {
  return others;
}

function* faultsOfAssimp(file, wanted) {
  const text = execFileSync('assimp', ['info', file, '-r'],  // raw: as the file has it
    { encoding: 'utf8', maxBuffer: 1 << 28 });
  const number = (what) => Number(new RegExp(`^${what}:\\s+(\\d+)`, 'm').exec(text)?.[1]);
  if (number('Nodes') !== wanted.extras.size + 1) yield `assimp has ${number('Nodes')} nodes, not ${wanted.extras.size} and a root`;
  if (number('Meshes') !== wanted.primitives) yield `assimp has ${number('Meshes')} meshes, not ${wanted.primitives}`;
  for (const name of wanted.extras.keys()) {
    if (!text.includes(name)) yield `assimp has no "${name}"`;
  }
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error('usage: node read.mjs FILE.glb...');
  process.exit(2);
}
let faults = 0;
for (const file of files) {
  const bytes = await readFile(file);
  const wanted = expected(documentOf(bytes));
  const found = [...faultsOfAssimp(file, wanted)];
  for await (const fault of faultsOfThree(bytes, wanted)) found.push(fault);
  for (const fault of found) console.log(`${file}: ${fault}`);
  faults += found.length;
}
console.log(`${files.length} files, ${faults} faults`);
process.exit(faults === 0 ? 0 : 1);
