#!/usr/bin/env node
// What threads give where the page is cross-origin isolated: light of a 4096x2048 panorama, and reading a large model with its BVH.
//
// usage: bench/web/threads.mjs [ROUNDS]     after: tools/web_build.sh; medians of five rounds unless told otherwise
import { open } from "../../web/test/browser.mjs";
import { hdrFile } from "../../web/test/light.mjs";
import { glb, knot } from "./models.mjs";

const rounds = Number(process.argv[2] ?? 5);
const gilt = (roughnessFactor) => ({ pbrMetallicRoughness: { metallicFactor: 1, roughnessFactor } });
const files = { "/test/light.hdr": hdrFile(4096), "/test/small.hdr": hdrFile(64), "/test/large.glb": glb(knot(5000, 100), gilt(0)), "/test/small.glb": glb(knot(64, 16), gilt(0.5)) };
const runs = {
  "reading .hdr, 4096x2048": [{ src: "small.glb", environment: "light.hdr" }, "environment"],
  "filtering it for rough surfaces, and the first frame": [{ src: "small.glb", environment: "light.hdr" }, "frame"],
  "reading a GLB of 1 000 000 triangles, with its BVH": [{ src: "large.glb", environment: "small.hdr" }, "model"],
};

/** Seconds from an element's first question of a kind until its worker's answer. */
async function seconds(browser, attributes, act) {
  const page = await browser.blank();
  const taken = await page.evaluate(async ({ attributes, act }) => {
    const { postMessage } = Worker.prototype;
    const taken = new Promise((resolve) => {
      Worker.prototype.postMessage = function (data, transfer) {
        if (data.act === act) {
          const begun = performance.now();
          this.addEventListener("message", ({ data: { id } }) => id === data.id && resolve((performance.now() - begun) / 1000));
        }
        return postMessage.call(this, data, transfer);
      };
    });
    const view = document.createElement("tukor-view");
    for (const [name, value] of Object.entries(attributes)) view.setAttribute(name, value);
    view.style.cssText = "width: 32px; height: 24px";
    document.body.append(view);
    return taken;
  }, { attributes, act });
  await page.context().close();
  return taken;
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const browsers = await Promise.all([false, true].map((isolated) => open(files, { isolated })));
console.log("| seconds | one thread | threads |\n|---|---|---|");
for (const [what, run] of Object.entries(runs)) {
  const found = [[], []];
  for (let round = 0; round < rounds; round++) for (const [i, browser] of browsers.entries()) found[i].push(await seconds(browser, ...run));
  console.log(`| ${what} | ${found.map((values) => median(values).toFixed(2)).join(" | ")} |`);
}
await Promise.all(browsers.map((browser) => browser.close()));
