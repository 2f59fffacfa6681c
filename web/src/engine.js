// The WebAssembly side: one instance of the C++ library per element, its calls and its errors in JavaScript's terms.
//
// The compiled code is fetched once a page and shared; an instance owns its memory and its WebGL context, and both go with it.

let compiled = null;

async function instantiate() {
  const { default: createModule } = await import("./tukor.js");
  compiled ??= WebAssembly.compileStreaming(fetch(new URL("./tukor.wasm", import.meta.url))).catch(async () => {
    // Servers that send another type than application/wasm.
    const response = await fetch(new URL("./tukor.wasm", import.meta.url));
    if (!response.ok) throw new Error(`tukor.wasm: ${response.status} ${response.statusText}`);
    return WebAssembly.compile(await response.arrayBuffer());
  });
  const module = await compiled.catch((error) => { compiled = null; throw error; });
  return createModule({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
      return {};
    },
  });
}

export class Engine {
  /** Draws into `canvas`. Rejects with a sentence for people when WebGL 2 is missing. */
  static async create(canvas) {
    const engine = new Engine();
    engine.wasm = await instantiate();
    const gl = canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false, stencil: false, premultipliedAlpha: true,
                                             preserveDrawingBuffer: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("WebGL 2 is not available in this browser");
    if (!gl.getExtension("EXT_color_buffer_float"))
      throw new Error("this browser's WebGL 2 cannot render to float textures");
    gl.getExtension("OES_texture_float_linear");
    engine.gl = gl;
    const GL = engine.wasm.GL;
    engine.context = GL.registerContext(gl, { majorVersion: 2, enableExtensionsByDefault: false });
    GL.makeContextCurrent(engine.context);
    engine.call("tukor_start");
    return engine;
  }

  /** Calls an exported function; a negative result is an error whose text the library holds. */
  call(name, ...args) {
    const { wasm } = this;
    if (this.context) wasm.GL.makeContextCurrent(this.context);
    const owned = [];
    const values = args.map((arg) => {
      if (typeof arg === "string") {
        const bytes = new TextEncoder().encode(arg + "\0");
        const at = wasm._malloc(bytes.length);
        wasm.HEAPU8.set(bytes, at);
        owned.push(at);
        return at;
      }
      if (ArrayBuffer.isView(arg)) {
        const at = wasm._malloc(Math.max(arg.byteLength, 1));
        wasm.HEAPU8.set(new Uint8Array(arg.buffer, arg.byteOffset, arg.byteLength), at);
        owned.push(at);
        return at;
      }
      return arg;
    });
    try {
      const result = wasm["_" + name](...values);
      if (result < 0) throw new Error(this.text("tukor_error"));
      return result;
    } finally {
      for (const at of owned) wasm._free(at);
    }
  }

  /** The string that an exported function returns. */
  text(name, ...args) {
    const at = this.wasm["_" + name](...args);
    const { HEAPU8 } = this.wasm;
    let end = at;
    while (HEAPU8[end]) end++;
    return new TextDecoder().decode(HEAPU8.slice(at, end));
  }

  json(name, ...args) {
    return JSON.parse(this.text(name, ...args));
  }

  destroy() {
    this.wasm?._tukor_stop();
    this.gl?.getExtension("WEBGL_lose_context")?.loseContext();
    if (this.context) this.wasm.GL.deleteContext(this.context);
    this.wasm = this.gl = this.context = null;
  }
}
