// Attribute values as people write them in HTML: angles, lengths, orbits. Everything inside is radians and metres.

const ANGLE = { deg: Math.PI / 180, rad: 1, turn: 2 * Math.PI };
const LENGTH = { m: 1, cm: 0.01, mm: 0.001, "%": 0.01 }; // the last of something else

function quantity(text, units, standard) {
  const [, figure, unit] = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]*)$/i.exec(text.trim()) ?? [];
  const value = figure * units[unit?.toLowerCase() || standard];
  return Number.isFinite(value) ? { value, relative: unit === "%" } : null;
}

/** Radians of "30deg", "0.5rad", "0.1turn" or "30" (degrees); null when it is none. */
export function angle(text) {
  return quantity(text, ANGLE, "deg")?.value ?? null;
}

/** A finite number; null when it is none. */
export function number(text) {
  const value = Number(text);
  return text.trim() !== "" && Number.isFinite(value) ? value : null;
}

/** "theta phi radius" as in model-viewer: azimuth from +Z, polar angle from +Y, distance in metres, percent of framing, or auto; the distance is above 0. */
export function orbit(text, framing) {
  const words = text.trim().split(/\s+/);
  if (words.length !== 3) return null;
  const theta = words[0] === "auto" ? framing.theta : angle(words[0]);
  const phi = words[1] === "auto" ? framing.phi : angle(words[1]);
  const radius = words[2] === "auto" ? { value: 1, relative: true } : quantity(words[2], LENGTH, "m");
  if (theta === null || phi === null || !(radius?.value > 0)) return null;
  return { theta, phi, radius: radius.relative ? radius.value * framing.radius : radius.value };
}

/** "x y z" in metres, or auto for the centre of the model. */
export function point(text, framing) {
  if (text.trim() === "auto") return { target: framing.target.slice() };
  const words = text.trim().split(/\s+/).map((word) => quantity(word, LENGTH, "m"));
  return words.length === 3 && words.every((q) => q && !q.relative) ? { target: words.map((q) => q.value) } : null;
}
