// Threads of the library where the page is cross-origin isolated: workers that share its memory, there while there is much to do.
// This file is what they run, too.
import { Memory, importsOf } from "./library.js";

const NAME = "tukor-thread";
const MOST = 4; // with the one that asks: a page may have many elements
const MUCH = 5e5; // bytes: of less, all would be done before they begin
const IDLE = 3000; // ms after which they go

/** Makes it as large, which another thread may have done meanwhile. */
function grow(memory, size) {
  const missing = size - memory.buffer.byteLength;
  if (missing <= 0) return true;
  try {
    memory.grow(Math.ceil(Math.max(missing, 0.2 * memory.buffer.byteLength) / 65536));
  } catch {
    return memory.buffer.byteLength >= size;
  }
  return true;
}

/** What every thread's instance imports, and in place of all else what refuses: WebGL belongs to the one that has the context. */
function threadImports(module, memory) {
  const refuse = ({ name }) => [name, () => { throw new Error(`${name} in another thread`); }];
  return {
    ...Object.fromEntries(WebAssembly.Module.imports(module).map(refuse)),
    memory,
    emscripten_resize_heap: (size) => grow(memory, size),
    emscripten_get_now: () => performance.now(),
    _emscripten_default_pthread_stack_size: () => 1 << 20,
    emscripten_check_blocking_allowed() {},
    __emscripten_thread_cleanup() {},
  };
}

function begin(wasm, thread) {
  wasm._emscripten_thread_init(thread, 0, 0, 1); // no browser's main thread, may wait
  wasm.emscripten_tls_init();
}

/** The threads of one library, which imports `imports`. */
export class Crew {
  memory = new WebAssembly.Memory({ initial: 512, maximum: 32768, shared: true }); // as apps/web/CMakeLists.txt links it
  #library;
  #starting = [];
  #leaving = 0;

  constructor(module, library) {
    this.#library = library;
    this.imports = {
      ...threadImports(module, this.memory),
      __emscripten_init_main_thread_js: (thread) => begin(library.wasm, thread),
      __pthread_create_js: (thread, _, entry, argument) => this.#start(module, thread, entry, argument),
    };
  }

  /** Resolves when all are there. A worker's workers begin only while it waits for nobody: never in the middle of a loop. */
  async gather(bytes = Infinity) {
    if (bytes < MUCH) return;
    const { wasm } = this.#library;
    clearTimeout(this.#leaving);
    wasm.threads_count(Math.min(navigator.hardwareConcurrency, MOST));
    await Promise.all(this.#starting.splice(0));
    this.#leaving = setTimeout(() => wasm.threads_count(1), IDLE);
  }

  #start(module, thread, entry, argument) {
    const { wasm } = this.#library;
    const worker = new Worker(import.meta.url, { type: "module", name: NAME });
    this.#starting.push(new Promise((resolve) => {
      worker.onerror = resolve; // it never begins, and no loop waits for it
      worker.onmessage = ({ data: pieces }) => {
        resolve();
        if (pieces === null) return; // it begins
        worker.terminate();
        wasm._emscripten_thread_free_data(thread);
        performance.mark(NAME, { detail: pieces });
      };
    }));
    worker.postMessage({ module, memory: this.memory, thread, stack: wasm.threads_stack(thread), entry, argument });
    return 0;
  }
}

async function run({ module, memory, thread, stack, entry, argument }) {
  const imports = importsOf(Object.assign(new Memory(), { of: memory }), threadImports(module, memory));
  const { exports: wasm } = await WebAssembly.instantiate(module, imports);
  wasm.stackRestore(stack);
  begin(wasm, thread);
  postMessage(null);
  wasm.__indirect_function_table.get(entry)(argument);
  const pieces = wasm.threads_pieces();
  wasm._emscripten_thread_exit(0);
  postMessage(pieces);
}

if (self.name === NAME) onmessage = ({ data }) => run(data);
