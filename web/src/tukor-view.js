// <tukor-view>: the custom element. Attributes in, pictures and events out; the light is computed behind link.js.
import { ATTRIBUTES, CAMERA, CHOICES, FIGURES, MATERIALS, MODEL, OPTIONS, PAGE_ONLY, cameraGoal, figureOf, lists, reflect, upgrade } from "./attributes.js";
import { Clock } from "./clock.js";
import { renderCommand } from "./command.js";
import { listen, spokenView } from "./controls.js";
import { neighbours } from "./files.js";
import { Link } from "./link.js";
import { OrbitCamera } from "./orbit-camera.js";
import { Player, reducedMotion } from "./player.js";
import { Sources } from "./sources.js";
import { Stage } from "./stage.js";
import { blobOf, dataUrlOf } from "./stills.js";

export class TukorView extends HTMLElement {
  static observedAttributes = ATTRIBUTES;

  #stage = new Stage(this.attachShadow({ mode: "open" }));
  #camera = new OrbitCamera();
  #sources = new Sources();
  #clock = new Clock();
  #player = new Player(this.#camera, this.#playerHost());
  #link = null;
  #starting = null;
  #stop = null; // AbortController of everything that listens while connected
  #controlled = null; // the same for the camera's controls
  #parts = [];
  #animations = [];
  #visible = false;
  #speaking = 0;
  #loaded = false;
  #dismissed = false;
  #causes = {}; // by attribute or act: the error that there is

  constructor() {
    super();
    upgrade(this);
  }

  connectedCallback() {
    const { signal } = (this.#stop = new AbortController());
    observe(IntersectionObserver, (entries) => {
      this.#visible = entries.at(-1).isIntersecting;
      if (this.#visible) this.#start();
      this.#player.wake();
    }, this, signal);
    observe(ResizeObserver, () => this.#player.changed(), this, signal);
    document.addEventListener("visibilitychange", () => this.#player.wake(), { signal });
    this.#controls();
    if (this.loading === "eager") this.#start();
  }

  disconnectedCallback() {
    this.#stop.abort();
    clearTimeout(this.#speaking);
    this.#link?.close();
    this.#visible = false;
    this.#forget();
    this.#sources.names.src = "";
    this.#stage.renewCanvas();
  }

  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === "alt") this.#describe();
    if (name === "poster") this.#stage.setPoster(now);
    if (name === "camera-controls" && this.#stop) this.#controls(); // not yet connected while the parser upgrades it
    if (name in this.#sources.files) this.#sources.files[name] = null;
    if (name === "src" && this.#visible) this.#start();
    if (name === "auto-rotate") this.#player.wake();
    if (!this.#link) return;
    if (name === "autoplay") this.#autoplay();
    if (MODEL.includes(name)) this.#loadModel();
    else if (name === "environment") this.#loadEnvironment();
    else if (MATERIALS.includes(name)) this.#materials();
    else if (OPTIONS.includes(name)) this.#option(name);
    else if (CAMERA.includes(name)) this.#aim(name);
    this.#player.changed();
  }

  // ---- the public methods ----

  /** True once model and environment are there and a frame of them has been drawn. */
  get loaded() { return this.#loaded; }

  /** Samples a pixel accumulated in the picture at rest. */
  get accumulatedSamples() { return this.#player.samples; }

  /** Parts of the model: [{name, material}], in drawing order. */
  get parts() { return this.#parts.map((part) => ({ ...part })); }

  /** The `tukor render` command that gives the present view; files are named as the page names them. */
  get command() {
    if (!this.#loaded) return "";
    const options = [...Object.keys(CHOICES), "variant", "animation", "ground"].filter((name) => this.hasAttribute(name)).map((name) => [name === "tone-map" ? "--tonemap" : `--${name}`, this.getAttribute(name)]);
    if (this.#clock.seconds >= 0) options.push(["--time-seconds", this.#clock.seconds]);
    for (const sun of lists(this.light ?? "")) options.push(["--light", sun]);
    for (const name of Object.keys(FIGURES))
      if (this.hasAttribute(name) && !PAGE_ONLY.includes(name)) options.push([`--${name}`, figureOf(this, name) * (name === "environment-rotation" ? 180 / Math.PI : 1)]);
    return renderCommand({ ...this.#sources.names, materials: this.material ?? "", options, view: this.#camera.view(), ...this.#player.size });
  }

  /** Names of the model's animations; `animation` chooses one. */
  get availableAnimations() { return this.#animations.map(({ name }) => name); }

  /** Of the animation, in seconds. */
  get duration() { return this.#clock.duration; }
  get paused() { return this.#clock.paused; }
  get currentTime() { return Math.max(this.#clock.seconds, 0); }
  set currentTime(seconds) {
    this.#clock.seconds = Number(seconds);
    this.#player.changed();
  }

  play() { this.#run(true); }
  pause() { this.#run(false); }

  /** Ends the easing of the camera: the view is its goal from the next frame on. */
  jumpCameraToGoal() {
    this.#camera.jump();
    this.#player.changed();
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
    this.#stage.poster.hidden = true;
  }

  /** Name of the part under a point of the page (client coordinates), or null. */
  async partAtPoint(clientX, clientY) {
    if (!this.#sources.isReady("src")) return null;
    const { left, top, width, height } = this.#stage.canvas.getBoundingClientRect();
    const parts = this.#parts;
    const index = await this.#link.ask("pick", { view: this.#camera.view(), x: (clientX - left) / width, y: (clientY - top) / height, aspect: width / height });
    return index === 0 ? null : parts[index - 1].name;
  }

  /** Sentences about what the files ask for and do not get. */
  async warnings() {
    return this.#link ? this.#link.ask("warnings") : [];
  }

  /** Renders the present view at any size, with so many samples a pixel: straight-alpha 8-bit sRGB. */
  async render({ width = this.#player.size.width, height = this.#player.size.height, samples = 64 } = {}) {
    if (!(width >= 1 && height >= 1 && width <= 16384 && height <= 16384))
      throw new RangeError(`size ${width} x ${height}: expected 1 to 16384 pixels a side`);
    await this.#whenLoaded();
    const bytes = await this.#link.ask("still", { view: this.#camera.view(), width, height, samples, seconds: this.#clock.seconds });
    this.#player.changed();
    return new ImageData(new Uint8ClampedArray(bytes.buffer), width, height);
  }

  async toBlob({ mimeType = "image/png", qualityArgument, ...size } = {}) {
    return blobOf(await this.render(size), mimeType, qualityArgument);
  }

  /** A data URL of the present view. Unlike a canvas's own, it is a promise: the picture is rendered anew, to the end. */
  async toDataURL(mimeType = "image/png", qualityArgument = undefined) {
    return dataUrlOf(await this.toBlob({ mimeType, qualityArgument }));
  }

  /** Loads a dropped or chosen model file, with those that it names; nothing leaves the page. */
  async loadModelFile(...files) {
    this.#sources.files.src = files;
    await (this.#link ? this.#loadModel() : this.#start());
  }

  async loadEnvironmentFile(file) {
    this.#sources.files.environment = [file];
    await (this.#link ? this.#loadEnvironment() : this.#start());
  }

  // ---- starting and loading ----

  #start() {
    if (!this.#sources.nameOf("src", this.src)) return null;
    const waits = this.reveal === "manual" && this.loading !== "eager" && !this.#dismissed;
    if (!waits) this.#starting ??= this.#begin().catch((error) => this.#fail(error, "start"));
    return this.#starting;
  }

  /** Nothing is shown, and nothing is under way. */
  #forget() {
    this.#link = this.#starting = null;
    this.#loaded = false;
    this.#causes = {};
    this.#player.stop();
    this.#sources.forget();
  }

  async #begin() {
    this.#progress(0);
    const { canvas } = this.#stage;
    const link = await Link.open(canvas, (event) => this.#contextSaid(event));
    if (canvas !== this.#stage.canvas || !this.isConnected) { // removed meanwhile
      link.close();
      return;
    }
    this.#link = link;
    await this.#sendAll();
  }

  #sendAll() {
    for (const name of OPTIONS) if (name !== "time-seconds" && this.hasAttribute(name)) this.#option(name);
    return Promise.all([this.#loadModel(), this.#loadEnvironment()]);
  }

  #contextSaid(event) {
    const link = this.#link;
    if (event === "lost") {
      this.#forget();
      this.#link = link; // it stays, and so does the canvas
      this.#starting = Promise.resolve();
    } else {
      link?.ask("start").then(() => this.#sendAll()).catch((error) => this.#fail(error, "start"));
    }
  }

  #loadModel() {
    return this.#load("src", this.src, async (found, current) => {
      const { name, bytes } = found;
      const files = bytes && (await neighbours(found));
      if (!current()) return;
      const variant = this.variant ?? "";
      const animation = this.animation ?? "";
      const same = this.#sources.names.src === this.#sources.nameOf("src", this.src);
      if (!same) this.#option("time-seconds");
      const { seconds } = this.#clock;
      const { framing, parts, animations } = await this.#link.ask("model", { name, bytes, files, aspect: this.#stage.aspect, variant, animation, seconds }, bytes ? [bytes.buffer] : []);
      if (!current()) return;
      this.#parts = parts;
      this.#animations = animations;
      const { duration = 0 } = animations.find(({ name }) => name === animation) ?? animations[animation || 0] ?? {};
      this.#clock.duration = duration;
      this.#materials();
      this.#option("light");
      if (same) return; // another look of the same: the view stays
      this.#clock.paused = true;
      this.#autoplay();
      this.#camera.frame(framing);
      CAMERA.forEach(this.#aim, this);
      this.#camera.jump();
    });
  }

  #loadEnvironment() {
    return this.#load("environment", this.environment || "studio", ({ name, bytes }) => this.#link.ask("environment", { name, bytes }, bytes ? [bytes.buffer] : []));
  }

  /** Where it fails and nothing is shown: what was shown last, or the studio. */
  #load(what, attribute, send) {
    const load = (source) => this.#sources.load(what, source, send, () => {
      if (!this.#loaded) this.#progress(0.95 * this.#sources.arrived);
    });
    return this.#guard(what, async () => {
      const shown = await load(attribute).catch((error) => {
        this.#fail(error, what);
        return !this.#sources.isReady(what) && load(this.#sources.names[what]);
      });
      if (shown && what === "src") this.#loaded = false; // the next frame says `load` again
      if (shown) this.#player.changed();
    });
  }

  /** Rejects where nothing is under way that could still load. */
  async #whenLoaded() {
    this.#start();
    if (this.#loaded) return;
    for (const what of ["start", "src", "environment", "frame"]) if (this.#causes[what]?.message) throw this.#causes[what];
    await new Promise((resolve, reject) => {
      this.addEventListener("load", resolve, { once: true });
      this.addEventListener("error", (event) => reject(event.detail.sourceError), { once: true });
    });
  }

  #run(runs) {
    if (runs && !this.#clock.duration) return;
    this.#clock.paused = !runs;
    this.#tell(runs ? "play" : "pause");
    this.#player.changed();
  }

  /** Not for those who ask for less motion. */
  #autoplay() {
    if (this.autoplay && !reducedMotion.matches) this.play();
  }

  // ---- attributes ----

  #set(what, ...values) {
    return this.#link.ask("set", { what, values });
  }

  #materials() {
    this.#guard("material", () => this.#set("materials", this.material ?? "", figureOf(this, "dispersion")));
  }

  #option(name) {
    this.#guard(name.slice(0, 12), () => { // those of the environment are set together
      if (name in CHOICES) return this.#set("option", name, (this.getAttribute(name) ?? CHOICES[name]).trim());
      const value = figureOf(this, name);
      if (name === "time-seconds") return (this.#clock.seconds = value);
      if (name === "light") return this.#set("suns", Float32Array.from(value), value.length);
      if (name.startsWith("environment-")) return this.#set("light", figureOf(this, "environment-rotation"), figureOf(this, "environment-intensity"));
      return this.#set(name.replace("-", "_"), value);
    });
  }

  #aim(name) {
    this.#guard(name, () => this.#camera.set(cameraGoal(this, name, this.#camera.framing)));
  }

  #controls() {
    this.#controlled?.abort();
    this.#controlled = new AbortController();
    this.#describe();
    const signal = AbortSignal.any([this.#controlled.signal, this.#stop.signal]);
    if (this.cameraControls) listen(this.#stage.canvas, this.#camera, (home) => this.#steered(home), signal);
  }

  #describe() {
    this.#stage.describe(this.alt || "3D model", this.cameraControls);
  }

  #steered(home) {
    if (home) CAMERA.forEach(this.#aim, this);
    this.#player.movedAt = performance.now();
    this.#player.changed();
    clearTimeout(this.#speaking);
    this.#speaking = setTimeout(() => this.#stage.speak(spokenView(this.#camera.goal.theta, this.#camera.goal.phi)), 300);
  }

  // ---- drawing and telling ----

  #playerHost() {
    const view = this;
    return {
      get awake() { return Boolean(view.#link) && view.#visible && !document.hidden && view.#sources.allReady; },
      get turns() { return view.autoRotate; },
      get size() { return view.#stage.size; },
      advance: (seconds) => view.#clock.advance(seconds),
      async ask(values) {
        const link = view.#link;
        try {
          const samples = await link.ask("frame", { ...values, seconds: view.#clock.seconds });
          return link === view.#link && this.awake ? samples : null;
        } catch (error) {
          if (link === view.#link && this.awake) throw error;
          return null;
        }
      },
      drawn: (frame) => view.#drawn(frame),
      failed: (error) => view.#fail(error, "frame"),
    };
  }

  #drawn({ samples, moving }) {
    if (!this.#loaded) {
      this.#loaded = true;
      this.#stage.poster.hidden = true;
      this.#progress(1);
      this.#tell("load", { url: this.src });
    }
    if (this.#causes.frame) this.#note("frame");
    if (moving) this.#tell("camera-change", { source: this.#player.movedAt > -Infinity ? "user-interaction" : "none" });
    this.#tell("frame", { samples, moving });
  }

  #tell(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  #progress(fraction) {
    this.#stage.progress(fraction);
    this.#tell("progress", { totalProgress: fraction });
  }

  /** Does something that may be refused, now or later. The message of it stays until the same is done again. */
  async #guard(what, action) {
    const cause = {};
    this.#note(what, cause);
    try {
      await action();
    } catch (error) {
      if (cause === this.#causes[what]) this.#fail(error, what);
    }
  }

  #fail(error, what) {
    if (error.lost) return; // the context comes back, and all is sent again
    this.#note(what, error);
    this.#tell("error", { message: error.message, sourceError: error });
  }

  #note(what, cause) {
    this.#causes[what] = cause;
    this.#stage.say(Object.values(this.#causes).flatMap((cause) => cause?.message ?? []).join("\n"));
  }
}

/** Watches one element until a signal. */
function observe(Kind, callback, element, signal) {
  const observer = new Kind(callback);
  observer.observe(element);
  signal.addEventListener("abort", () => observer.disconnect());
}

reflect(TukorView.prototype);
customElements.define("tukor-view", TukorView);
