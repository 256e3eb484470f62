// Bytes that scripts hold as base64 of what zlib made of them.

/** Returns the bytes, as an ArrayBuffer. */
export async function inflated(base64) {
  const packed = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

/** Returns the value whose JSON text was packed. */
export async function inflatedJson(base64) {
  return JSON.parse(new TextDecoder().decode(await inflated(base64)));
}
