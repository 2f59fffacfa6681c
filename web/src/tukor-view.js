// <tukor-view>: the custom element. Attributes in, pictures and events out; the light is computed by engine.js.
import { Engine } from "./engine.js";
import { OrbitCamera } from "./orbit-camera.js";
import { listen, spokenView } from "./controls.js";
import { angle, number, orbit, point } from "./units.js";
import { readEnvironment } from "./environment-file.js";

const REST_SAMPLES = 256; // frames accumulated at rest; the picture no longer changes visibly after that
const AUTO_ROTATE = Math.PI / 16; // rad/s
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

const style = `
:host { display: block; position: relative; width: 300px; height: 150px; contain: strict; }
:host([hidden]) { display: none; }
canvas { width: 100%; height: 100%; display: block; outline: none; touch-action: none; }
:host(:not([camera-controls])) canvas { touch-action: auto; }
canvas:focus-visible { outline: 3px solid #2f7cf6; outline-offset: -3px; }
.poster { position: absolute; inset: 0; background: center / contain no-repeat; pointer-events: none; }
.poster[hidden], .bar[hidden], .message[hidden] { display: none; }
.bar { position: absolute; left: 0; bottom: 0; width: 100%; height: 4px; appearance: none; border: 0; background: #0003; }
.bar::-webkit-progress-bar { background: transparent; }
.bar::-webkit-progress-value { background: #2f7cf6; }
.message { position: absolute; inset: auto 0 0 0; margin: 0; padding: 0.6em 1em; font: 14px/1.4 system-ui, sans-serif; color: #fff; background: #8b1a1a; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`;
let sheet;

/** Attributes with a word for a value, which the library reads, and the word when there is none. */
const CHOICES = { background: "quad", fidelity: "exact", fresnel: "exact", "tone-map": "neutral" };
/** Attributes with a figure: how it is read, in the library's unit, and the figure when there is none. */
const FIGURES = {
  "environment-rotation": [angle, 0],
  "environment-intensity": [(text) => (number(text) >= 0 ? number(text) : null), 1],
  exposure: [number, 0],
};
const CAMERA = ["camera-orbit", "camera-target", "field-of-view"];
const OTHERS = ["src", "environment", "material", "alt", "poster", "loading", "reveal", "auto-rotate", "camera-controls"];

/** A word as a POSIX shell takes it. */
function shellQuoted(word) {
  return /^[\w.,:/=*?-]+$/.test(word) && !/[*?]/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

export class TukorView extends HTMLElement {
  static observedAttributes = [...Object.keys(CHOICES), ...Object.keys(FIGURES), ...CAMERA, ...OTHERS];

  #root = this.attachShadow({ mode: "open" });
  #canvas;
  #poster;
  #bar;
  #message;
  #spoken;
  #engine = null;
  #starting = null;
  #camera = new OrbitCamera();
  #stop = null; // AbortController of everything that listens while connected
  #serial = { src: 0, environment: 0 }; // the newest request wins
  #visible = false;
  #frame = 0;
  #last = 0;
  #samples = 0;
  #movedAt = -Infinity;
  #loaded = false;
  #dismissed = false;
  #ready = { src: false, environment: false };
  #names = { src: "", environment: "studio" }; // of what is shown

  constructor() {
    super();
    if (!sheet) {
      sheet = new CSSStyleSheet(); // constructed sheets need no 'unsafe-inline' in style-src
      sheet.replaceSync(style);
    }
    this.#root.adoptedStyleSheets = [sheet];
    const make = (tag, properties) => Object.assign(document.createElement(tag), properties);
    this.#canvas = make("canvas", {});
    this.#poster = make("div", { className: "poster" });
    this.#bar = make("progress", { className: "bar", max: 1, value: 0, hidden: true, ariaLabel: "Loading" });
    this.#message = make("p", { className: "message", hidden: true, role: "alert" });
    this.#spoken = make("div", { className: "spoken", role: "status" });
    this.#root.append(this.#canvas, this.#poster, make("slot", { name: "poster" }), this.#bar, this.#message, this.#spoken);
    this.#canvas.setAttribute("role", "img");
    for (const property of Object.keys(PROPERTIES)) { // values set before the element was defined
      if (Object.hasOwn(this, property)) {
        const value = this[property];
        delete this[property];
        this[property] = value;
      }
    }
  }

  connectedCallback() {
    const stop = (this.#stop = new AbortController());
    new Observer(IntersectionObserver, (entries) => {
      this.#visible = entries.at(-1).isIntersecting;
      if (this.#visible) this.#start();
      this.#wake();
    }, this, stop.signal);
    new Observer(ResizeObserver, () => this.#changed(), this, stop.signal);
    this.#canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault(); // or it will not come back
      this.#engine = this.#starting = null;
      this.#loaded = false;
      this.#ready = { src: false, environment: false };
    }, { signal: stop.signal });
    this.#canvas.addEventListener("webglcontextrestored", () => this.#start(true), { signal: stop.signal });
    document.addEventListener("visibilitychange", () => this.#wake(), { signal: stop.signal });
    this.#controls();
    if (this.getAttribute("loading") === "eager") this.#start();
  }

  disconnectedCallback() {
    this.#stop.abort();
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    const canvas = this.#canvas.cloneNode(); // a context cannot be taken off its canvas
    this.#engine?.destroy();
    this.#engine = this.#starting = null;
    this.#loaded = this.#visible = false;
    this.#ready = { src: false, environment: false };
    this.#canvas.replaceWith(canvas);
    this.#canvas = canvas;
  }

  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === "alt") this.#describe();
    if (name === "poster") this.#poster.style.backgroundImage = now ? `url(${JSON.stringify(now)})` : "";
    if (name === "camera-controls" && this.isConnected) this.#controls();
    if (name === "auto-rotate") this.#wake();
    if (!this.#engine) return;
    if (name === "src") this.#loadModel();
    else if (name === "environment") this.#loadEnvironment();
    else if (name === "material") this.#guard(() => this.#materials());
    else if (name in CHOICES || name in FIGURES) this.#guard(() => this.#option(name));
    else if (CAMERA.includes(name)) this.#guard(() => this.#cameraAttribute(name));
    this.#changed();
  }

  // ---- the public methods ----

  /** True once model and environment are there and a frame of them has been drawn. */
  get loaded() { return this.#loaded; }

  /** Frames accumulated in the picture at rest. */
  get accumulatedSamples() { return this.#samples; }

  /** Parts of the model: [{name, material}], in drawing order. */
  get parts() { return this.#engine ? this.#engine.json("tukor_parts") : []; }

  /** The `tukor render` command that gives the present view; files are named as the page names them. */
  get command() {
    if (!this.#engine) return "";
    const { eye, target, fov } = this.#camera.view();
    const figures = (values) => values.map((value) => +value.toFixed(5)).join(",");
    const words = ["tukor", "render", this.#names.src];
    for (const one of (this.getAttribute("material") ?? "").split(";")) if (one.trim()) words.push("--material", one.trim());
    words.push("--environment", this.#names.environment);
    for (const name of Object.keys(CHOICES))
      if (this.hasAttribute(name)) words.push(name === "tone-map" ? "--tonemap" : `--${name}`, this.getAttribute(name).trim());
    for (const name of Object.keys(FIGURES))
      if (this.hasAttribute(name)) words.push(`--${name}`, figures([this.#figure(name) * (name === "environment-rotation" ? 180 / Math.PI : 1)]));
    words.push("--eye", figures(eye), "--target", figures(target), "--fov", figures([(fov * 180) / Math.PI]));
    words.push("--size", `${this.#canvas.width}x${this.#canvas.height}`, "-o", "view.png");
    return words.map(shellQuoted).join(" ");
  }

  /** Ends the easing of the camera: the view is its goal from the next frame on. */
  jumpCameraToGoal() {
    this.#camera.jump();
    this.#changed();
  }

  getCameraOrbit() {
    const { theta, phi, radius } = this.#camera.now;
    return { theta, phi, radius, toString: () => `${theta}rad ${phi}rad ${radius}m` };
  }

  getCameraTarget() {
    const [x, y, z] = this.#camera.now.target;
    return { x, y, z, toString: () => `${x}m ${y}m ${z}m` };
  }

  /** Shows the model when `reveal` is manual, or hides the poster early. */
  dismissPoster() {
    this.#dismissed = true;
    this.#start();
    this.#poster.hidden = true;
  }

  /** Name of the part under a point of the page (client coordinates), or null. */
  partAtPoint(clientX, clientY) {
    if (!this.#engine) return null;
    const box = this.#canvas.getBoundingClientRect();
    this.#placeCamera();
    const index = this.#engine.call("tukor_pick", (clientX - box.left) / box.width, (clientY - box.top) / box.height, box.width / box.height);
    return index === 0 ? null : this.parts[index - 1].name;
  }

  /** Renders the present view at any size: `samples` accumulated frames, as pixels of straight-alpha 8-bit sRGB. */
  async render({ width = this.#canvas.width, height = this.#canvas.height, samples = 64 } = {}) {
    if (!(width >= 1 && height >= 1 && width <= 16384 && height <= 16384))
      throw new RangeError(`size ${width} x ${height}: expected 1 to 16384 pixels a side`);
    await this.#whenLoaded();
    this.#placeCamera();
    const engine = this.#engine;
    engine.call("tukor_restart");
    try {
      for (let done = 0; done < samples; ) {
        const begun = performance.now();
        while (done < samples && performance.now() - begun < 30) {
          engine.call("tukor_still_sample", width, height);
          engine.gl.finish();
          done++;
        }
        await new Promise((resolve) => setTimeout(resolve));
      }
      const at = engine.call("tukor_still_pixels");
      return new ImageData(new Uint8ClampedArray(engine.wasm.HEAPU8.slice(at, at + 4 * width * height).buffer), width, height);
    } finally {
      this.#changed();
    }
  }

  async toBlob({ mimeType = "image/png", qualityArgument, ...size } = {}) {
    const canvas = await this.#still(size);
    return canvas.convertToBlob({ type: mimeType, quality: qualityArgument });
  }

  /** A data URL of the present view. Unlike a canvas's own, it is a promise: the picture is rendered anew, to the end. */
  async toDataURL(mimeType = "image/png", qualityArgument = undefined) {
    const blob = await this.toBlob({ mimeType, qualityArgument });
    return new Promise((resolve, reject) => {
      const reader = new FileReader();
      reader.onload = () => resolve(reader.result);
      reader.onerror = () => reject(reader.error);
      reader.readAsDataURL(blob);
    });
  }

  /** Loads a dropped or chosen model file; nothing leaves the page. */
  async loadModelFile(file) {
    await this.#start();
    await this.#loadModel(file);
  }

  async loadEnvironmentFile(file) {
    await this.#start();
    await this.#loadEnvironment(file);
  }

  // ---- starting and loading ----

  #start(again = false) {
    const waits = this.getAttribute("reveal") === "manual" && this.getAttribute("loading") !== "eager" && !this.#dismissed;
    if (waits && !again) return this.#starting;
    this.#starting ??= this.#begin().catch((error) => { this.#fail(error); });
    return this.#starting;
  }

  async #begin() {
    this.#progress(0);
    const canvas = this.#canvas;
    const engine = await Engine.create(canvas);
    if (canvas !== this.#canvas || !this.isConnected) { // removed meanwhile
      engine.destroy();
      return;
    }
    this.#engine = engine;
    for (const name of [...Object.keys(CHOICES), ...Object.keys(FIGURES)]) if (this.hasAttribute(name)) this.#guard(() => this.#option(name));
    this.#progress(0.2);
    await Promise.all([this.#loadModel(), this.#loadEnvironment()]);
  }

  async #bytes(url, name) {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
    return new Uint8Array(await response.arrayBuffer());
  }

  async #loadModel(file = null) {
    const serial = ++this.#serial.src;
    const src = file ? file.name : this.getAttribute("src");
    if (!src) return;
    const name = file ? file.name : src.split(/[?#]/)[0].split("/").at(-1);
    try {
      const builtIn = !file && /^[a-z-]+$/.test(src);
      const bytes = builtIn ? new Uint8Array() : file ? new Uint8Array(await file.arrayBuffer()) : await this.#bytes(new URL(src, document.baseURI), name);
      if (!builtIn && bytes.length === 0) throw new Error(`${name}: an empty file`);
      if (serial !== this.#serial.src || !this.#engine) return;
      const files = builtIn ? [] : await this.#neighbours(bytes, name, file ? null : new URL(src, document.baseURI));
      if (serial !== this.#serial.src || !this.#engine) return;
      const engine = this.#engine;
      engine.call("tukor_clear_files");
      for (const [path, content] of files) engine.call("tukor_add_file", path, content, content.length);
      engine.call("tukor_set_model", name, bytes, bytes.length);
      this.#camera.frame(engine.json("tukor_framing", this.#canvas.clientWidth / this.#canvas.clientHeight || 1));
      this.#materials();
      for (const attribute of CAMERA) this.#cameraAttribute(attribute);
      this.#camera.jump();
      this.#names.src = src;
      this.#arrived("src");
    } catch (error) {
      this.#fail(error, name);
    }
  }

  /** The buffers that a .gltf names: fetched from its own folder or below, nowhere else. */
  async #neighbours(bytes, name, url) {
    if (!/\.gltf$/i.test(name) || !url) return [];
    const json = JSON.parse(new TextDecoder().decode(bytes));
    const uris = (json.buffers ?? []).map((buffer) => buffer.uri).filter((uri) => uri && !uri.startsWith("data:"));
    const folder = new URL(".", url).href;
    return Promise.all(uris.map(async (uri) => {
      const target = new URL(uri, url);
      if (!target.href.startsWith(folder)) throw new Error(`${name}: names ${uri}, which is outside its own folder`);
      return [decodeURIComponent(uri), await this.#bytes(target, uri)];
    }));
  }

  async #loadEnvironment(file = null) {
    const serial = ++this.#serial.environment;
    const source = file ? file.name : this.getAttribute("environment") ?? "studio";
    const name = file ? file.name : source.split(/[?#]/)[0].split("/").at(-1);
    try {
      const builtIn = !file && /^[a-z]+$/.test(source);
      const bytes = builtIn ? new Uint8Array() : file ? new Uint8Array(await file.arrayBuffer()) : await this.#bytes(new URL(source, document.baseURI), name);
      if (!builtIn && bytes.length === 0) throw new Error(`${name}: an empty file`);
      const image = builtIn ? null : await readEnvironment(name, bytes);
      if (serial !== this.#serial.environment || !this.#engine) return;
      if (builtIn) this.#engine.call("tukor_set_environment", name, bytes, 0);
      else if (image.radiance) this.#engine.call("tukor_set_environment_radiance", name, image.radiance, image.width, image.height);
      else if (image.srgb) this.#engine.call("tukor_set_environment_srgb", name, image.srgb, image.width, image.height);
      else this.#engine.call("tukor_set_environment", name, image.bytes, image.bytes.length);
      this.#names.environment = source;
      this.#arrived("environment");
    } catch (error) {
      this.#fail(error, name);
    }
  }

  #arrived(which) {
    this.#ready[which] = true;
    if (which === "src") this.#loaded = false; // the next frame says `load` again
    this.#message.hidden = true;
    this.#progress(0.4 + 0.3 * (this.#ready.src + this.#ready.environment));
    this.#changed();
  }

  #whenLoaded() {
    this.#start();
    if (this.#loaded) return Promise.resolve();
    return new Promise((resolve, reject) => {
      this.addEventListener("load", resolve, { once: true });
      this.addEventListener("error", (event) => reject(new Error(event.detail?.message ?? "not loaded")), { once: true });
    });
  }

  // ---- attributes ----

  #materials() {
    this.#engine.call("tukor_set_materials", this.getAttribute("material") ?? "");
  }

  #option(name) {
    if (name in CHOICES) this.#engine.call("tukor_set_option", name, (this.getAttribute(name) ?? CHOICES[name]).trim());
    else if (name === "exposure") this.#engine.call("tukor_set_exposure", this.#figure(name));
    else this.#engine.call("tukor_set_light", this.#figure("environment-rotation"), this.#figure("environment-intensity"));
  }

  #figure(name) {
    const [read, standard] = FIGURES[name];
    const text = this.getAttribute(name);
    const value = text === null ? standard : read(text);
    if (value === null) throw new Error(`${name}="${text}": not understood`);
    return value;
  }

  #cameraAttribute(name) {
    const framing = this.#camera.framing;
    const text = this.getAttribute(name);
    if (name === "camera-orbit") {
      const value = orbit(text ?? "auto auto auto", framing);
      if (!value) throw new Error(`camera-orbit="${text}": expected three values such as "30deg 75deg 4m" or "auto 75deg 120%"`);
      this.#camera.set(value);
    } else if (name === "camera-target") {
      const value = point(text ?? "auto", framing);
      if (!value) throw new Error(`camera-target="${text}": expected auto or three lengths such as "0m 1m 0m"`);
      this.#camera.set({ target: value });
    } else {
      const value = text === null || text === "auto" ? (40 * Math.PI) / 180 : angle(text);
      if (!(value > 0 && value < Math.PI)) throw new Error(`field-of-view="${text}": expected an angle between 0deg and 180deg`);
      this.#camera.set({ fov: value });
    }
  }

  #controls() {
    this.#controlled?.abort();
    this.#controlled = new AbortController();
    const interactive = this.hasAttribute("camera-controls");
    this.#canvas.tabIndex = interactive ? 0 : -1;
    if (!interactive) this.#canvas.removeAttribute("tabindex");
    this.#canvas.setAttribute("role", interactive ? "application" : "img");
    this.#describe();
    if (interactive)
      listen(this.#canvas, this.#camera, () => this.#steered(), AbortSignal.any([this.#controlled.signal, this.#stop.signal]));
  }
  #controlled = null;

  #describe() {
    const alt = this.getAttribute("alt") ?? "";
    const name = alt || "3D model";
    this.#canvas.setAttribute("aria-label",
      this.hasAttribute("camera-controls") ? `${name}. Arrow keys turn it, page up and page down zoom, shift with arrow keys moves it.` : name);
  }

  #steered() {
    this.#movedAt = performance.now();
    this.#changed();
    clearTimeout(this.#speaking);
    this.#speaking = setTimeout(() => {
      const words = spokenView(this.#camera.goal.theta, this.#camera.goal.phi);
      if (words !== this.#spoken.textContent) this.#spoken.textContent = words;
    }, 300);
  }
  #speaking = 0;

  // ---- drawing ----

  #changed() {
    this.#samples = 0;
    if (this.#engine) this.#engine.call("tukor_restart");
    this.#wake();
  }

  #wake() {
    if (this.#frame || !this.#engine || !this.#visible || document.hidden) return;
    if (!this.#ready.src || !this.#ready.environment) return;
    this.#last = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#draw(now));
  }

  #placeCamera() {
    const { eye, target, fov } = this.#camera.view();
    this.#engine.call("tukor_set_camera", ...eye, ...target, fov);
  }

  #draw(now) {
    this.#frame = 0;
    if (!this.#engine || !this.#visible || document.hidden) return;
    const seconds = Math.min((now - this.#last) / 1000, 0.1);
    this.#last = now;
    const turning = this.hasAttribute("auto-rotate") && !reducedMotion.matches && now - this.#movedAt > 3000;
    if (turning) this.#camera.rotate(AUTO_ROTATE * seconds, 0);
    if (reducedMotion.matches) this.#camera.jump();
    const moving = this.#camera.step(seconds) || turning;
    if (moving) {
      this.#samples = 0;
      this.#engine.call("tukor_restart");
    }
    const canvas = this.#canvas;
    const scale = devicePixelRatio;
    const width = Math.max(1, Math.round(canvas.clientWidth * scale));
    const height = Math.max(1, Math.round(canvas.clientHeight * scale));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    try {
      this.#placeCamera();
      this.#samples = this.#engine.call("tukor_frame", width, height);
    } catch (error) {
      if (this.#engine?.gl.isContextLost()) return;
      this.#fail(error);
      return;
    }
    if (!this.#loaded) {
      this.#loaded = true;
      this.#poster.hidden = true;
      this.#progress(1);
      this.dispatchEvent(new CustomEvent("load", { detail: { url: this.getAttribute("src") } }));
    }
    if (moving) this.dispatchEvent(new CustomEvent("camera-change", { detail: { source: this.#movedAt > -Infinity ? "user-interaction" : "none" } }));
    this.dispatchEvent(new CustomEvent("frame", { detail: { samples: this.#samples, moving } }));
    if (moving || this.#samples < REST_SAMPLES || (this.hasAttribute("auto-rotate") && !reducedMotion.matches))
      this.#frame = requestAnimationFrame((next) => this.#draw(next));
  }

  async #still(size) {
    const image = await this.render(size);
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext("2d").putImageData(image, 0, 0);
    return canvas;
  }

  // ---- telling ----

  #progress(fraction) {
    this.#bar.value = fraction;
    this.#bar.hidden = fraction >= 1;
    this.dispatchEvent(new CustomEvent("progress", { detail: { totalProgress: fraction } }));
  }

  #guard(action) {
    try {
      action();
      this.#message.hidden = true;
    } catch (error) {
      this.#fail(error);
    }
  }

  #fail(error, name = "") {
    const text = error instanceof SyntaxError && name ? `${name}: not valid JSON` : error.message;
    this.#message.textContent = text;
    this.#message.hidden = false;
    this.#bar.hidden = true;
    this.dispatchEvent(new CustomEvent("error", { detail: { message: text, sourceError: error } }));
  }
}

/** An observer of one element that ends with a signal. */
class Observer {
  constructor(Kind, callback, element, signal) {
    const observer = new Kind(callback);
    observer.observe(element);
    signal.addEventListener("abort", () => observer.disconnect());
  }
}

/** Every attribute is a property too, in camel case. */
const PROPERTIES = {};
for (const name of TukorView.observedAttributes) {
  const property = name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
  const flag = name === "auto-rotate" || name === "camera-controls";
  PROPERTIES[property] = {
    get() { return flag ? this.hasAttribute(name) : this.getAttribute(name); },
    set(value) {
      if (flag) this.toggleAttribute(name, Boolean(value));
      else if (value === null || value === undefined) this.removeAttribute(name);
      else this.setAttribute(name, value);
    },
    configurable: true,
    enumerable: true,
  };
}
Object.defineProperties(TukorView.prototype, PROPERTIES);

customElements.define("tukor-view", TukorView);
