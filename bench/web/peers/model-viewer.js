// <model-viewer>, as shipped; the renderer behind it is reached to wait for the GPU, and its resolution held.
import { ModelViewerElement } from "@google/model-viewer/dist/model-viewer.min.js";
import { finished, run } from "../page.js";

run(async (host, { model, environment, fov, distance }) => {
  ModelViewerElement.minimumRenderScale = 1;
  const view = document.createElement("model-viewer");
  const orbit = (angle) => `${angle}rad 90deg ${distance}m`;
  const attributes = {
    src: model, "environment-image": environment, "skybox-image": environment, "tone-mapping": "linear", "shadow-intensity": 0, "camera-controls": "",
    "interaction-prompt": "none", "camera-orbit": orbit(0), "camera-target": "0m 0m 0m", "field-of-view": `${fov}rad`,
    "min-camera-orbit": "-Infinity 0deg 0m", "max-camera-orbit": "Infinity 180deg 100m", "min-field-of-view": "1deg", "max-field-of-view": "90deg",
  };
  for (const [name, value] of Object.entries(attributes)) view.setAttribute(name, value);
  view.style.cssText = "display:block;width:100%;height:100%";
  const event = (type) => new Promise((resolve, reject) => {
    view.addEventListener(type, resolve, { once: true });
    view.addEventListener("error", ({ detail }) => reject(new Error(`${detail.type}: ${detail.sourceError ?? ""}`)), { once: true });
  });
  const ready = Promise.all([event("load"), event("environment-change")]);
  host.append(view);
  await ready;
  const symbol = Object.getOwnPropertySymbols(Object.getPrototypeOf(Object.getPrototypeOf(view))).concat(allSymbols(view)).find(({ description }) => description === "renderer");
  const { threeRenderer } = view[symbol];
  const drawn = async () => {
    const before = threeRenderer.info.render.frame;
    while (threeRenderer.info.render.frame === before) await new Promise(requestAnimationFrame);
    finished(threeRenderer.getContext());
  };
  view.jumpCameraToGoal();
  let angle = 0;
  const frame = async (at) => {
    view.cameraOrbit = orbit((angle = at));
    await view.updateComplete;
    view.jumpCameraToGoal();
    await drawn();
  };
  await frame(1e-4);
  return {
    frame,
    async light(bytes) {
      const url = URL.createObjectURL(new Blob([bytes])) + "#light.hdr";
      const changed = event("environment-change");
      view.environmentImage = view.skyboxImage = url;
      await changed;
      await frame(angle + 1e-4);
    },
    async rest() {
      await frame(0);
      await new Promise((resolve) => setTimeout(resolve, 1000)); // it fades the poster
    },
  };
});

function allSymbols(object) {
  const found = [];
  for (let at = object; at; at = Object.getPrototypeOf(at)) found.push(...Object.getOwnPropertySymbols(at));
  return found;
}
