// The WebAssembly side: instances of the C++ library, their calls and their errors in JavaScript's terms.
//
// An instance owns its memory, and the first module's its WebGL context; both go with it.
import createModule from "../../build/web/apps/web/tukor.js";

/** An instance of a module; its functions begin with `prefix`. */
export class Library {
  constructor(wasm, prefix) {
    this.wasm = wasm;
    this.prefix = prefix;
  }

  static async create(createModule, module, prefix) {
    const wasm = await createModule({
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
        return {};
      },
    });
    return new this(wasm, prefix);
  }

  /** Calls an exported function; a negative result is an error whose text the library holds. */
  call(name, ...args) {
    const { wasm } = this;
    const owned = [];
    const values = args.map((arg) => {
      if (typeof arg === "string") arg = new TextEncoder().encode(arg + "\0");
      if (!ArrayBuffer.isView(arg)) return arg;
      const at = wasm._malloc(Math.max(arg.byteLength, 1));
      wasm.HEAPU8.set(new Uint8Array(arg.buffer, arg.byteOffset, arg.byteLength), at);
      owned.push(at);
      return at;
    });
    try {
      const result = wasm[`_${this.prefix}_${name}`](...values);
      if (result < 0) throw new Error(this.text("error"));
      return result;
    } finally {
      for (const at of owned) wasm._free(at);
    }
  }

  /** The string that an exported function returns. */
  text(name, ...args) {
    const at = this.wasm[`_${this.prefix}_${name}`](...args);
    const { HEAPU8 } = this.wasm;
    return new TextDecoder().decode(HEAPU8.slice(at, HEAPU8.indexOf(0, at)));
  }

  json(name, ...args) {
    return JSON.parse(this.text(name, ...args));
  }
}

/** The first module, drawing into a canvas. */
export class Engine extends Library {
  /** Rejects with a sentence for people when WebGL 2 is missing. */
  static async open(canvas, module) {
    const gl = canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false, stencil: false, premultipliedAlpha: true,
                                             preserveDrawingBuffer: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("WebGL 2 is not available in this browser");
    if (!gl.getExtension("EXT_color_buffer_float"))
      throw new Error("this browser's WebGL 2 cannot render to float textures");
    gl.getExtension("OES_texture_float_linear");
    const engine = await super.create(createModule, module, "tukor");
    const { GL } = engine.wasm;
    engine.gl = gl;
    engine.context = GL.registerContext(gl, { majorVersion: 2, enableExtensionsByDefault: false });
    GL.makeContextCurrent(engine.context);
    engine.call("start");
    return engine;
  }

  call(name, ...args) {
    this.wasm.GL.makeContextCurrent(this.context);
    return super.call(name, ...args);
  }

  destroy() {
    this.wasm._tukor_stop();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    this.wasm.GL.deleteContext(this.context);
  }
}
