// Models compressed by Draco or meshopt, made plain glTF; on its own so that only pages with some fetch it, and each decoder by itself.
import { viewBytes } from "./gltf-buffers.js";
import { compiled } from "./library.js";

const PER_BYTE = 1024; // points or corners that may come out of a byte of Draco's
const LEAST_MEMORY = 2 ** 26, MOST_MEMORY = 2 ** 30, MEMORY_EACH = 512; // bytes that its decoder may have
const FLOAT = 5126, SHORT = 5123, INT = 5125; // of glTF

/** The same model, as {bytes, files}. */
export async function unpack(name, contents, files) {
  try {
    const json = structuredClone(contents.json);
    const pieces = [];
    let size = 0;
    const put = (bytes) => {
      const byteOffset = size;
      pieces.push(bytes, new Uint8Array(-bytes.length & 3));
      size += (bytes.length + 3) & ~3;
      return { buffer: json.buffers.length, byteOffset, byteLength: bytes.length };
    };
    const bytesOf = (view) => viewBytes(view, contents, files);
    if (json.extensionsUsed.includes("EXT_meshopt_compression")) await unpackMeshopt(json, bytesOf, put);
    if (json.extensionsUsed.includes("KHR_draco_mesh_compression")) await unpackDraco(json, bytesOf, put);
    json.buffers.push({ uri: "(unpacked)", byteLength: size });
    const more = [["(unpacked)", new Uint8Array(await new Blob(pieces).arrayBuffer())]];
    if (contents.binary) {
      json.buffers[0].uri = "(binary)";
      more.push(["(binary)", contents.binary]);
    }
    return { bytes: new TextEncoder().encode(JSON.stringify(json)), files: [...files, ...more] };
  } catch (error) {
    throw new Error(`${name}: compressed data that cannot be read: ${error.message}`);
  }
}

async function unpackMeshopt(json, bytesOf, put) {
  const { MeshoptDecoder: decoder } = await import("./meshopt.js");
  await decoder.ready;
  for (const [i, view] of json.bufferViews.entries()) {
    const packed = view.extensions?.EXT_meshopt_compression;
    if (!packed) continue;
    const { count, byteStride, mode, filter } = packed;
    const source = bytesOf(packed);
    if (!(count * byteStride <= 64 * source.length + 16 * byteStride)) throw new Error(`${count} elements cannot come out of ${source.length} bytes`);
    const target = new Uint8Array(count * byteStride);
    decoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
    json.bufferViews[i] = { ...(view.byteStride && { byteStride: view.byteStride }), ...put(target) };
  }
}

/** Draco's decoder, anew for each model: a damaged stream may leave it unusable, and nothing has to be freed. `most()` bounds its memory. */
async function dracoDecoder(most) {
  const [{ default: create }, module] = await Promise.all([import("./draco.js"), compiled("draco_decoder_gltf.wasm")]);
  return create({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then((instance) => {
        const memory = Object.values(instance.exports).find((value) => value instanceof WebAssembly.Memory);
        memory.grow = (pages) => {
          if (memory.buffer.byteLength + 65536 * pages > most()) throw new RangeError();
          return WebAssembly.Memory.prototype.grow.call(memory, pages);
        };
        done(instance);
      });
      return {};
    },
  });
}

async function unpackDraco(json, bytesOf, put) {
  let announced = 0; // points and corners, by the accessors of all streams so far
  const draco = await dracoDecoder(() => Math.min(MOST_MEMORY, LEAST_MEMORY + MEMORY_EACH * announced));
  const add = (componentType, type, count, array) => {
    const view = json.bufferViews.push(put(new Uint8Array(array.buffer))) - 1;
    return json.accessors.push({ bufferView: view, componentType, type, count }) - 1;
  };
  const read = (bytes, into) => { // what `into` puts at an address
    const at = draco._malloc(bytes);
    if (!at || !into(bytes, at)) throw new Error(`no ${bytes} bytes in a Draco stream`);
    return draco.HEAPU8.slice(at, at + bytes);
  };
  for (const { primitives } of json.meshes)
    for (const primitive of primitives) {
      const packed = primitive.extensions?.KHR_draco_mesh_compression;
      if (!packed) continue;
      const bytes = bytesOf(json.bufferViews[packed.bufferView]);
      const [mostPoints, mostCorners] = [primitive.attributes.POSITION, primitive.indices].map((accessor) => json.accessors[accessor].count);
      announced += mostPoints + mostCorners;
      if (!(mostPoints + mostCorners <= PER_BYTE * bytes.length)) throw new Error(`${mostPoints} points and ${mostCorners} corners cannot come out of ${bytes.length} bytes`);
      const decoder = new draco.Decoder();
      const mesh = new draco.Mesh();
      const status = decoder.DecodeArrayToMesh(bytes, bytes.length, mesh);
      if (!status.ok()) throw new Error(status.error_msg());
      const points = mesh.num_points(), corners = 3 * mesh.num_faces();
      if (points > mostPoints || corners > mostCorners)
        throw new Error(`${points} points and ${corners} corners in a Draco stream; its accessors announce ${mostPoints} and ${mostCorners}`);
      for (const [name, id] of Object.entries(packed.attributes)) {
        const attribute = decoder.GetAttributeByUniqueId(mesh, id);
        if (!attribute.ptr) throw new Error(`no ${name} in a Draco stream`);
        const { type } = json.accessors[primitive.attributes[name]];
        const values = points * attribute.num_components();
        const [component, width, kind] = name.startsWith("JOINTS") ? [SHORT, 2, draco.DT_UINT16] : [FLOAT, 4, draco.DT_FLOAT32];
        const array = read(values * width, (size, at) => decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, kind, size, at));
        primitive.attributes[name] = add(component, type, points, array);
      }
      primitive.indices = add(INT, "SCALAR", corners, read(4 * corners, (size, at) => decoder.GetTrianglesUInt32Array(mesh, size, at)));
      delete primitive.mode; // always triangles
      delete primitive.extensions.KHR_draco_mesh_compression;
    }
}
