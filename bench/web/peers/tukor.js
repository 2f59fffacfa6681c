// <tukor-view>, at the level that the options name.
import "../../../web/dist/tukor-view.js";
import { fetched, run } from "../page.js";

run(async (host, { model, environment, material, fidelity, fov, distance, samples }) => {
  const view = document.createElement("tukor-view");
  const attributes = { src: model, environment, material, fidelity, "tone-map": "none", "camera-orbit": `0rad 90deg ${distance}m`, "camera-target": "0m 0m 0m", "field-of-view": `${fov}rad` };
  for (const [name, value] of Object.entries(attributes)) view.setAttribute(name, value);
  view.style.cssText = "display:block;width:100%;height:100%";
  const failure = new Promise((_, reject) => view.addEventListener("error", ({ detail }) => reject(new Error(detail.message)), { once: true }));
  const rested = (wanted) => Promise.race([failure, new Promise((resolve) => view.addEventListener("frame", function hear() {
    if (view.accumulatedSamples < wanted) return;
    view.removeEventListener("frame", hear);
    resolve();
  }))]);
  host.append(view);
  await rested(1); // not the coarse one before it
  return {
    async frame() { // one more sample of every pixel: while the view moves, the resolution would be what the time allows
      await rested(view.accumulatedSamples + 1);
    },
    async light(bytes) {
      await view.loadEnvironmentFile(new File([bytes], "light.hdr"));
      await rested(1);
    },
    rest: () => rested(samples),
  };
});
