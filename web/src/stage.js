// What an element shows, in its shadow tree: the canvas, and over it poster, progress, message and spoken words.
import { sheet } from "./style.js";

export class Stage {
  constructor(root) {
    root.adoptedStyleSheets = [sheet];
    const make = (tag, properties) => Object.assign(document.createElement(tag), properties);
    this.canvas = make("canvas");
    this.poster = make("div", { className: "poster" });
    this.bar = make("progress", { hidden: true, ariaLabel: "Loading" });
    this.message = make("p", { hidden: true, role: "alert" });
    this.spoken = make("div", { role: "status" });
    root.append(this.canvas, this.poster, make("slot", { name: "poster" }), this.bar, this.message, this.spoken);
  }

  /** A canvas without the context, which cannot be taken off its own. */
  renewCanvas() {
    const canvas = this.canvas.cloneNode();
    this.canvas.replaceWith(canvas);
    this.canvas = canvas;
  }

  /** Its size on the screen, in pixels. */
  get size() {
    const pixels = (length) => Math.max(1, Math.round(length * devicePixelRatio));
    return { width: pixels(this.canvas.clientWidth), height: pixels(this.canvas.clientHeight) };
  }

  get aspect() {
    return this.canvas.clientWidth / this.canvas.clientHeight || 1;
  }

  setPoster(url) {
    this.poster.style.backgroundImage = url ? `url(${JSON.stringify(url)})` : "";
  }

  progress(fraction) {
    this.bar.value = fraction;
    this.bar.hidden = fraction >= 1 || !this.message.hidden;
  }

  /** A message over the picture; none hides it. */
  say(text) {
    if (text !== this.message.textContent) this.message.textContent = text; // or it would be spoken again
    this.message.hidden = !text;
    if (text) this.bar.hidden = true;
  }

  /** What a screen reader says at once when it is something new. */
  speak(words) {
    if (words !== this.spoken.textContent) this.spoken.textContent = words;
  }

  describe(alt, interactive) {
    const keys = ". Arrow keys turn it, page up and page down zoom, shift with arrow keys moves it.";
    if (interactive) this.canvas.tabIndex = 0;
    else this.canvas.removeAttribute("tabindex");
    this.canvas.setAttribute("role", interactive ? "application" : "img");
    this.canvas.setAttribute("aria-label", interactive ? alt + keys : alt);
  }
}
