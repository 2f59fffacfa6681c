// What models bring along: pictures, looks to choose from, surfaces that are not ideally smooth.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open, picture } from "./browser.mjs";
import { changed, dracoFile, meshoptFile } from "./compressed.mjs";
import { gltfContents } from "../src/gltf-json.js";
import { hdrFile } from "./light.mjs";
import { glbFile, pngRow, solidFile } from "./solid.mjs";

const matt = (colour) => ({ name: "matt", pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 1, ...colour } });
const textured = solidFile(matt({ baseColorTexture: { index: 0 } }), {
  other: matt({ baseColorFactor: [0.02, 0.02, 0.9, 1] }),
  // Red on the left, green on the right; the alpha of an opaque material says nothing, and must not darken its colours.
  image: pngRow([...Array(8).fill([230, 20, 20, 10]), ...Array(8).fill([20, 230, 20, 10])]),
});
/** Two seconds to the right, or up. */
function animated() {
  const { json, binary } = gltfContents(solidFile());
  const bytes = Buffer.from(Float32Array.of(0, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0).buffer);
  json.buffers.push({ uri: `data:application/octet-stream;base64,${bytes.toString("base64")}`, byteLength: bytes.length });
  const bufferView = json.bufferViews.push({ buffer: 1, byteLength: bytes.length }) - 1;
  const input = json.accessors.push({ bufferView, componentType: 5126, type: "SCALAR", count: 2, min: [0], max: [2] }) - 1;
  json.animations = [["right", 8], ["up", 32]].map(([name, byteOffset]) => {
    const output = json.accessors.push({ bufferView, byteOffset, componentType: 5126, type: "VEC3", count: 2 }) - 1;
    return { name, samplers: [{ input, output }], channels: [{ sampler: 0, target: { node: 0, path: "translation" } }] };
  });
  return glbFile(json, binary);
}

/** Zeros from where the binary chunk begins. */
function damaged(glb) {
  return Buffer.from(glb).fill(0, 28 + glb.readUInt32LE(12));
}
/** KTX2 of RGBA floats in zstd, of which a level says that it is so long. */
function ktx2File(width, height, size) {
  const frame = Buffer.from([0x28, 0xb5, 0x2f, 0xfd, 0x20, 16, (16 << 3) | 1, 0, 0, ...Array(16).fill(0)]); // one block of 16 bytes as they are
  const bytes = Buffer.alloc(104 + frame.length);
  bytes.write("\xabKTX 20\xbb\r\n\x1a\n", "latin1");
  [109, 4, width, height, 0, 0, 1, 1, 2].forEach((value, i) => bytes.writeUInt32LE(value, 12 + 4 * i));
  [104, frame.length, size].forEach((value, i) => bytes.writeBigUInt64LE(BigInt(value), 80 + 8 * i));
  frame.copy(bytes, 104);
  return bytes;
}

/** Files that ask for far more than they hold, and what is said of them. */
function hostile(draco) {
  const primitive = (json) => json.meshes[0].primitives[0];
  return {
    "points.glb": [changed(draco, (json, stream) => { // 100 million of them, in a number of four bytes where one was
      for (const view of json.bufferViews) view.byteOffset ? (view.byteOffset += 4) : (view.byteLength += 4);
      json.buffers[0].byteLength += 4;
      return Buffer.concat([stream.subarray(0, 12), Buffer.from([0x80, 0xc2, 0xd7, 0x2f]), stream.subarray(13), Buffer.alloc(1)]);
    }), /./],
    "few.glb": [changed(draco, (json) => void (json.accessors[primitive(json).indices].count = 3)), /6 points and 24 corners in a Draco stream; its accessors announce 6 and 3$/],
    "many.glb": [changed(draco, (json) => void (json.accessors[primitive(json).attributes.POSITION].count = 1e9)), /1000000000 points and 24 corners cannot come out of \d+ bytes$/],
    "level.ktx2": [ktx2File(2, 1, 1e9), /1000000000 bytes in level 0; expected at most 32$/],
    "large.ktx2": [ktx2File(16384, 8192, 16384 * 8192 * 16), /16384 x 8192 pixels in \d+ bytes$/],
  };
}

const size = { width: 64, height: 64 };
let browser, crafted;
before(async () => {
  const compressed = { draco: await dracoFile(textured), meshopt: await meshoptFile(textured) };
  crafted = hostile(compressed.draco);
  browser = await open({
    ...Object.fromEntries(Object.entries(crafted).map(([name, [bytes]]) => [`/test/${name}`, bytes])),
    "/test/light.hdr": hdrFile(64), "/test/textured.glb": textured, "/test/broken.glb": solidFile(matt({ baseColorTexture: { index: 0 } }), { image: Buffer.from("no picture") }),
    "/test/animated.glb": animated(), "/test/draco.glb": compressed.draco, "/test/meshopt.glb": compressed.meshopt,
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

test("files that ask for far more than they hold are refused", async () => {
  const page = await show({ src: "textured.glb" });
  for (const [name, [, expected]] of Object.entries(crafted)) {
    await page.evaluate((name) => {
      window.said.length = 0;
      window.view[name.endsWith("glb") ? "src" : "environment"] = name;
    }, name);
    await page.waitForFunction(() => window.said.some(({ type }) => type === "error"));
    const { message } = await page.evaluate(() => window.said.find(({ type }) => type === "error"));
    assert.ok(message.startsWith(`${name}: `), message);
    assert.match(message, expected);
    console.log(`# ${message}`);
  }
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("animations are chosen, stand at any moment, play and pause", async () => {
  const page = await show({ src: "animated.glb", material: "gold" });
  const shown = async (change) => {
    await page.evaluate(change);
    return (await picture(page, { ...size, samples: 1 })).data;
  };
  assert.deepEqual(await page.evaluate(() => [window.view.availableAnimations, window.view.duration, window.view.paused, window.view.currentTime]), [["right", "up"], 2, true, 0]);
  const first = await shown(() => {});
  const right = await shown(() => (window.view.timeSeconds = "1"));
  assert.notDeepEqual(right, first);
  assert.match(await page.evaluate(() => window.view.command), /--time-seconds 1 /);
  await page.evaluate(() => {
    window.said.length = 0;
    window.view.animation = "up";
  });
  await page.waitForFunction(() => window.said.some(({ type }) => type === "load"));
  const up = await shown(() => {});
  assert.notDeepEqual(up, right);
  assert.notDeepEqual(await shown(() => (window.view.currentTime = 0.5)), up);
  assert.deepEqual(await shown(() => (window.view.currentTime = 1)), up, "of gold, too");
  await page.evaluate(() => window.view.play());
  await page.waitForFunction(() => window.view.currentTime > 1.2);
  await page.waitForFunction(() => window.view.currentTime < 1); // round and round
  await page.evaluate(() => window.view.pause());
  const at = await page.evaluate(() => window.view.currentTime);
  await page.evaluate(() => new Promise((resolve) => window.view.addEventListener("frame", ({ detail }) => detail.samples > 4 && resolve())));
  assert.equal(await page.evaluate(() => window.view.currentTime), at);
  assert.deepEqual(await page.evaluate(() => window.said.filter(({ type }) => type === "error")), []);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("after a lost context an animation goes on, and the view is where it was", async () => {
  const page = await show({ src: "animated.glb", material: "gold", "time-seconds": "0.5" });
  const lost = async () => {
    await page.evaluate(() => (window.said.length = 0));
    await browser.loseContexts();
    await page.waitForFunction(() => window.said.some(({ type }) => type === "load"), null, { timeout: 60000 });
  };
  await page.evaluate(() => {
    window.view.currentTime = 1.25;
    window.view.cameraOrbit = "30deg 60deg 5m";
    window.view.jumpCameraToGoal();
  });
  const before = await picture(page, { ...size, samples: 1 });
  await lost();
  assert.deepEqual((await picture(page, { ...size, samples: 1 })).data, before.data);
  assert.deepEqual(await page.evaluate(() => [window.view.paused, window.view.currentTime]), [true, 1.25]);
  await page.evaluate(() => window.view.play());
  await lost();
  assert.equal(await page.evaluate(() => window.view.paused), false);
  const at = await page.evaluate(() => window.view.currentTime);
  await page.waitForFunction((at) => window.view.currentTime !== at, at);
  await page.context().close();
});

test("autoplay plays, but not for those who ask for less motion", async () => {
  for (const reducedMotion of ["no-preference", "reduce"]) {
    const page = await show({ src: "animated.glb", autoplay: "" }, { ...size, reducedMotion });
    assert.equal(await page.evaluate(() => window.view.paused), reducedMotion === "reduce");
    if (reducedMotion === "no-preference") await page.waitForFunction(() => window.view.currentTime > 0.1);
    await page.context().close();
  }
});

test("light from one direction falls on what is not ideally smooth", async () => {
  const page = await show({ src: "textured.glb", variant: "other", "environment-intensity": "0.001", background: "none" });
  const bright = async (change) => {
    await page.evaluate(change);
    return at(await picture(page, { ...size, samples: 4 }), 24, 30);
  };
  assert.ok(Math.max(...(await bright(() => {}))) < 4);
  const white = await bright(() => (window.view.light = "0,0,1"));
  assert.ok(white[2] > 100, `${white} is lit`);
  const dim = await bright(() => (window.view.light = "0,0,2/0.25,0.25,0.25"));
  assert.ok(dim[2] > 0 && dim[2] < 0.7 * white[2], `${dim} is less than ${white}`);
  assert.deepEqual(await bright(() => (window.view.light = "0,0,-1; 0,0,1")), white, "nothing from behind");
  assert.match(await page.evaluate(() => window.view.command), / --light 0,0,-1 --light 0,0,1 /);
  assert.deepEqual(await page.evaluate(() => window.said.filter(({ type }) => type === "error")), []);
  for (const wrong of ["up", "0,0,0", "1,2", "0,0,1/1,1", "0,0,1/-1,0,0"]) {
    await page.evaluate((wrong) => {
      window.said.length = 0;
      window.view.light = wrong;
    }, wrong);
    await page.waitForFunction(() => window.said.some(({ type }) => type === "error"));
    assert.equal(await page.evaluate(() => window.said.find(({ type }) => type === "error").message), `light="${wrong}": not understood`);
  }
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("a blurred background lies behind the model alone", async () => {
  const page = await show({ src: "animated.glb", material: "gold" });
  for (const fidelity of ["single", "exact"]) {
    const shown = async (blur) => {
      await page.evaluate(([fidelity, blur]) => Object.assign(window.view, { fidelity, backgroundBlur: blur }), [fidelity, blur]);
      return picture(page, { ...size, samples: 4 });
    };
    const sharp = await shown("0");
    const blurred = await shown("1");
    assert.deepEqual(at(blurred, 32, 32), at(sharp, 32, 32));
    const contrast = (image) => [0, 1, 2].map((c) => Math.max(...Array.from({ length: 64 }, (_, x) => at(image, x, 2)[c])) - Math.min(...Array.from({ length: 64 }, (_, x) => at(image, x, 2)[c])));
    assert.ok(contrast(blurred).every((range, c) => range < 0.5 * contrast(sharp)[c]), `${fidelity}: ${contrast(blurred)} against ${contrast(sharp)}`);
  }
  assert.match(await page.evaluate(() => window.view.command), /--background-blur 1/);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
