// Draws objects in batches: all parts of one shape, paint and style are one draw call, so that ten thousand chairs are
// as quick as one.
import { Group, InstancedMesh } from 'three';
import { Boxes } from './boxes.js';
import { isFar, layersFor } from './styles.js';

class Batch {
  constructor(geometry, material, style) {
    Object.assign(this, { geometry, style, base: material, parts: [], meshes: [] });
    this.layers = layersFor(material, style);
  }

  /** Makes the meshes anew from the parts {object, matrix}. */
  build(group) {
    this.clear(group);
    for (const { material, shadow } of this.layers) {
      const mesh = new InstancedMesh(this.geometry, material, this.parts.length);
      this.parts.forEach(({ matrix }, index) => mesh.setMatrixAt(index, matrix));
      mesh.castShadow = shadow;
      mesh.receiveShadow = true;
      mesh.userData.batch = this;
      this.meshes.push(mesh);
      group.add(mesh);
    }
  }

  clear(group) {
    for (const mesh of this.meshes) {
      group.remove(mesh);
      mesh.dispose();
    }
    this.meshes = [];
  }

  dispose(group) {
    this.clear(group);
    for (const { material } of this.layers) {
      if (material !== this.base) material.dispose();
    }
  }
}

export class Batches {
  constructor() {
    this.group = new Group();
    this.batches = new Map();
    this.styles = new Map();  // by object
    this.boxes = new Boxes();
  }

  show(objects, styleOf) {
    this.clear();
    for (const object of objects) this.#put(object, styleOf(object));
    this.#build(this.batches.values());
  }

  /** Changes the styles of objects that are shown. Returns whether any changed. */
  restyle(styleOf) {
    const moving = [...this.styles].filter(([object, style]) => styleOf(object) !== style);
    if (moving.length === 0) return false;
    const touched = new Set();
    const leaving = new Set(moving.map(([object]) => object));
    for (const batch of this.batches.values()) {
      const staying = batch.parts.filter(({ object }) => !leaving.has(object));
      if (staying.length === batch.parts.length) continue;
      batch.parts = staying;
      touched.add(batch);
    }
    for (const [object] of moving) this.#put(object, styleOf(object)).forEach((batch) => touched.add(batch));
    this.#build(touched);
    return true;
  }

  /** Returns the object that a ray's hit belongs to. */
  objectAt({ object: mesh, instanceId }) {
    return mesh.userData.batch.parts[instanceId].object;
  }

  styleOf(object) {
    return this.styles.get(object);
  }

  clear() {
    for (const batch of this.batches.values()) batch.dispose(this.group);
    this.batches.clear();
    this.styles.clear();
    this.boxes.clear();
  }

  #put(object, style) {
    this.styles.set(object, style);
    return object.parts.map(({ geometry, material, matrix }) => {
      const batch = this.#batch(isFar(style) ? this.boxes.of(geometry) : geometry, material, style);
      batch.parts.push({ object, matrix });
      return batch;
    });
  }

  #batch(geometry, material, style) {
    const key = `${geometry.uuid} ${material.uuid} ${style}`;
    if (!this.batches.has(key)) this.batches.set(key, new Batch(geometry, material, style));
    return this.batches.get(key);
  }

  #build(batches) {
    for (const batch of batches) batch.build(this.group);
  }
}
