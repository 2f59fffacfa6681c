// Draco's decoder for glTF (Apache-2.0), bundled on its own so that only models that it compressed fetch it.
export { default } from "draco3dgltf/draco_decoder_gltf_nodejs.js";
