// Threads, where the page is cross-origin isolated: they do some of the work, and the picture stays the same.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open, picture } from "./browser.mjs";
import { hdrFile } from "./light.mjs";
import { gltfContents } from "../src/gltf-json.js";
import { glbFile, solidFile } from "./solid.mjs";

const size = { width: 64, height: 64 };
const browsers = {};
before(async () => {
  const { json, binary } = gltfContents(solidFile({ name: "rough", pbrMetallicRoughness: { metallicFactor: 1, roughnessFactor: 0.4 } }));
  const files = { "/test/light.hdr": hdrFile(1024), "/test/rough.glb": glbFile(json, binary) };
  for (const isolated of [false, true]) browsers[isolated] = await open(files, { isolated });
});
after(() => Promise.all(Object.values(browsers).map((browser) => browser.close())));

/** A finished picture of an element, which of the library's modules were fetched for it, and what threads did once they have gone. */
async function shown(isolated, attributes) {
  const page = await browsers[isolated].blank();
  assert.equal(await page.evaluate(() => crossOriginIsolated), isolated);
  const modules = new Set();
  page.context().on("request", (request) => /\.wasm$/.test(request.url()) && modules.add(request.url().split("/").at(-1)));
  await page.evaluate(async ({ attributes, size }) => {
    window.view = document.createElement("tukor-view");
    for (const [name, value] of Object.entries(attributes)) window.view.setAttribute(name, value);
    window.view.style.cssText = `width:${size.width}px;height:${size.height}px`;
    document.body.append(window.view);
  }, { attributes, size });
  const { data } = await picture(page, { ...size, samples: 4 });
  const threads = () => page.workers()[0].evaluate(() => performance.getEntriesByName("tukor-thread").map(({ detail }) => detail));
  if (isolated) while ((await threads()).length === 0) await new Promise((resolve) => setTimeout(resolve, 200));
  const pieces = await threads();
  assert.deepEqual(page.errors, []);
  await page.context().close();
  return { data, modules: [...modules].sort(), pieces };
}

for (const [what, attributes, modules] of [
  ["a rough GLB", { src: "rough.glb", environment: "light.hdr", fidelity: "double" }, ["tukor", "tukor-finish"]],
  ["a built-in shape and sky", { src: "teapot", material: "glass", environment: "studio" }, ["tukor", "tukor-extras"]],
])
  test(`${what}: the same picture with threads and without`, async () => {
    const plain = await shown(false, attributes);
    const threaded = await shown(true, attributes);
    const named = (suffix) => modules.map((name) => name + suffix).sort();
    assert.deepEqual(plain.modules, named(".wasm"));
    assert.deepEqual(threaded.modules, named("-threads.wasm"));
    assert.deepEqual(plain.pieces, []);
    assert.ok(threaded.pieces.some((pieces) => pieces > 0), `${threaded.pieces} pieces were done by other threads`);
    assert.deepEqual(threaded.data, plain.data);
  });

test("an isolated page that may not start workers draws by itself, with the module for one thread", async () => {
  const page = await browsers[true].blank();
  const modules = [];
  page.context().on("request", (request) => /\.wasm$/.test(request.url()) && modules.push(request.url().split("/").at(-1)));
  await page.evaluate(() => {
    delete HTMLCanvasElement.prototype.transferControlToOffscreen;
    document.body.innerHTML = '<tukor-view src="rough.glb" environment="light.hdr"></tukor-view>';
  });
  await page.waitForFunction(() => document.querySelector("tukor-view").loaded);
  assert.ok(modules.includes("tukor.wasm") && modules.includes("tukor-finish.wasm"));
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
