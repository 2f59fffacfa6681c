// The side that computes: one element's library and WebGL context, answering the messages of link.js one after the other.
import { Engine } from "./engine.js";
import { readEnvironment } from "./environment-file.js";
import { animationsOf, gltfContents, imagesOf, isCompressed } from "./gltf-json.js";

/** By what the file begins with, or else its name; everything else is for the second module to tell. */
function isGltf(name, bytes) {
  const start = String.fromCharCode(...bytes.subarray(0, 4));
  return start === "glTF" || /\.(gltf|glb)$/i.test(name);
}

class Host {
  canvas = null;
  #port;
  #engine = null;
  #module = null;
  #skyWarnings = [];
  #model = null; // what an animated one is read from at every moment
  #set = {}; // what was set last
  #tail = Promise.resolve();
  #losses = 0; // of the context, so far
  #pending = Promise.resolve(); // until the frame before is drawn

  constructor(port) {
    this.#port = port;
    port.onmessage = ({ data: { id, act, values } }) => {
      this.#tail = this.#tail.then(async () => {
        const losses = this.#losses;
        try {
          const value = await this[act](values);
          const transfer = value?.buffer instanceof ArrayBuffer ? [value.buffer] : [];
          port.postMessage({ id, value }, transfer);
        } catch (error) {
          const lost = await this.#lostSince(losses);
          port.postMessage({ id, error: lost ? "the WebGL context is lost" : error.message, lost });
        }
      });
    };
  }

  /** Whether an error may come from a lost context. Browsers let calls fail a little before they say that it is lost. */
  async #lostSince(losses) {
    const lost = () => this.#losses !== losses || (this.#engine?.gl.isContextLost() ?? false);
    for (let i = 0; i < 10 && !lost(); i++) await new Promise((resolve) => setTimeout(resolve, 20));
    return lost();
  }

  async start({ canvas, module }) {
    this.canvas ??= canvas;
    this.#module ??= module;
    const first = !this.#engine;
    this.#engine = await Engine.open(this.canvas, this.#module);
    if (!first) return;
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault(); // or it will not come back
      this.#losses++;
      this.#port.postMessage({ event: "lost" });
    });
    this.canvas.addEventListener("webglcontextrestored", () => this.#port.postMessage({ event: "restored" }));
  }

  /** A built-in shape where there are no bytes; `files` are what a .gltf names. */
  async model({ name, bytes, files = [], aspect, ...look }) {
    const engine = this.#engine;
    let animations = [];
    if (bytes && isGltf(name, bytes)) {
      const contents = gltfContents(bytes);
      const plain = isCompressed(contents) ? await (await import("./tukor-unpack.js")).unpack(name, contents, files) : { bytes, files };
      const images = [];
      if (imagesOf(contents).length > 0)
        await (await import("./tukor-images.js")).decodeImages(engine.gl, contents, files, (...image) => images.push(image));
      this.#model = { name, ...plain, images, ...look };
      await engine.gather(bytes.length);
      this.#read("set");
      animations = animationsOf(contents);
    } else {
      const scene = await (await import("./tukor-extras.js")).model({ name, bytes, files });
      await engine.gather(scene.length);
      engine.call("set_scene", scene, scene.length);
    }
    if (animations.length === 0) this.#model = null;
    return { framing: engine.json("framing", aspect), parts: engine.json("parts"), animations };
  }

  /** The model at its moment: `set` it, or `pose` what is there already. True when that cannot be posed. */
  #read(how) {
    const engine = this.#engine;
    const { name, bytes, files, images, variant, animation, seconds } = this.#model;
    engine.call("clear_files");
    for (const [path, content] of files) engine.call("add_file", path, content, content.length);
    if (how === "set") for (const image of images) engine.call("add_image", ...image);
    return engine.call(`${how}_model`, name, bytes, bytes.length, variant, animation, seconds) !== 0;
  }

  /** Another moment of an animated model. */
  #pose(seconds) {
    if (!this.#model || this.#model.seconds === seconds) return;
    this.#model.seconds = seconds;
    if (!this.#read("pose")) return;
    this.#read("set");
    for (const what of ["materials", "suns"]) if (this.#set[what]) this.#engine.call(`set_${what}`, ...this.#set[what]);
  }

  /** A built-in one where there are no bytes. */
  async environment({ name, bytes }) {
    const engine = this.#engine;
    const image = bytes && (await readEnvironment(name, bytes));
    this.#skyWarnings = [];
    if (image && !image.texture) {
      await engine.gather(bytes.length);
      const other =
        image.radiance ? engine.call("set_environment_radiance", name, image.radiance, image.width, image.height)
        : image.srgb ? engine.call("set_environment_srgb", name, image.srgb, image.width, image.height)
        : engine.call("set_environment", name, image.bytes, image.bytes.length);
      if (!other) return;
    }
    const { texels, faceSize, warnings } = await (await import("./tukor-extras.js")).environment(name, image);
    engine.call("set_environment_cube", texels, faceSize);
    this.#skyWarnings = warnings;
  }

  warnings() { return [...this.#engine.json("warnings"), ...this.#skyWarnings]; }

  /** One of the library's settings. */
  set({ what, values }) {
    this.#engine.call(`set_${what}`, ...values);
    this.#set[what] = values;
  }

  /** Light and shaders of surfaces that are not ideally smooth, where the model has some. */
  async #light() {
    const engine = this.#engine;
    const wanted = engine.json("light_wanted");
    if (!wanted) return;
    const { shaders, light, tables } = await (await import("./tukor-finish.js")).prepare(engine.memory.floats.subarray(wanted.at / 4), wanted);
    engine.call("give_shaders", ...shaders);
    engine.call("give_light", light.chain, light.chain.length, light.table, light.table.length, ...tables.flatMap((table) => [table, table.length]));
  }

  #place({ eye, target, fov }) {
    this.#engine.call("set_camera", ...eye, ...target, fov);
  }

  /** One more frame in the canvas, coarse enough to be quick while `moving`; the samples in it. */
  async frame({ view, width, height, moving, seconds }) {
    await this.#pending; // one frame is drawn while the next is thought of, no more
    const { canvas } = this;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    this.#pose(seconds);
    await this.#light();
    this.#place(view);
    const begun = performance.now();
    const samples = this.#engine.call(moving ? "moving_frame" : "frame", width, height);
    this.#pending = this.#drawn().then(() => moving && this.#engine.wasm.tukor_took((performance.now() - begun) / 1000));
    return samples;
  }

  /** Many samples of another picture, which is not shown: straight-alpha 8-bit sRGB. */
  async still({ view, width, height, samples, seconds }) {
    const engine = this.#engine;
    this.#pose(seconds);
    await this.#light();
    this.#place(view);
    engine.call("restart");
    while (engine.call("still_sample", width, height, samples) < samples) await this.#drawn();
    const at = engine.call("still_pixels");
    engine.call("restart");
    return engine.memory.bytes.slice(at, at + 4 * width * height);
  }

  /** 1 + the index of the part under a place, 0 for none. */
  pick({ view, x, y, aspect }) {
    this.#place(view);
    return this.#engine.call("pick", x, y, aspect);
  }

  /** Resolves when the GPU has done what it was told: frames must not pile up behind a slow one. */
  async #drawn() {
    const { gl } = this.#engine;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED)
      await new Promise((resolve) => setTimeout(resolve));
    gl.deleteSync(fence);
  }

  stop() {
    this.#engine?.destroy();
  }
}

/** Answers on a port; the page itself calls this where there is no worker. */
export function serve(port) {
  return new Host(port);
}

if (typeof DedicatedWorkerGlobalScope !== "undefined" && self instanceof DedicatedWorkerGlobalScope) {
  const probe = typeof OffscreenCanvas === "undefined" ? null : new OffscreenCanvas(1, 1).getContext("webgl2");
  probe?.getExtension("WEBGL_lose_context")?.loseContext(); // browsers keep only so many
  serve(self);
  self.postMessage({ webgl2: probe !== null });
}
