// The editor page: the form steers the element, the element's state is written out as HTML and as a command.
import { acceptDrops, takeAll } from "./drops.js";

const $ = (id) => document.getElementById(id);
const view = $("view");
const materials = new Map(); // part name ("" for all) -> material

function materialAttribute() {
  return [...materials].filter(([, name]) => name).map(([part, name]) => (part ? `${part}=${name}` : name)).join("; ");
}

function write() {
  const { theta, phi, radius } = view.getCameraOrbit();
  const { x, y, z } = view.getCameraTarget();
  const degrees = (radians) => `${+((radians * 180) / Math.PI).toFixed(2)}deg`;
  const attributes = {
    src: view.src, environment: view.environment, material: materialAttribute() || null, fidelity: view.fidelity, exposure: view.exposure,
    "tone-map": view.toneMap, dispersion: view.dispersion, ground: view.ground, "environment-rotation": view.environmentRotation,
    "camera-orbit": `${degrees(theta)} ${degrees(phi)} ${+radius.toFixed(4)}m`, "camera-target": `${[x, y, z].map((v) => `${+v.toFixed(4)}m`).join(" ")}`,
  };
  const quoted = Object.entries(attributes).filter(([, value]) => value !== null && value !== "")
    .map(([name, value]) => `${name}="${String(value).replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"`);
  $("html").value = `<script type="module" src="tukor-view.js"></` + `script>\n<tukor-view ${quoted.join(" ")} camera-controls></tukor-view>`;
  $("command").value = view.command;
}

function listParts() {
  const chosen = $("part").value;
  $("part").replaceChildren(new Option("all parts", ""), ...view.parts.map(({ name }) => new Option(name, name)));
  $("part").value = view.parts.some(({ name }) => name === chosen) ? chosen : "";
  write();
}

function bind(id, attribute, type = "change") {
  $(id).addEventListener(type, () => {
    if ($(id).value) view.setAttribute(attribute, attribute === "environment-rotation" ? `${$(id).value}deg` : $(id).value);
    else view.removeAttribute(attribute);
    write();
  });
}
bind("src", "src");
bind("environment", "environment");
bind("fidelity", "fidelity");
bind("exposure", "exposure", "input");
bind("tone-map", "tone-map");
bind("dispersion", "dispersion", "input");
bind("ground", "ground");
bind("environment-rotation", "environment-rotation", "input");
$("src").addEventListener("change", () => { materials.clear(); view.removeAttribute("material"); });
$("material").addEventListener("change", () => {
  materials.set($("part").value, $("material").value.trim());
  view.material = materialAttribute();
  write();
});
$("part").addEventListener("change", () => ($("material").value = materials.get($("part").value) ?? ""));
$("form").addEventListener("submit", (event) => event.preventDefault());
$("model-file").addEventListener("change", (event) => takeAll(event.target.files, take));
$("environment-file").addEventListener("change", (event) => takeAll(event.target.files, take));
acceptDrops(view, take);

function take(file, kind) {
  if (kind === "environment") view.loadEnvironmentFile(file).then(write);
  else {
    materials.clear();
    view.removeAttribute("material");
    view.loadModelFile(file).then(listParts);
  }
}

let pressed = null;
view.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
view.addEventListener("pointerup", async (event) => {
  if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
  const part = await view.partAtPoint(event.clientX, event.clientY);
  $("part").value = part ?? "";
  $("material").value = materials.get($("part").value) ?? "";
  $("notice").textContent = part ? `${part} is chosen` : "all parts are chosen";
});
view.addEventListener("load", listParts);
view.addEventListener("camera-change", write);
view.addEventListener("error", (event) => ($("notice").textContent = event.detail.message));
for (const what of ["html", "command"]) {
  $(`copy-${what}`).addEventListener("click", async () => {
    await navigator.clipboard.writeText($(what).value);
    $("notice").textContent = "Copied";
  });
}
