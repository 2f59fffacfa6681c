// The third module, on its own so that only pages with rough, diffuse or textured surfaces, a ground or dispersion fetch it.
import { lazily } from "./library.js";

const library = lazily("tukor-finish", "finish");

/** Of an environment's radiance: its filtered chain and the table of the split sum, as textures hold them; what lights a ground, the spectrum; and the shaders. */
export async function prepare(radiance, { width, height, scale }) {
  const finish = await library();
  await finish.gather();
  const size = finish.call("light", radiance.subarray(0, 3 * width * height), width, height, scale);
  const bytes = (at, length) => finish.memory.bytes.slice(at, at + length);
  return {
    tables: [bytes(finish.wasm.finish_ground(), finish.wasm.finish_ground_bytes()), bytes(finish.wasm.finish_spectrum(), 65 * 16)],
    light: { chain: bytes(finish.wasm.finish_chain(), size), table: bytes(finish.wasm.finish_table(), 8 * 32 * 32) },
    shaders: [finish.text("shader"), finish.text("traced_shader")],
  };
}
