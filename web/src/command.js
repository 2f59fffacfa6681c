// The `tukor render` command of a view.
import { lists } from "./attributes.js";

/** A word as a POSIX shell takes it. */
function shellQuoted(word) {
  return /^[\w.,:/=-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

const figures = (values) => values.map((value) => +value.toFixed(5)).join(",");

/** `options` are pairs of a flag and its text. */
export function renderCommand({ src, environment, materials, options, view: { eye, target, fov }, width, height }) {
  const words = ["tukor", "render", src];
  for (const one of lists(materials)) words.push("--material", one);
  words.push("--environment", environment);
  for (const [flag, value] of options) words.push(flag, typeof value === "number" ? figures([value]) : value.trim());
  words.push("--eye", figures(eye), "--target", figures(target), "--fov", figures([(fov * 180) / Math.PI]));
  words.push("--size", `${width}x${height}`, "-o", "view.png");
  return words.map(shellQuoted).join(" ");
}
