// meshoptimizer's decoder (MIT), bundled on its own so that only models that it compressed fetch it.
export { MeshoptDecoder } from "meshoptimizer/decoder";
