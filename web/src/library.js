// The C++ library's modules, fetched and instantiated: their memory, their calls, and their errors in JavaScript's terms.

const VIEWS = { bytes: Uint8Array, chars: Int8Array, shorts: Uint16Array, ints: Int32Array, words: Uint32Array, floats: Float32Array };

/** Where there may be threads: not where the page itself computes, which must not wait. */
export const threaded = self.crossOriginIsolated && !self.document;

/** An instance's memory, as typed arrays over all of it; made anew each time, for it grows. */
export class Memory {
  of = null;

  /** The text at an address, up to its zero byte or of so many bytes. */
  text(at, size = this.bytes.indexOf(0, at) - at) {
    return new TextDecoder().decode(this.bytes.slice(at, at + size)); // a copy: browsers refuse views of memory that may be shared
  }

  /** Puts a text and a zero byte. */
  put(at, text) {
    const bytes = new TextEncoder().encode(text + "\0");
    this.bytes.set(bytes, at);
    return bytes.length - 1;
  }
}

for (const [name, View] of Object.entries(VIEWS)) Object.defineProperty(Memory.prototype, name, { get() { return new View(this.of.buffer); } });

/** Digits as JavaScript writes them: the shortest that read back as the same number, or as many as asked for. */
function digitsOf(value, single, precision, type) {
  const figures = precision < 0 ? 6 : precision;
  if (type === "f") return value.toFixed(figures);
  if (type === "e") return value.toExponential(figures);
  if (type === "g") return String(+value.toPrecision(figures || 1));
  let text = String(value);
  if (single) for (let digits = 1; digits < 10 && Math.fround((text = String(+value.toPrecision(digits)))) !== value; ) digits++;
  return text;
}

/** What a module imports: what every one does, and more. */
export function importsOf(memory, more) {
  const env = {
    ...more,
    emscripten_notify_memory_growth() {},
    tukorNumberFromText: (at, size) => Number(memory.text(at, size)),
    tukorTextFromNumber: (value, single, precision, type, out) => memory.put(out, digitsOf(value, single, precision, String.fromCharCode(type))),
  };
  const wasi_snapshot_preview1 = {
    ...more,
    proc_exit() {
      throw new Error("the library gave up");
    },
  };
  return { env, math: Math, wasi_snapshot_preview1 };
}

/** An instance of a module; its functions begin with `prefix`. */
export class Library {
  memory = new Memory();
  crew = null;

  /** `more` are imports beside those that every module has, made with the instance's memory. */
  static async create(module, prefix, more = () => ({})) {
    const library = new this();
    const { memory } = library;
    const crew = (library.crew = threaded ? new (await import("./tukor-threads.js")).Crew(module, library) : null);
    const instance = await WebAssembly.instantiate(module, importsOf(memory, { ...crew?.imports, ...more(memory) }));
    const wasm = (library.wasm = instance.exports);
    library.prefix = prefix;
    memory.of = crew?.memory ?? wasm.memory;
    (wasm._initialize ?? wasm.__wasm_call_ctors)();
    return library;
  }

  /** To be awaited before work on so many bytes: where there may be threads, they do their part of it. */
  gather(bytes) {
    return this.crew?.gather(bytes);
  }

  /** Calls an exported function with numbers, texts and arrays; a negative result is an error whose text the library holds. */
  call(name, ...args) {
    const { wasm, memory } = this;
    const owned = [];
    const values = args.map((arg) => {
      if (typeof arg === "string") arg = new TextEncoder().encode(arg + "\0");
      if (!ArrayBuffer.isView(arg)) return arg;
      const at = wasm.malloc(Math.max(arg.byteLength, 1));
      if (!at) throw new Error("out of memory");
      memory.bytes.set(new Uint8Array(arg.buffer, arg.byteOffset, arg.byteLength), at);
      owned.push(at);
      return at;
    });
    try {
      const result = wasm[`${this.prefix}_${name}`](...values);
      if (result < 0) throw new Error(this.text("error"));
      return result;
    } finally {
      for (const at of owned) wasm.free(at);
    }
  }

  /** The string that an exported function returns. */
  text(name, ...args) {
    return this.memory.text(this.wasm[`${this.prefix}_${name}`](...args));
  }

  json(name, ...args) {
    return JSON.parse(this.text(name, ...args));
  }
}

/** The compiled module of that name. */
export async function compiled(name) {
  const url = new URL(name, import.meta.url);
  try {
    return await WebAssembly.compileStreaming(fetch(url));
  } catch (error) {
    if (!(error instanceof TypeError)) throw error;
    const response = await fetch(url); // from servers that send another type than application/wasm
    if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
    return WebAssembly.compile(await response.arrayBuffer());
  }
}

/** Of each of the library's modules there are two builds. */
export const buildOf = (name, threads) => `${name}${threads ? "-threads" : ""}.wasm`;

/** A function that gives the one instance of a module, fetched when it is first called; after a failure it is tried anew. */
export function lazily(name, prefix) {
  let library = null;
  return () => {
    library ??= compiled(buildOf(name, threaded)).then((module) => Library.create(module, prefix)).catch((error) => {
      library = null;
      throw error;
    });
    return library;
  };
}
