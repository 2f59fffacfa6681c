// The first module, drawing into a canvas: instance, memory and WebGL context go together.
import { Library } from "./library.js";
import { webglImports } from "./webgl.js";

export class Engine extends Library {
  /** Rejects with a sentence for people when WebGL 2 is missing. */
  static async open(canvas, module) {
    const gl = canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false, stencil: false, premultipliedAlpha: true,
                                             preserveDrawingBuffer: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("WebGL 2 is not available in this browser");
    if (!gl.getExtension("EXT_color_buffer_float")) throw new Error("this browser's WebGL 2 cannot render to float textures");
    gl.getExtension("OES_texture_float_linear");
    const engine = await super.create(module, "tukor", (memory) => webglImports(gl, memory));
    engine.gl = gl;
    engine.call("start");
    return engine;
  }

  destroy() {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
