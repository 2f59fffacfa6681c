// The file of solid.mjs compressed by meshopt or Draco, without loss.
import { MeshoptEncoder } from "meshoptimizer/encoder";
import draco3d from "draco3dgltf";
import { gltfContents } from "../src/gltf-json.js";
import { glbFile } from "./solid.mjs";

/** A GLB whose binary chunk is `pieces`, and whose buffer 0 that is; `views` gets where each of them lies. */
function packed(json, pieces, name, views) {
  let offset = 0;
  const padded = pieces.map((piece) => Buffer.concat([piece, Buffer.alloc(-piece.length & 3)]));
  pieces.forEach((piece, i) => {
    views(i, { buffer: 0, byteOffset: offset, byteLength: piece.length });
    offset += padded[i].length;
  });
  json.buffers[0].byteLength = offset;
  json.extensionsUsed.push(name);
  json.extensionsRequired = [name];
  return glbFile(json, Buffer.concat(padded));
}

/** The same GLB after `change(json, binary)`, which may give another binary chunk. */
export function changed(glb, change) {
  const { json, binary } = gltfContents(glb);
  const other = change(json, binary) ?? binary;
  return glbFile(json, Buffer.from(other));
}

/** A copy: where a view of a Buffer begins is nobody's business. */
const bytesOf = ({ binary }, { byteOffset, byteLength }) => Uint8Array.from(binary.subarray(byteOffset, byteOffset + byteLength));

export async function meshoptFile(glb) {
  await MeshoptEncoder.ready;
  const contents = gltfContents(glb);
  const { json } = contents;
  const kinds = [{ mode: "ATTRIBUTES", byteStride: 12 }, { mode: "TRIANGLES", byteStride: 2 }, { mode: "ATTRIBUTES", byteStride: 8 }]; // of solid.mjs; then pictures
  const pieces = json.bufferViews.map((view, i) => {
    const bytes = bytesOf(contents, view);
    if (!kinds[i]) return bytes;
    kinds[i].count = bytes.length / kinds[i].byteStride;
    return MeshoptEncoder.encodeGltfBuffer(bytes, kinds[i].count, kinds[i].byteStride, kinds[i].mode);
  });
  json.buffers.push({ byteLength: 999999, extensions: { EXT_meshopt_compression: { fallback: true } } });
  return packed(json, pieces, "EXT_meshopt_compression", (i, where) => {
    const { byteLength } = json.bufferViews[i];
    json.bufferViews[i] = kinds[i] ? { buffer: 1, byteLength, extensions: { EXT_meshopt_compression: { ...where, ...kinds[i] } } } : where;
  });
}

export async function dracoFile(glb) {
  const contents = gltfContents(glb);
  const { json } = contents;
  const [positions, indices, uvs, ...pictures] = json.bufferViews.map((view) => bytesOf(contents, view));
  const draco = await draco3d.createEncoderModule();
  const builder = new draco.MeshBuilder();
  const mesh = new draco.Mesh();
  const corners = new Uint16Array(indices.buffer);
  builder.AddFacesToMesh(mesh, corners.length / 3, Uint32Array.from(corners));
  const attributes = {
    POSITION: builder.AddFloatAttributeToMesh(mesh, draco.POSITION, positions.length / 12, 3, new Float32Array(positions.buffer)),
    TEXCOORD_0: builder.AddFloatAttributeToMesh(mesh, draco.TEX_COORD, uvs.length / 8, 2, new Float32Array(uvs.buffer)),
  };
  const encoder = new draco.Encoder();
  encoder.SetEncodingMethod(draco.MESH_SEQUENTIAL_ENCODING);
  const out = new draco.DracoInt8Array();
  const size = encoder.EncodeMeshToDracoBuffer(mesh, out);
  const stream = Buffer.from(Int8Array.from({ length: size }, (_, i) => out.GetValue(i)).buffer);
  json.bufferViews = [];
  for (const image of json.images ?? []) image.bufferView = 1;
  for (const accessor of json.accessors) delete accessor.bufferView;
  json.meshes[0].primitives[0].extensions = { ...json.meshes[0].primitives[0].extensions, KHR_draco_mesh_compression: { bufferView: 0, attributes } };
  return packed(json, [stream, ...pictures], "KHR_draco_mesh_compression", (_, where) => json.bufferViews.push(where));
}
