// The page's picture of a sphere at rest against its closed form.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open, picture } from "./browser.mjs";
import { distanceBetween, hdrFile, spherePicture } from "./light.mjs";

const size = { width: 64, height: 48 }; // SwiftShader draws it
const camera = { distance: 4, fov: (40 * Math.PI) / 180 };
const samples = { single: 64, exact: 16 };

let browser;
before(async () => (browser = await open({ "/test/light.hdr": hdrFile(512) })));
after(() => browser.close());

const gold = { eta: [0.21, 0.485, 1.29], k: [3.13, 2.23, 1.76] };
const silver = { eta: [0.15, 0.14, 0.13], k: [3.7, 3.11, 2.47] };
const cases = [
  ["gold", "exact", gold],
  ["silver", "single", silver],
  ["glass", "single", { ior: 1.46, single: true }],
  ["glass", "exact", { ior: 1.46 }],
  ["water", "exact", { ior: 1.333 }],
  ["ior:2.42", "exact", { ior: 2.42 }],
];
for (const [material, fidelity, truth] of cases)
  test(`a sphere of ${material} at level ${fidelity} is within 1.0 of its closed form`, async () => {
    const page = await browser.element(
      { src: "sphere", material, fidelity, environment: "light.hdr", "tone-map": "none", "camera-orbit": "0deg 90deg 4m", "camera-target": "0m 0m 0m" }, size);
    const shown = await picture(page, { ...size, samples: samples[fidelity] });
    const distance = distanceBetween(shown.data, spherePicture(truth, { ...size, ...camera }));
    assert.deepEqual(page.errors, []);
    assert.ok(distance < 1.0, `distance ${distance}`);
    console.log(`# ${material} ${fidelity}: ${distance.toFixed(2)}`);
    await page.context().close();
  });
