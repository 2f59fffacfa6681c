// The page's pictures against the program's, `tukor render --renderer gl`, with the very command that the page gives.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { open, picture } from "./browser.mjs";
import { hdrFile } from "./light.mjs";

const program = process.env.TUKOR ?? fileURLToPath(new URL("../../build/release/apps/tukor/tukor", import.meta.url));
const size = { width: 96, height: 72 }; // SwiftShader draws it
const samples = 4;

let browser, folder;
before(async () => {
  const light = hdrFile(256);
  const served = { "/test/light.hdr": light };
  browser = await open(served);
  folder = await mkdtemp(join(tmpdir(), "tukor-"));
  await writeFile(join(folder, "light.hdr"), light);
  for (const kind of ["none", "zstd"]) {
    await promisify(execFile)(program, ["environment", "convert", "light.hdr", "-o", `${kind}.ktx2`, "--compression", kind], { cwd: folder });
    served[`/test/${kind}.ktx2`] = await readFile(join(folder, `${kind}.ktx2`));
  }
});
after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

/** The program's picture, decoded by the page: bytes, four a pixel. */
async function decoded(page, png) {
  const text = await page.evaluate(async (png) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (c) => c.charCodeAt(0))]), { colorSpaceConversion: "none", premultiplyAlpha: "none" });
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    return btoa(String.fromCharCode(...context.getImageData(0, 0, bitmap.width, bitmap.height).data));
  }, png.toString("base64"));
  return Buffer.from(text, "base64");
}

for (const [src, material, environment, more = {}] of [["torus-knot", "glass", "light.hdr"], ["brilliant", "diamond", "light.hdr"], ["brilliant", "diamond", "light.hdr", { dispersion: "1" }], ["sphere", "glass", "light.hdr", { ground: "lowest" }], ["tumbler", null, "studio"], ["sphere", "gold", "none.ktx2"], ["sphere", "gold", "zstd.ktx2"]])
  test(`${src} in ${environment}${Object.keys(more).map((name) => ` with ${name}`)} looks as \`tukor render --renderer gl\` draws it`, async () => {
    const attributes = { src, environment, "max-depth": "8", "tone-map": "none", fidelity: "exact" };
    if (material) attributes.material = material;
    Object.assign(attributes, more);
    const page = await browser.element(attributes, size);
    const shown = await picture(page, { ...size, samples });
    const bare = await (async () => {
      await page.evaluate(() => (window.view.background = "none"));
      return picture(page, { ...size, samples: 1 });
    })();
    await page.evaluate(() => window.view.removeAttribute("background"));
    const words = (await page.evaluate(() => window.view.command)).split(" ").slice(1);
    const png = join(folder, `${src}.png`);
    words[words.indexOf("-o") + 1] = png;
    words[words.indexOf("--size") + 1] = `${size.width}x${size.height}`;
    await promisify(execFile)(program, [...words, "--renderer", "gl", "--samples", String(samples)], { cwd: folder });
    const truth = await decoded(page, await readFile(png));
    let object = 0, near = 0;
    for (let i = 0; i < truth.length; i += 4) {
      if (!more.ground && bare.data[i + 3] === 0) continue; // what stands on ground changes all of it
      object++;
      if ([0, 1, 2].every((c) => Math.abs(shown.data[i + c] - truth[i + c]) <= 2)) near++;
    }
    console.log(`# ${src} in ${environment}: ${((100 * near) / object).toFixed(2)} % of ${object} pixels`);
    assert.ok(object > 1000);
    for (const name of Object.keys(more)) {
      await page.evaluate((name) => window.view.removeAttribute(name), name);
      const plain = await picture(page, { ...size, samples });
      assert.notDeepEqual(plain.data, shown.data);
    }
    assert.ok(near >= 0.99 * object, `${near} of ${object} pixels are within 2/255`);
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
