// What the page itself has to know of a glTF file: its JSON, and the binary chunk of a GLB. Anything wrong is for the library to tell.

/** {json, binary}, or null where it is none. */
export function gltfContents(bytes) {
  try {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const text = (from, size) => new TextDecoder().decode(bytes.subarray(from, from + size));
    if (text(0, 4) !== "glTF") return { json: JSON.parse(text(0, bytes.length)), binary: null };
    const size = view.getUint32(12, true);
    const next = 20 + size;
    const binary = next + 8 <= bytes.length ? bytes.subarray(next + 8, next + 8 + view.getUint32(next, true)) : null;
    return { json: JSON.parse(text(20, size)), binary };
  } catch {
    return null;
  }
}

const listOf = (value) => (Array.isArray(value) ? value : []);

/** The other files that it names: buffers and images. */
export function neighbourUris(json) {
  return [...listOf(json?.buffers), ...listOf(json?.images)].map((item) => item?.uri).filter((uri) => typeof uri === "string" && !uri.startsWith("data:"));
}

/** [{name, duration}]; one lasts until the last moment of its samplers. */
export const animationsOf = ({ json }) => listOf(json.animations).map(({ name = "", samplers }) => (
  { name, duration: Math.max(0, ...listOf(samplers).map(({ input }) => json.accessors[input].max?.[0] || 0)) }));

export const imagesOf = (contents) => listOf(contents?.json?.images);

/** By Draco or meshopt, which the page unpacks. */
export const isCompressed = (contents) => listOf(contents?.json?.extensionsUsed).some((name) => /^(KHR_draco_mesh|EXT_meshopt)_compression$/.test(name));
