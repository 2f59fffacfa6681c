// The second module, on its own so that only pages which need it fetch it: built-in shapes and skies, other model formats, cube maps.
import { lazily } from "./library.js";

const extras = lazily("tukor-extras", "extras");

function made({ wasm, memory }) {
  const at = wasm.extras_bytes();
  return memory.bytes.slice(at, at + wasm.extras_size());
}

/** A scene's bytes: of a built-in shape where there are no bytes. */
export async function model({ name, bytes = new Uint8Array(), files }) {
  const library = await extras();
  await library.gather();
  for (const [path, content] of files) library.call("add_file", path, content, content.length);
  library.call("model", name, bytes, bytes.length);
  return made(library);
}

/** What the library reads: .ktx2 without zstd. */
async function plainTexture(name, bytes) {
  const compressed = bytes.length > 80 && bytes[5] === 0x32 && bytes[44] === 2; // KTX 2, whose scheme that is
  return compressed ? (await import("./ktx2-zstd.js")).expanded(name, bytes) : bytes;
}

/** A cube map's texels: of a built-in environment where there is no image, else of one that readEnvironment() read. */
export async function environment(name, image) {
  const library = await extras();
  await library.gather();
  const bytes = image?.texture ? await plainTexture(name, image.texture) : (image?.bytes ?? new Uint8Array());
  const faceSize =
    image?.radiance ? library.call("environment_radiance", name, image.radiance, image.width, image.height)
    : image?.srgb ? library.call("environment_srgb", name, image.srgb, image.width, image.height)
    : library.call(image?.texture ? "environment_texture" : "environment", name, bytes, bytes.length);
  return { faceSize, texels: made(library), warnings: library.json("warnings") };
}
