// A small closed model as a GLB file: an octahedron.

const GLASS = { name: "clear", extensions: { KHR_materials_transmission: { transmissionFactor: 1 } }, pbrMetallicRoughness: { roughnessFactor: 0 } };

/** Of clear glass, or another material of glTF. */
export function solidFile(material = GLASS) {
  const corners = [[1, 0, 0], [0, 0, -1], [-1, 0, 0], [0, 0, 1], [0, 1, 0], [0, -1, 0]];
  const triangles = [0, 1, 2, 3].flatMap((i) => [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]]);
  const positions = Buffer.from(Float32Array.from(corners.flat()).buffer);
  const indices = Buffer.from(Uint16Array.from(triangles.flat()).buffer);
  const binary = Buffer.concat([positions, indices]);
  const json = {
    asset: { version: "2.0" },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: "solid" }],
    meshes: [{ name: "solid", primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }],
    materials: [material],
    extensionsUsed: Object.keys(material.extensions ?? {}),
    accessors: [
      { bufferView: 0, componentType: 5126, count: corners.length, type: "VEC3", min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5123, count: 3 * triangles.length, type: "SCALAR" },
    ],
    bufferViews: [{ buffer: 0, byteLength: positions.length }, { buffer: 0, byteOffset: positions.length, byteLength: indices.length }],
    buffers: [{ byteLength: binary.length }],
  };
  let text = JSON.stringify(json);
  text += " ".repeat((4 - (text.length % 4)) % 4);
  const chunk = (type, bytes) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0);
    head.writeUInt32LE(type, 4);
    return Buffer.concat([head, bytes]);
  };
  const body = Buffer.concat([chunk(0x4e4f534a, Buffer.from(text)), chunk(0x004e4942, binary)]);
  const head = Buffer.from("glTF\x02\0\0\0\0\0\0\0", "latin1");
  head.writeUInt32LE(12 + body.length, 8);
  return Buffer.concat([head, body]);
}
