// <tukor-view>: the custom element. Attributes in, pictures and events out; the light is computed behind link.js.
import { Link } from "./link.js";
import { OrbitCamera } from "./orbit-camera.js";
import { listen, spokenView } from "./controls.js";
import { angle, number, orbit, point } from "./units.js";
import { baseName, download, neighbours } from "./files.js";
import { renderCommand } from "./command.js";
import { styleSheet } from "./style.js";

const REST_SAMPLES = 256; // frames accumulated at rest; the picture no longer changes visibly after that
const AUTO_ROTATE = Math.PI / 16; // rad/s
const STANDARD_FOV = (40 * Math.PI) / 180;
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

/** Attributes with a word for a value, which the library reads, and the word when there is none. */
const CHOICES = { background: "quad", fidelity: "exact", fresnel: "exact", "tone-map": "neutral" };
/** Attributes with a figure: how it is read, in the library's unit, and the figure when there is none. */
const FIGURES = {
  "environment-rotation": [angle, 0],
  "environment-intensity": [(text) => (number(text) >= 0 ? number(text) : null), 1],
  "max-depth": [(text) => (/^\d+$/.test(text) && text >= 1 && text <= 64 ? Number(text) : null), 64],
  exposure: [number, 0],
  "time-seconds": [(text) => (number(text) >= 0 ? number(text) : null), -1], // none
};
const CAMERA = ["camera-orbit", "camera-target", "field-of-view"];
const FLAGS = ["auto-rotate", "camera-controls"];
const MODEL = ["src", "variant", "time-seconds"]; // the model is read anew
const OTHERS = ["src", "variant", "environment", "material", "alt", "poster", "loading", "reveal", ...FLAGS];

export class TukorView extends HTMLElement {
  static observedAttributes = [...Object.keys(CHOICES), ...Object.keys(FIGURES), ...CAMERA, ...OTHERS];

  #root = this.attachShadow({ mode: "open" });
  #canvas;
  #poster;
  #bar;
  #message;
  #spoken;
  #link = null;
  #starting = null;
  #camera = new OrbitCamera();
  #stop = null; // AbortController of everything that listens while connected
  #controlled = null; // the same for the camera's controls
  #serial = { src: 0, environment: 0 }; // the newest request wins
  #files = { src: null, environment: null }; // dropped ones, until the attribute changes
  #names = { src: "", environment: "studio" }; // of what is shown
  #ready = { src: false, environment: false };
  #share = { src: 0, environment: 0 }; // fractions that have arrived
  #parts = [];
  #size = { width: 300, height: 150 }; // of the picture, in pixels
  #visible = false;
  #frame = 0;
  #drawing = false;
  #restart = false;
  #last = 0;
  #samples = 0;
  #movedAt = -Infinity;
  #speaking = 0;
  #loaded = false;
  #dismissed = false;

  constructor() {
    super();
    this.#root.adoptedStyleSheets = [styleSheet()];
    const make = (tag, properties) => Object.assign(document.createElement(tag), properties);
    this.#canvas = make("canvas", { role: "img" });
    this.#poster = make("div", { className: "poster" });
    this.#bar = make("progress", { className: "bar", max: 1, value: 0, hidden: true, ariaLabel: "Loading" });
    this.#message = make("p", { className: "message", hidden: true, role: "alert" });
    this.#spoken = make("div", { className: "spoken", role: "status" });
    this.#root.append(this.#canvas, this.#poster, make("slot", { name: "poster" }), this.#bar, this.#message, this.#spoken);
    for (const property of Object.keys(PROPERTIES)) { // values set before the element was defined
      if (Object.hasOwn(this, property)) {
        const value = this[property];
        delete this[property];
        this[property] = value;
      }
    }
  }

  connectedCallback() {
    const { signal } = (this.#stop = new AbortController());
    observe(IntersectionObserver, (entries) => {
      this.#visible = entries.at(-1).isIntersecting;
      if (this.#visible) this.#start();
      this.#wake();
    }, this, signal);
    observe(ResizeObserver, () => this.#changed(), this, signal);
    document.addEventListener("visibilitychange", () => this.#wake(), { signal });
    this.#controls();
    if (this.getAttribute("loading") === "eager") this.#start();
  }

  disconnectedCallback() {
    this.#stop.abort();
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#speaking);
    this.#frame = 0;
    this.#link?.close();
    this.#visible = false;
    this.#forget();
    const canvas = this.#canvas.cloneNode(); // a context cannot be taken off its canvas
    this.#canvas.replaceWith(canvas);
    this.#canvas = canvas;
  }

  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === "alt") this.#describe();
    if (name === "poster") this.#poster.style.backgroundImage = now ? `url(${JSON.stringify(now)})` : "";
    if (name === "camera-controls" && this.#stop) this.#controls(); // not yet connected while the parser upgrades it
    if (name in this.#files) this.#files[name] = null;
    if (name === "src" && this.#visible) this.#start();
    if (name === "auto-rotate") this.#wake();
    if (!this.#link) return;
    if (MODEL.includes(name)) this.#loadModel();
    else if (name === "environment") this.#loadEnvironment();
    else if (name === "material") this.#guard(() => this.#materials());
    else if (name in CHOICES || name in FIGURES) this.#guard(() => this.#option(name));
    else if (CAMERA.includes(name)) this.#guard(() => this.#cameraAttribute(name));
    this.#changed();
  }

  // ---- the public methods ----

  /** True once model and environment are there and a frame of them has been drawn. */
  get loaded() { return this.#loaded; }

  /** Samples a pixel accumulated in the picture at rest. */
  get accumulatedSamples() { return this.#samples; }

  /** Parts of the model: [{name, material}], in drawing order. */
  get parts() { return this.#parts.map((part) => ({ ...part })); }

  /** The `tukor render` command that gives the present view; files are named as the page names them. */
  get command() {
    if (!this.#loaded) return "";
    const options = [...Object.keys(CHOICES), "variant"].filter((name) => this.hasAttribute(name)).map((name) => [name === "tone-map" ? "--tonemap" : `--${name}`, this.getAttribute(name)]);
    for (const name of Object.keys(FIGURES))
      if (this.hasAttribute(name)) options.push([`--${name}`, this.#figure(name) * (name === "environment-rotation" ? 180 / Math.PI : 1)]);
    return renderCommand({ ...this.#names, materials: this.getAttribute("material") ?? "", options, view: this.#camera.view(), ...this.#size });
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
  async partAtPoint(clientX, clientY) {
    if (!this.#ready.src) return null;
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    const parts = this.#parts;
    const index = await this.#link.ask("pick", { view: this.#camera.view(), x: (clientX - left) / width, y: (clientY - top) / height, aspect: width / height });
    return index === 0 ? null : parts[index - 1].name;
  }

  /** Sentences about what the files ask for and do not get. */
  async warnings() {
    return this.#link ? this.#link.ask("warnings") : [];
  }

  /** Renders the present view at any size, with so many samples a pixel: straight-alpha 8-bit sRGB. */
  async render({ width = this.#size.width, height = this.#size.height, samples = 64 } = {}) {
    if (!(width >= 1 && height >= 1 && width <= 16384 && height <= 16384))
      throw new RangeError(`size ${width} x ${height}: expected 1 to 16384 pixels a side`);
    await this.#whenLoaded();
    const bytes = await this.#link.ask("still", { view: this.#camera.view(), width, height, samples });
    this.#changed();
    return new ImageData(new Uint8ClampedArray(bytes.buffer), width, height);
  }

  async toBlob({ mimeType = "image/png", qualityArgument, ...size } = {}) {
    const image = await this.render(size);
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext("2d").putImageData(image, 0, 0);
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
    this.#files.src = file;
    if (this.#link) await this.#loadModel();
    else await this.#start();
  }

  async loadEnvironmentFile(file) {
    this.#files.environment = file;
    if (this.#link) await this.#loadEnvironment();
    else await this.#start();
  }

  // ---- starting and loading ----

  #start() {
    if (!this.hasAttribute("src") && !this.#files.src) return null;
    const waits = this.getAttribute("reveal") === "manual" && this.getAttribute("loading") !== "eager" && !this.#dismissed;
    if (!waits) this.#starting ??= this.#begin().catch((error) => this.#fail(error));
    return this.#starting;
  }

  /** Nothing is shown, and nothing is under way. */
  #forget() {
    this.#link = this.#starting = null;
    this.#loaded = this.#drawing = false;
    this.#ready = { src: false, environment: false };
    this.#share = { src: 0, environment: 0 };
    for (const what of ["src", "environment"]) this.#serial[what]++;
  }

  async #begin() {
    this.#progress(0);
    const canvas = this.#canvas;
    const link = await Link.open(canvas, (event) => this.#contextSaid(event));
    if (canvas !== this.#canvas || !this.isConnected) { // removed meanwhile
      link.close();
      return;
    }
    this.#link = link;
    await this.#sendAll();
  }

  #sendAll() {
    for (const name of [...Object.keys(CHOICES), ...Object.keys(FIGURES)]) if (this.hasAttribute(name) && !MODEL.includes(name)) this.#guard(() => this.#option(name));
    return Promise.all([this.#loadModel(), this.#loadEnvironment()]);
  }

  #contextSaid(event) {
    const link = this.#link;
    if (event === "lost") {
      this.#forget();
      this.#link = link; // it stays, and so does the canvas
      this.#starting = Promise.resolve();
    } else {
      link?.ask("start").then(() => this.#sendAll()).catch((error) => this.#fail(error));
    }
  }

  #loadModel() {
    return this.#load("src", this.getAttribute("src"), /^[a-z-]+$/, async ({ name, bytes, url }, current) => {
      const files = bytes ? await neighbours(bytes, name, url) : [];
      if (!current()) return;
      const aspect = this.#canvas.clientWidth / this.#canvas.clientHeight || 1;
      const { framing, parts } = await this.#link.ask("model", { name, bytes, files, aspect, variant: this.getAttribute("variant") ?? "", seconds: this.#figure("time-seconds") }, bytes ? [bytes.buffer] : []);
      if (!current()) return;
      this.#parts = parts;
      this.#materials();
      if (this.#ready.src && this.#names.src === (this.#files.src?.name ?? this.getAttribute("src"))) return; // another look of the same: the view stays
      this.#camera.frame(framing);
      for (const attribute of CAMERA) this.#guard(() => this.#cameraAttribute(attribute));
      this.#camera.jump();
    });
  }

  #loadEnvironment() {
    return this.#load("environment", this.getAttribute("environment") ?? "studio", /^[a-z]+$/,
      ({ name, bytes }) => this.#link.ask("environment", { name, bytes }, bytes ? [bytes.buffer] : []));
  }

  /** A dropped file, a built-in or a URL, handed to `send` as {name, bytes, url}; no bytes for a built-in. */
  async #load(what, attribute, builtIn, send) {
    const serial = ++this.#serial[what];
    const current = () => serial === this.#serial[what] && this.#link;
    const file = this.#files[what];
    const source = file ? file.name : attribute;
    if (!source) return;
    const name = file ? file.name : baseName(source);
    try {
      const found = { name, bytes: undefined, url: null };
      if (file) found.bytes = new Uint8Array(await file.arrayBuffer());
      else if (!builtIn.test(source)) {
        found.url = new URL(source, document.baseURI);
        found.bytes = await download(found.url, name, (fraction) => current() && this.#arrives(what, 0.9 * fraction));
      }
      if (found.bytes?.length === 0) throw new Error(`${name}: an empty file`);
      if (!current()) return;
      await send(found, current);
      if (!current()) return;
      this.#names[what] = source;
      this.#ready[what] = true;
      if (what === "src") this.#loaded = false; // the next frame says `load` again
      this.#message.hidden = true;
      this.#arrives(what, 1);
      this.#changed();
    } catch (error) {
      if (current()) this.#fail(error);
    }
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
    return this.#link.ask("materials", { text: this.getAttribute("material") ?? "" });
  }

  #option(name) {
    if (name in CHOICES) return this.#link.ask("option", { name, text: (this.getAttribute(name) ?? CHOICES[name]).trim() });
    if (name === "exposure") return this.#link.ask("exposure", { stops: this.#figure(name) });
    if (name === "max-depth") return this.#link.ask("depth", { depth: this.#figure(name) });
    return this.#link.ask("light", { rotation: this.#figure("environment-rotation"), intensity: this.#figure("environment-intensity") });
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
      const value = text === null || text === "auto" ? STANDARD_FOV : angle(text);
      if (!(value > 0 && value < Math.PI)) throw new Error(`field-of-view="${text}": expected an angle between 0deg and 180deg`);
      this.#camera.set({ fov: value });
    }
  }

  #controls() {
    this.#controlled?.abort();
    this.#controlled = new AbortController();
    const interactive = this.hasAttribute("camera-controls");
    if (interactive) this.#canvas.tabIndex = 0;
    else this.#canvas.removeAttribute("tabindex");
    this.#canvas.setAttribute("role", interactive ? "application" : "img");
    this.#describe();
    if (interactive) listen(this.#canvas, this.#camera, () => this.#steered(), AbortSignal.any([this.#controlled.signal, this.#stop.signal]));
  }

  #describe() {
    const name = this.getAttribute("alt") || "3D model";
    const keys = ". Arrow keys turn it, page up and page down zoom, shift with arrow keys moves it.";
    this.#canvas.setAttribute("aria-label", this.hasAttribute("camera-controls") ? name + keys : name);
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

  // ---- drawing ----

  #changed() {
    this.#samples = 0;
    this.#restart = true;
    this.#wake();
  }

  get #awake() {
    return this.#link && this.#visible && !document.hidden && this.#ready.src && this.#ready.environment;
  }

  #wake() {
    if (this.#frame || this.#drawing || !this.#awake) return;
    this.#last = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#draw(now));
  }

  async #draw(now) {
    this.#frame = 0;
    if (!this.#awake) return;
    const link = this.#link;
    const turns = this.hasAttribute("auto-rotate") && !reducedMotion.matches;
    const moving = this.#moveCamera(now, turns);
    const { clientWidth, clientHeight } = this.#canvas;
    this.#size = { width: Math.max(1, Math.round(clientWidth * devicePixelRatio)), height: Math.max(1, Math.round(clientHeight * devicePixelRatio)) };
    const coarse = this.#restart || moving; // a quick one first, then all of it
    this.#restart = false;
    this.#drawing = true;
    let samples;
    try {
      samples = await link.ask("frame", { view: this.#camera.view(), ...this.#size, moving: coarse });
    } catch (error) {
      if (link === this.#link && this.#awake) this.#fail(error);
      return;
    } finally {
      this.#drawing = false;
    }
    if (link !== this.#link || !this.#awake) return;
    if (!this.#restart) this.#samples = coarse ? 0 : samples;
    if (!this.#loaded) {
      this.#loaded = true;
      this.#poster.hidden = true;
      this.#progress(1);
      this.dispatchEvent(new CustomEvent("load", { detail: { url: this.getAttribute("src") } }));
    }
    if (moving) this.dispatchEvent(new CustomEvent("camera-change", { detail: { source: this.#movedAt > -Infinity ? "user-interaction" : "none" } }));
    this.dispatchEvent(new CustomEvent("frame", { detail: { samples, moving } }));
    if (!this.#frame && this.#awake && (this.#restart || coarse || turns || samples < REST_SAMPLES))
      this.#frame = requestAnimationFrame((next) => this.#draw(next));
  }

  /** Eases the camera towards its goal; whether it moved. */
  #moveCamera(now, turns) {
    const seconds = Math.min((now - this.#last) / 1000, 0.1);
    this.#last = now;
    const turning = turns && now - this.#movedAt > 3000;
    if (turning) this.#camera.rotate(AUTO_ROTATE * seconds, 0);
    const before = this.#camera.view();
    if (reducedMotion.matches) this.#camera.jump();
    return this.#camera.step(seconds) || turning || before.eye.some((x, i) => x !== this.#camera.view().eye[i]);
  }

  // ---- telling ----

  #arrives(what, fraction) {
    this.#share[what] = fraction;
    if (!this.#loaded) this.#progress(0.95 * (0.5 * this.#share.src + 0.5 * this.#share.environment));
  }

  #progress(fraction) {
    this.#bar.value = fraction;
    this.#bar.hidden = fraction >= 1;
    this.dispatchEvent(new CustomEvent("progress", { detail: { totalProgress: fraction } }));
  }

  /** Does something that may be refused, now or later. */
  async #guard(action) {
    const link = this.#link;
    try {
      await action();
      if (link === this.#link) this.#message.hidden = true;
    } catch (error) {
      if (link === this.#link) this.#fail(error);
    }
  }

  #fail(error) {
    if (error.lost) return; // the context comes back, and all is sent again
    this.#message.textContent = error.message;
    this.#message.hidden = false;
    this.#bar.hidden = true;
    this.dispatchEvent(new CustomEvent("error", { detail: { message: error.message, sourceError: error } }));
  }
}

/** Watches one element until a signal. */
function observe(Kind, callback, element, signal) {
  const observer = new Kind(callback);
  observer.observe(element);
  signal.addEventListener("abort", () => observer.disconnect());
}

/** Every attribute is a property too, in camel case. */
const PROPERTIES = {};
for (const name of TukorView.observedAttributes) {
  const property = name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
  const flag = FLAGS.includes(name);
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
