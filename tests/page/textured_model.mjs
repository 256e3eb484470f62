// A .glb of a square metre of ground whose texture is one red pixel.
import * as zlib from 'node:zlib';

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type), data]);
  const framed = Buffer.alloc(body.length + 8);
  framed.writeUInt32BE(data.length, 0);
  body.copy(framed, 4);
  framed.writeUInt32BE(crcOf(body), body.length + 4);
  return framed;
}

/** The checksum of PNG, which older versions of Node.js do not bring along. */
function crcOf(bytes) {
  if (zlib.crc32) return zlib.crc32(bytes);
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

function redPixel() {
  const header = Buffer.from([0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0]);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', header), chunk('IDAT', zlib.deflateSync(Buffer.from([0, 230, 10, 10]))), chunk('IEND', Buffer.alloc(0)),
  ]);
}

const padded = (buffer, fill) => Buffer.concat([buffer, Buffer.alloc(-buffer.length & 3, fill)]);

export function texturedModel() {
  const floats = (...numbers) => Buffer.from(new Float32Array(numbers).buffer);
  const parts = [
    floats(-0.5, 0, 0.5, 0.5, 0, 0.5, 0.5, 0, -0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, -0.5, 0, -0.5),
    floats(...Array(6).fill([0, 1, 0]).flat()),
    floats(0, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0, 0),
    padded(redPixel(), 0),
  ];
  let offset = 0;
  const bufferViews = parts.map((part) => {
    offset += part.length;
    return { buffer: 0, byteOffset: offset - part.length, byteLength: part.length };
  });
  const accessor = (bufferView, type, more = {}) => ({ bufferView, componentType: 5126, count: 6, type, ...more });
  const json = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, name: 'tile' }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } }],
    textures: [{ source: 0 }], images: [{ bufferView: 3, mimeType: 'image/png' }],
    accessors: [accessor(0, 'VEC3', { min: [-0.5, 0, -0.5], max: [0.5, 0, 0.5] }), accessor(1, 'VEC3'), accessor(2, 'VEC2')],
    bufferViews, buffers: [{ byteLength: offset }],
  };
  const text = padded(Buffer.from(JSON.stringify(json)), ' '), binary = Buffer.concat(parts);
  const framed = (type, data) => Buffer.concat([Buffer.from(new Uint32Array([data.length, type]).buffer), data]);
  const body = Buffer.concat([framed(0x4e4f534a, text), framed(0x004e4942, binary)]);
  return Buffer.concat([Buffer.from(new Uint32Array([0x46546c67, 2, body.length + 12]).buffer), body]);
}
