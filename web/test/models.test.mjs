// What models bring along: pictures, looks to choose from, surfaces that are not ideally smooth.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open, picture } from "./browser.mjs";
import { dracoFile, meshoptFile } from "./compressed.mjs";
import { hdrFile } from "./light.mjs";
import { pngRow, solidFile } from "./solid.mjs";

const matt = (colour) => ({ name: "matt", pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 1, ...colour } });
const textured = solidFile(matt({ baseColorTexture: { index: 0 } }), {
  other: matt({ baseColorFactor: [0.02, 0.02, 0.9, 1] }),
  // Red on the left, green on the right; the alpha of an opaque material says nothing, and must not darken its colours.
  image: pngRow([...Array(8).fill([230, 20, 20, 10]), ...Array(8).fill([20, 230, 20, 10])]),
});
/** Zeros from where the binary chunk begins. */
function damaged(glb) {
  return Buffer.from(glb).fill(0, 28 + glb.readUInt32LE(12));
}
const size = { width: 64, height: 64 };
let browser;
before(async () => {
  const compressed = { draco: await dracoFile(textured), meshopt: await meshoptFile(textured) };
  browser = await open({
    "/test/light.hdr": hdrFile(64), "/test/textured.glb": textured, "/test/broken.glb": solidFile(matt({ baseColorTexture: { index: 0 } }), { image: Buffer.from("no picture") }),
    "/test/draco.glb": compressed.draco, "/test/meshopt.glb": compressed.meshopt,
    "/test/damaged-draco.glb": damaged(compressed.draco), "/test/damaged-meshopt.glb": damaged(compressed.meshopt),
  });
});
after(() => browser.close());

const show = (attributes, options = size) => browser.element({ environment: "light.hdr", fidelity: "single", "tone-map": "none", "camera-orbit": "0deg 90deg 4m", "camera-target": "0m 0m 0m", ...attributes }, options);
const at = ({ width, data }, x, y) => [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];

test("pictures in a GLB lie on its surfaces; variants and fidelities act live", async () => {
  const page = await show({ src: "textured.glb" });
  const red = ([r, g, b]) => r > 100 && r > 2 * g && r > 2 * b;
  const green = ([r, g, b]) => g > 100 && g > 2 * r && g > 2 * b;
  const blue = ([r, g, b]) => b > 100 && b > 2 * r && b > 2 * g;
  for (const fidelity of ["single", "exact"]) {
    await page.evaluate((fidelity) => (window.view.fidelity = fidelity), fidelity);
    const shown = await picture(page, { ...size, samples: 4 });
    assert.ok(red(at(shown, 24, 30)), `${fidelity}: ${at(shown, 24, 30)} on the left is red`);
    assert.ok(green(at(shown, 40, 30)), `${fidelity}: ${at(shown, 40, 30)} on the right is green`);
  }
  const orbit = () => page.evaluate(() => (window.view.jumpCameraToGoal(), window.view.getCameraOrbit().toString()));
  const before = await orbit();
  await page.evaluate(() => {
    window.said.length = 0;
    window.view.variant = "other";
  });
  await page.waitForFunction(() => window.said.some(({ type }) => type === "load"));
  const other = await picture(page, { ...size, samples: 4 });
  assert.ok(blue(at(other, 24, 30)) && blue(at(other, 40, 30)), `${at(other, 24, 30)} is blue`);
  assert.equal(await orbit(), before);
  assert.match(await page.evaluate(() => window.view.command), /--variant other/);
  await page.evaluate(() => (window.view.variant = "none of these"));
  await page.waitForFunction(() => window.said.some(({ type }) => type === "error"));
  assert.match(await page.evaluate(() => window.said.find(({ type }) => type === "error").message), /no variant 'none of these'; there are other/);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("a picture that cannot be decoded is left out, and said", async () => {
  const page = await show({ src: "broken.glb" });
  assert.match((await page.evaluate(() => window.view.warnings())).join(), /textures that the browser cannot decode, left out/);
  assert.deepEqual(await page.evaluate(() => window.said.filter(({ type }) => type === "error")), []);
  await page.context().close();
});

for (const kind of ["draco", "meshopt"])
  test(`a model compressed by ${kind} gives the picture of the plain one, and a damaged one is said`, async () => {
    const page = await show({ src: "textured.glb" });
    const plain = await picture(page, { ...size, samples: 4 });
    await page.evaluate((kind) => {
      window.said.length = 0;
      window.view.src = `${kind}.glb`;
    }, kind);
    await page.waitForFunction(() => window.said.some(({ type }) => type === "load"));
    const shown = await picture(page, { ...size, samples: 4 });
    assert.deepEqual(shown.data, plain.data);
    assert.deepEqual(await page.evaluate(() => window.said.filter(({ type }) => type === "error")), []);
    await page.evaluate((kind) => (window.view.src = `damaged-${kind}.glb`), kind);
    await page.waitForFunction(() => window.said.some(({ type }) => type === "error"));
    assert.match(await page.evaluate(() => window.said.find(({ type }) => type === "error").message), new RegExp(`^damaged-${kind}\\.glb: compressed data that cannot be read: .`));
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
