// The editor page: the form steers the element, the element's state is written out as HTML and as a command.
import { acceptDrops, takeAll } from "./drops.js";

const $ = (id) => document.getElementById(id);
const view = $("view");
const materials = new Map(); // part name ("" for all) -> material
const dropped = {}; // names of files that are shown in place of src and environment

const say = (text) => ($("notice").textContent = text);
view.addEventListener("error", (event) => say(event.detail.message));

/** Does what a person asked for; whether the element has nothing against it. */
async function attempt(change) {
  let refused = false;
  const hear = () => (refused = true);
  say("");
  view.addEventListener("error", hear);
  await change();
  await view.warnings(); // answered after what was asked for before
  view.removeEventListener("error", hear);
  return !refused;
}

function materialAttribute() {
  return [...materials].filter(([, name]) => name).map(([part, name]) => (part ? `${part}=${name}` : name)).join("; ") || null;
}

function write() {
  const { theta, phi, radius } = view.getCameraOrbit();
  const { x, y, z } = view.getCameraTarget();
  const degrees = (radians) => `${+((radians * 180) / Math.PI).toFixed(2)}deg`;
  const src = dropped.src ?? view.src;
  const attributes = {
    src, environment: dropped.environment ?? view.environment, material: view.material, fidelity: view.fidelity, exposure: view.exposure,
    "tone-map": view.toneMap, dispersion: view.dispersion, ground: view.ground, "environment-rotation": view.environmentRotation,
    "camera-orbit": `${degrees(theta)} ${degrees(phi)} ${+radius.toFixed(4)}m`, "camera-target": `${[x, y, z].map((v) => `${+v.toFixed(4)}m`).join(" ")}`,
    alt: src.split("/").at(-1).replace(/\.\w+$/, ""), style: "width: 100%; height: 24rem",
  };
  const quoted = Object.entries(attributes).filter(([, value]) => value !== null && value !== "")
    .map(([name, value]) => `${name}="${String(value).replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"`);
  $("html").value = `<script type="module" src="tukor-view.js"></` + `script>\n<tukor-view ${quoted.join(" ")} camera-controls></tukor-view>`;
  $("command").value = view.command;
}

function choosePart(name) {
  $("part").value = name;
  $("material").value = materials.get(name) ?? "";
}

function listParts() {
  const chosen = $("part").value;
  $("part").replaceChildren(new Option("all parts", ""), ...view.parts.map(({ name }) => new Option(name, name)));
  choosePart(view.parts.some(({ name }) => name === chosen) ? chosen : "");
  write();
}

function forgetMaterials() {
  materials.clear();
  view.material = null;
  $("material").value = "";
}

/** The file's name as a choice of its own, until another is made; none takes it away. */
function showDropped(id, name) {
  dropped[id] = name;
  $(id).querySelector("[value='']")?.remove();
  if (name) $(id).prepend(new Option(name, "", true, true));
}

function bind(id, type = "change") {
  $(id).addEventListener(type, () => {
    const { value } = $(id);
    if ($(id).type === "range") $(id).parentElement.querySelector("span").textContent = value;
    if (id === "src") forgetMaterials();
    attempt(() => {
      if (dropped[id]) view.removeAttribute(id); // which may say the same
      if (id === "src" || id === "environment") showDropped(id);
      if (value) view.setAttribute(id, id === "environment-rotation" ? `${value}deg` : value);
      else view.removeAttribute(id);
      write();
    }).then(write);
  });
}
for (const id of ["src", "environment", "fidelity", "tone-map", "ground"]) bind(id);
for (const id of ["exposure", "dispersion", "environment-rotation"]) bind(id, "input");

$("material").addEventListener("change", async () => {
  const part = $("part").value;
  const before = [...materials];
  materials.set(part, $("material").value.trim());
  const message = await attempt(() => (view.material = materialAttribute())) ? "" : $("notice").textContent;
  if (message) { // what is refused is not written; it stays in its field to be corrected
    materials.clear();
    for (const [name, material] of before) materials.set(name, material);
    view.material = materialAttribute();
    say(message);
  }
  write();
});
$("part").addEventListener("change", () => choosePart($("part").value));
$("form").addEventListener("submit", (event) => event.preventDefault());
for (const id of ["model-file", "environment-file"]) {
  $(id).addEventListener("click", () => ($(id).value = "")); // or the same file again would be no change
  $(id).addEventListener("change", () => takeAll($(id).files, take));
}
acceptDrops(view, take);

let taken = Promise.resolve();

/** One after the other: what was refused is undone first. */
function take(...dropped) {
  return (taken = taken.then(() => takeOne(...dropped)));
}

async function takeOne(kind, files) {
  const [{ name }] = files;
  if (kind === "environment") {
    if (await attempt(() => view.loadEnvironmentFile(...files))) showDropped("environment", name);
    return write();
  }
  const before = [...materials];
  forgetMaterials();
  if (await attempt(() => view.loadModelFile(...files))) showDropped("src", name);
  else {
    for (const [part, material] of before) materials.set(part, material);
    view.material = materialAttribute();
  }
  listParts();
}

let pressed = null;
view.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
view.addEventListener("pointerup", async (event) => {
  if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
  const part = await view.partAtPoint(event.clientX, event.clientY);
  choosePart(part ?? "");
  say(part ? `${part} is chosen` : "all parts are chosen");
});
view.addEventListener("load", listParts);
view.addEventListener("camera-change", write);
for (const what of ["html", "command"]) {
  $(`copy-${what}`).addEventListener("click", async () => {
    await navigator.clipboard.writeText($(what).value);
    say("Copied");
  });
}
$("save").addEventListener("click", async () => {
  say("Rendering");
  try {
    const href = URL.createObjectURL(await view.toBlob());
    Object.assign(document.createElement("a"), { href, download: "view.png" }).click();
    setTimeout(() => URL.revokeObjectURL(href), 60000); // by when it is saved
    say("Saved as view.png");
  } catch (error) {
    say(error.message);
  }
});
