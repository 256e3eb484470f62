// Tells whether things of two files look the same: files share nothing, so shapes and paints are told by what is in
// them.
const shapes = new WeakMap();

/** Returns FNV-1a over the bytes, a number. */
function hashOf(array) {
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return hash >>> 0;
}

/** Returns a text that is the same for geometries with the same points. */
export function shapeOf(geometry) {
  if (!shapes.has(geometry)) {
    const positions = geometry.getAttribute('position');
    const array = positions.isInterleavedBufferAttribute ? positions.data.array : positions.array;
    shapes.set(geometry, `${positions.count}:${hashOf(array)}`);
  }
  return shapes.get(geometry);
}

/** Returns a text that is the same for materials that look the same. */
export function paintOf(material) {
  const { color, roughness, metalness, emissive, opacity, map } = material;
  return [color?.getHexString(), roughness, metalness, emissive?.getHexString(), opacity, map?.name].join(' ');
}
