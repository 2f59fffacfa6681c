// Modules that only some pages fetch.
import { Library, threaded } from "./library.js";

/** The compiled module of that name beside `base`. */
export async function compiled(name, base) {
  const url = new URL(name, base);
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
export function lazily(name, base, prefix) {
  let library = null;
  return () => {
    library ??= compiled(buildOf(name, threaded), base).then((module) => Library.create(module, prefix)).catch((error) => {
      library = null;
      throw error;
    });
    return library;
  };
}
