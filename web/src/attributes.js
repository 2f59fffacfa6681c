// The attributes of <tukor-view>: what their values are, and the properties that they are in scripts.
import { angle, number, orbit, point } from "./units.js";

const STANDARD_FOV = (40 * Math.PI) / 180;

/** With a word for a value, which the library reads, and the word when there is none. */
export const CHOICES = { background: "quad", fidelity: "exact", fresnel: "exact", "tone-map": "neutral" };

/** The figures of "X,Y,Z/R,G,B; ...", six each. */
function suns(text) {
  const list = lists(text).map((sun) => (sun.includes("/") ? sun : sun + "/1,1,1").split(/[,/]/).map(number));
  return list.every((sun) => sun.length === 6 && !sun.includes(null) && Math.hypot(...sun.slice(0, 3)) > 0 && Math.min(...sun.slice(3)) >= 0) ? list.flat() : null;
}

/** What semicolons part. */
export const lists = (text) => text.split(";").map((one) => one.trim()).filter(Boolean);

const between = (least, most) => (text) => (number(text) >= least && number(text) <= most ? number(text) : null);

/** With a figure: how it is read, in the library's unit, and the figure when there is none. */
export const FIGURES = {
  "environment-rotation": [angle, 0],
  "environment-intensity": [between(0, Infinity), 1],
  "max-depth": [(text) => (/^\d+$/.test(text) && text >= 1 && text <= 64 ? Number(text) : null), 64],
  exposure: [number, 0],
  "background-blur": [between(0, 1), 0],
  dispersion: [between(0, 100), -1], // as in the model
  ground: [(text) => (text.trim() === "lowest" ? -Infinity : number(text)), Infinity], // none
  light: [suns, []],
  "time-seconds": [between(0, Infinity), -1], // none
};

/** Of these the command says nothing, or something else. */
export const PAGE_ONLY = ["light", "time-seconds", "ground"];

function fieldOfView(text) {
  const fov = text === "auto" ? STANDARD_FOV : angle(text);
  return fov > 0 && fov < Math.PI ? { fov } : null;
}

/** How they are read, what they are when there is none, and what is expected. */
const VIEW = {
  "camera-orbit": [orbit, "auto auto auto", 'three values such as "30deg 75deg 4m" or "auto 75deg 120%"'],
  "camera-target": [point, "auto", 'auto or three lengths such as "0m 1m 0m"'],
  "field-of-view": [fieldOfView, "auto", "an angle between 0deg and 180deg"],
};

export const CAMERA = Object.keys(VIEW);

/** What its surfaces are made of. */
export const MATERIALS = ["material", "dispersion"];

/** Of these the model is read anew. */
export const MODEL = ["src", "variant", "animation"];

/** Of these the library is told at once. */
export const OPTIONS = [...Object.keys(CHOICES), ...Object.keys(FIGURES)].filter((name) => !MATERIALS.includes(name));

const FLAGS = ["auto-rotate", "autoplay", "camera-controls"];
export const ATTRIBUTES = [...OPTIONS, ...CAMERA, ...MODEL, ...MATERIALS, ...FLAGS, "environment", "alt", "poster", "loading", "reveal"];

export function figureOf(element, name) {
  const [read, standard] = FIGURES[name];
  const text = element.getAttribute(name);
  const value = text === null ? standard : read(text);
  if (value === null) throw new Error(`${name}="${text}": not understood`);
  return value;
}

/** What an attribute of the camera says, as OrbitCamera takes it. */
export function cameraGoal(element, name, framing) {
  const [read, standard, expected] = VIEW[name];
  const text = element.getAttribute(name);
  const goal = read(text ?? standard, framing);
  if (!goal) throw new Error(`${name}="${text}": expected ${expected}`);
  return goal;
}

const PROPERTIES = {};
for (const name of ATTRIBUTES) {
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

/** Makes every attribute a property too, in camel case. */
export function reflect(prototype) {
  Object.defineProperties(prototype, PROPERTIES);
}

/** Passes on what was set before the element was defined. */
export function upgrade(element) {
  for (const property of Object.keys(PROPERTIES)) {
    if (Object.hasOwn(element, property)) {
      const value = element[property];
      delete element[property];
      element[property] = value;
    }
  }
}
