// A small closed model as a GLB file: an octahedron, with one or two materials to choose from and a picture.
import { deflateSync } from "node:zlib";

const GLASS = { name: "clear", extensions: { KHR_materials_transmission: { transmissionFactor: 1 } }, pbrMetallicRoughness: { roughnessFactor: 0 } };

/**
 * Of clear glass, or another material of glTF; `other` is that of its variant "other"; `image` is a picture file, texture 0, laid over
 * the model from left to right.
 */
export function solidFile(material = GLASS, { other = null, image = null } = {}) {
  const corners = [[1, 0, 0], [0, 0, -1], [-1, 0, 0], [0, 0, 1], [0, 1, 0], [0, -1, 0]];
  const triangles = [0, 1, 2, 3].flatMap((i) => [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]]);
  const views = [Float32Array.from(corners.flat()), Uint16Array.from(triangles.flat()), Float32Array.from(corners.flatMap(([x, y]) => [0.5 + 0.5 * x, 0.5 - 0.5 * y]))]
    .map((array) => Buffer.from(array.buffer));
  if (image) views.push(Buffer.concat([image, Buffer.alloc((4 - (image.length % 4)) % 4)]));
  let offset = 0;
  const bufferViews = views.map((view) => ({ buffer: 0, byteLength: view.length, byteOffset: (offset += view.length) - view.length }));
  const binary = Buffer.concat(views);
  const materials = other ? [material, other] : [material];
  const primitive = { attributes: { POSITION: 0, TEXCOORD_0: 2 }, indices: 1, material: 0 };
  if (other) primitive.extensions = { KHR_materials_variants: { mappings: [{ material: 1, variants: [0] }] } };
  const json = {
    asset: { version: "2.0" },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: "solid" }],
    meshes: [{ name: "solid", primitives: [primitive] }],
    materials,
    ...(other && { extensions: { KHR_materials_variants: { variants: [{ name: "other" }] } } }),
    ...(image && { images: [{ bufferView: 3, mimeType: "image/png" }], textures: [{ source: 0 }] }),
    extensionsUsed: [...materials.flatMap(({ extensions }) => Object.keys(extensions ?? {})), ...(other ? ["KHR_materials_variants"] : [])],
    accessors: [
      { bufferView: 0, componentType: 5126, count: corners.length, type: "VEC3", min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5123, count: 3 * triangles.length, type: "SCALAR" },
      { bufferView: 2, componentType: 5126, count: corners.length, type: "VEC2" },
    ],
    bufferViews,
    buffers: [{ byteLength: binary.length }],
  };
  return glbFile(json, binary);
}

export function glbFile(json, binary) {
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

function crc32(bytes) {
  let crc = -1;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

/** A PNG of one row of colours, four numbers each. */
export function pngRow(colours) {
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name, "latin1"), data]);
    const out = Buffer.alloc(8 + body.length);
    out.writeUInt32BE(data.length, 0);
    body.copy(out, 4);
    out.writeUInt32BE(crc32(body), 4 + body.length);
    return out;
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(colours.length, 0);
  header.writeUInt32BE(1, 4);
  header.set([8, 6, 0, 0, 0], 8);
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", header), chunk("IDAT", deflateSync(Buffer.from([0, ...colours.flat()]))), chunk("IEND", Buffer.alloc(0))]);
}
