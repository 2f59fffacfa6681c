// From an element to the side that computes for it: a worker that draws into the element's canvas, or the page itself where workers cannot.

import { buildOf, compiled } from "./library.js";

const modules = {};

/** The library, fetched and compiled once a page. */
function library(threads) {
  const name = buildOf("tukor", threads);
  modules[name] ??= compiled(name).catch((error) => {
    delete modules[name];
    throw error;
  });
  return modules[name];
}

/** A worker that has said that it can draw; null where it cannot, or may not be started (another origin, a policy). */
function capableWorker() {
  if (!HTMLCanvasElement.prototype.transferControlToOffscreen) return null;
  return new Promise((resolve) => {
    const worker = new Worker(new URL("./tukor-worker.js", import.meta.url), { type: "module", name: "tukor-view" });
    const give = (can) => {
      worker.onmessage = worker.onerror = null;
      if (!can) worker.terminate();
      resolve(can ? worker : null);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      give(false);
    };
    worker.onmessage = ({ data }) => give(data.webgl2);
  }).catch(() => null);
}

export class Link {
  #port;
  #end;
  #waiting = new Map();
  #next = 0;

  /** `told` hears of "lost" and "restored" contexts. Rejects with a sentence for people when WebGL 2 is missing. */
  static async open(canvas, told) {
    const [module, worker] = await Promise.all([library(crossOriginIsolated), capableWorker()]);
    const link = new Link();
    if (worker) {
      link.#port = worker;
      link.#end = () => worker.terminate();
      link.#listen(told);
      const drawn = canvas.transferControlToOffscreen();
      await link.ask("start", { canvas: drawn, module }, [drawn]);
    } else {
      const { serve } = await import("./tukor-worker.js");
      const { port1, port2 } = new MessageChannel();
      const host = serve(port1);
      link.#port = port2;
      link.#end = () => {
        host.stop();
        port1.close();
      };
      link.#listen(told);
      host.canvas = canvas; // cannot be sent
      await link.ask("start", { module: await library() });
    }
    return link;
  }

  #listen(told) {
    this.#port.onmessage = ({ data }) => {
      if (data.event) return told(data.event);
      const { resolve, reject } = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if ("error" in data) reject(Object.assign(new Error(data.error), { lost: data.lost }));
      else resolve(data.value);
    };
  }

  /** Asks for one of the acts of worker.js; they are carried out one after the other. Never settles once the link is closed. */
  ask(act, values = {}, transfer = []) {
    const id = ++this.#next;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#port.postMessage({ id, act, values }, transfer);
    });
  }

  close() {
    this.#end();
    this.#waiting.clear();
  }
}
