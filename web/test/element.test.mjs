// The element as a page sees it: attributes, events, methods, controls, and what happens when things go wrong.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open, picture } from "./browser.mjs";
import { hdrFile } from "./light.mjs";
import { solidFile } from "./solid.mjs";

const truncated = hdrFile(64).subarray(0, 3000);
let browser;
before(async () => (browser = await open({ "/test/light.hdr": hdrFile(64), "/test/solid.glb": solidFile(), "/test/truncated.hdr": truncated, "/test/cut.ktx2": Buffer.from("\xabKTX 20\xbb\r\n\x1a\n", "latin1"), "/test/empty.glb": Buffer.alloc(0), "/test/wrong.glb": Buffer.from("not a model at all") })));
after(() => browser.close());

const small = { width: 96, height: 64 };
const gem = { src: "solid.glb", material: "gold", environment: "light.hdr", fidelity: "single" };

async function element(attributes, options = {}) {
  const page = await browser.element({ ...gem, ...attributes }, { ...small, ...options });
  page.said = (type) => page.evaluate((type) => window.said.filter((event) => event.type === type), type);
  return page;
}

test("says progress up to 1, then load, once, and no error", async () => {
  const page = await element({});
  const said = await page.evaluate(() => window.said.map(({ type, totalProgress }) => [type, totalProgress]));
  const progress = said.filter(([type]) => type === "progress").map(([, fraction]) => fraction);
  assert.deepEqual(progress, [...progress].sort((a, b) => a - b));
  assert.equal(progress.at(-1), 1);
  assert.equal(said.filter(([type]) => type === "load").length, 1);
  assert.equal(said.filter(([type]) => type === "error").length, 0);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("attributes and properties act live", async () => {
  const page = await element({});
  const first = await picture(page, { ...small, samples: 1 });
  const differs = async (change) => {
    await page.evaluate(change);
    const next = await picture(page, { ...small, samples: 1 });
    assert.notDeepEqual(next.data, first.data, String(change));
    assert.deepEqual(await page.said("error"), [], String(change));
  };
  await differs(() => (window.view.material = "silver"));
  await differs(() => window.view.setAttribute("exposure", "-1"));
  await differs(() => (window.view.cameraOrbit = "40deg 60deg auto"));
  await differs(() => (window.view.environmentRotation = "90deg"));
  await differs(() => (window.view.environmentIntensity = "0.5"));
  await differs(() => (window.view.toneMap = "agx"));
  await differs(() => (window.view.fieldOfView = "60deg"));
  await differs(() => (window.view.backgroundBlur = "0.8"));
  await page.evaluate(() => {
    for (const name of ["exposure", "camera-orbit", "environment-rotation", "environment-intensity", "tone-map", "field-of-view", "background-blur"]) window.view.removeAttribute(name);
    window.view.material = "gold";
    window.view.jumpCameraToGoal();
  });
  const again = await picture(page, { ...small, samples: 1 });
  assert.deepEqual(again.data, first.data, "removing the attributes gives the first picture back");
  await page.context().close();
});

test("what is not understood is said, and the picture stays", async () => {
  const page = await element({});
  const message = async (change) => {
    await page.evaluate(() => (window.said.length = 0));
    await page.evaluate(change);
    await page.waitForFunction(() => window.said.some(({ type }) => type === "error"));
    return (await page.said("error"))[0].message;
  };
  assert.match(await message(() => (window.view.material = "unobtainium")), /unobtainium/);
  assert.match(await message(() => (window.view.fidelity = "best")), /^fidelity: .*'best'|best/);
  assert.equal(await message(() => (window.view.exposure = "bright")), 'exposure="bright": not understood');
  assert.match(await message(() => (window.view.cameraOrbit = "left")), /^camera-orbit="left": expected three values/);
  assert.match(await message(() => (window.view.cameraOrbit = "0deg 90deg 0m")), /^camera-orbit="0deg 90deg 0m": expected three values/);
  assert.equal(await message(() => (window.view.src = "missing.glb")), "missing.glb: 404 Not Found");
  assert.equal(await message(() => (window.view.src = "cone")), "cone: no such model; expected a file or one of sphere, torus-knot, teapot, brilliant, tumbler, water, wine-glass, cube");
  assert.equal(await message(() => (window.view.src = "empty.glb")), "empty.glb: an empty file");
  assert.match(await message(() => (window.view.src = "wrong.glb")), /^wrong\.glb: /);
  assert.match(await message(() => (window.view.environment = "truncated.hdr")), /^truncated\.hdr: /);
  assert.match(await message(() => (window.view.environment = "cut.ktx2")), /^cut\.ktx2: /);
  assert.match(await message(() => (window.view.environment = "moon")), /^moon: no such environment; built in are studio, sky/);
  const still = await picture(page, { ...small, samples: 1 });
  assert.equal(still.width, small.width);
  await page.context().close();
});

const alert = (page) => page.evaluate(() => {
  const { hidden, textContent } = window.view.shadowRoot.querySelector("[role=alert]");
  return hidden ? "" : textContent;
});
const says = (page, expected) => page.waitForFunction((expected) => {
  const { hidden, textContent } = window.view.shadowRoot.querySelector("[role=alert]");
  return (hidden ? "" : textContent) === expected;
}, expected);

test("a message stays until what it is about is corrected", async () => {
  const page = await element({ exposure: "abc", "camera-orbit": "0deg 90deg 0m", material: "nosuch=gold" }, { wait: false });
  await page.waitForFunction(() => window.view.loaded && window.said.filter(({ type }) => type === "error").length >= 3);
  await page.evaluate(() => (window.view.environmentIntensity = "2")); // succeeds, and hides none of them
  await page.evaluate(() => window.view.render({ width: 8, height: 8, samples: 1 }));
  const lines = (await alert(page)).split("\n");
  assert.deepEqual(lines.map((line) => /exposure="abc"|camera-orbit="0deg 90deg 0m"|nosuch/.exec(line)?.[0]).sort(), ['camera-orbit="0deg 90deg 0m"', 'exposure="abc"', "nosuch"]);
  await page.evaluate(() => {
    window.view.material = "gold";
    window.view.cameraOrbit = "0deg 90deg 3m";
  });
  await says(page, 'exposure="abc": not understood');
  await page.evaluate(() => window.view.removeAttribute("exposure"));
  await says(page, "");
  await page.evaluate(() => {
    window.view.environmentRotation = "left";
    window.view.environmentIntensity = "3";
    window.view.environmentRotation = "10deg";
  });
  await says(page, "");
  await page.context().close();
});

test("where an environment cannot be had the model is shown in the studio, and the message stays", async () => {
  for (const environment of ["missing.hdr", "moon"]) {
    const page = await element({ environment }, { wait: false });
    await page.waitForFunction(() => window.view.loaded, null, { timeout: 60000 });
    assert.match(await alert(page), new RegExp(`^${environment}: `));
    assert.equal(await page.evaluate(() => window.view.shadowRoot.querySelector("progress").hidden), true);
    assert.match(await page.evaluate(() => window.view.command), / --environment studio /);
    await page.evaluate(() => (window.view.environment = ""));
    await says(page, "");
    await page.context().close();
  }
});

test("a dropped .gltf or .obj finds what it names among the files dropped with it", async () => {
  const page = await element({});
  const drop = (...files) => page.evaluate((files) => window.view.loadModelFile(...files.map(([name, text]) => new File([text], name))), files);
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  const gltf = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, name: "corner" }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    buffers: [{ uri: "below/of%20it.bin", byteLength: 36 }], bufferViews: [{ buffer: 0, byteLength: 36 }], accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] }] };
  await page.evaluate(([gltf, positions]) => window.view.loadModelFile(new File([gltf], "set.gltf"), new File(["no"], "other.txt"), new File([new Float32Array(positions)], "of it.bin")), [JSON.stringify(gltf), positions]);
  assert.deepEqual(await page.evaluate(() => window.view.parts.map(({ name }) => name)), ["corner"]);
  await page.evaluate(() => (window.view.material = null));
  await drop(["set.obj", "mtllib set.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"], ["set.mtl", "newmtl red\nKd 1 0 0\n"]);
  const parts = await page.evaluate(() => window.view.parts);
  assert.equal(parts.length, 1);
  assert.deepEqual(await page.evaluate(() => window.view.warnings()), []);
  assert.deepEqual(await page.said("error"), []);
  await page.context().close();
});

test("render rejects where loading failed, until something loads", async () => {
  const page = await element({ src: "missing.glb" });
  const rendered = () => page.evaluate(() => window.view.render({ width: 8, height: 8, samples: 1 }).then(({ width }) => width, (error) => error.message));
  assert.equal(await rendered(), "missing.glb: 404 Not Found");
  await page.evaluate(() => (window.view.exposure = "1"));
  assert.equal(await rendered(), "missing.glb: 404 Not Found");
  await page.evaluate(() => (window.view.src = "solid.glb"));
  assert.equal(await rendered(), 8);
  await page.context().close();
});

test("parts have names, materials go to them, points of the picture find them", async () => {
  const page = await element({ src: "tumbler", material: "water=gold" });
  assert.deepEqual(await page.evaluate(() => window.view.parts.map(({ name }) => name)), ["glass", "water"]);
  const box = await page.evaluate(() => window.view.getBoundingClientRect().toJSON());
  assert.equal(await page.evaluate(({ x, y, width, height }) => window.view.partAtPoint(x + width / 2, y + height / 2), box), "glass");
  assert.equal(await page.evaluate(({ x, y }) => window.view.partAtPoint(x + 1, y + 1), box), null);
  await page.context().close();
});

test("the command names model, light and view", async () => {
  const page = await element({ material: "*=gold; *=silver", "camera-orbit": "0deg 90deg 4m", "camera-target": "0m 0m 0m", exposure: "1" });
  assert.equal(await page.evaluate(() => window.view.command),
    "tukor render solid.glb --material '*=gold' --material '*=silver' --environment light.hdr --fidelity single --exposure 1 --eye 0,0,4 --target 0,0,0 --fov 40 --size 96x64 -o view.png");
  await page.context().close();
});

test("toBlob gives a PNG of any size", async () => {
  const page = await element({});
  const signature = await page.evaluate(async () => {
    const blob = await window.view.toBlob({ width: 50, height: 40, samples: 1 });
    const bitmap = await createImageBitmap(blob);
    return [blob.type, bitmap.width, bitmap.height, (await window.view.toDataURL("image/jpeg")).slice(0, 23)];
  });
  assert.deepEqual(signature, ["image/png", 50, 40, "data:image/jpeg;base64,"]);
  await page.context().close();
});

test("mouse, wheel and keys move the camera, and only with camera-controls", async () => {
  const page = await element({ "camera-controls": "" });
  const orbit = () => page.evaluate(() => (window.view.jumpCameraToGoal(), { ...window.view.getCameraOrbit() }));
  const before = await orbit();
  await page.mouse.move(40, 30);
  await page.mouse.down();
  await page.mouse.move(70, 30, { steps: 3 });
  await page.mouse.up();
  const dragged = await orbit();
  assert.ok(dragged.theta < before.theta - 0.5, "a drag to the right turns the model to the right");
  await page.mouse.wheel(0, 200);
  const zoomed = await orbit();
  assert.ok(zoomed.radius > before.radius * 1.2);
  await page.keyboard.press("ArrowUp");
  assert.ok((await orbit()).phi < zoomed.phi - 0.1);
  await page.waitForFunction(() => window.view.shadowRoot.querySelector("[role=status]").textContent.startsWith("View from stage"));
  assert.equal(await page.evaluate(() => window.view.shadowRoot.querySelector("canvas").getAttribute("role")), "application");
  assert.ok((await page.said("camera-change")).length > 0);
  const { phi } = await orbit();
  for (const key of ["Control+ArrowUp", "Control+-"]) await page.keyboard.press(key);
  assert.equal((await orbit()).phi, phi, "keys with Ctrl are the browser's");
  await page.keyboard.press("Home");
  assert.deepEqual(await orbit(), before);
  await page.mouse.wheel(0, 200);
  await page.mouse.dblclick(40, 30);
  assert.deepEqual(await orbit(), before);
  await page.evaluate(() => (window.view.cameraControls = false));
  const fixed = await orbit();
  await page.mouse.move(40, 30);
  await page.mouse.down();
  await page.mouse.move(70, 30);
  await page.mouse.up();
  assert.deepEqual(await orbit(), fixed);
  await page.context().close();
});

test("one finger turns, two pinch and move", async () => {
  const page = await element({ "camera-controls": "" }, { hasTouch: true });
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const orbit = () => page.evaluate(() => (window.view.jumpCameraToGoal(), { ...window.view.getCameraOrbit() }));
  const before = await orbit();
  await touch("touchStart", [30, 40]);
  await touch("touchMove", [60, 40]);
  await touch("touchEnd");
  const turned = await orbit();
  assert.ok(turned.theta < before.theta - 0.5);
  await touch("touchStart", [40, 40], [50, 40]);
  await touch("touchMove", [30, 40], [70, 40]);
  await touch("touchEnd");
  const pinched = await orbit();
  assert.ok(pinched.radius < 0.5 * turned.radius, "spreading four times as wide comes four times closer");
  const target = () => page.evaluate(() => (window.view.jumpCameraToGoal(), { ...window.view.getCameraTarget() }));
  const before2 = await target();
  await touch("touchStart", [30, 40], [50, 40]);
  await touch("touchMove", [30, 20], [50, 20]);
  await touch("touchEnd");
  const after2 = await target();
  assert.ok(after2.y < before2.y - 0.01, "two fingers carry the model up");
  const still = await orbit();
  assert.ok(Math.abs(still.radius / pinched.radius - 1) < 0.2 && Math.abs(still.theta - pinched.theta) < 1e-6, "without turning it");
  await page.context().close();
});

test("one finger scrolls the page up and down, and turns the model from a move aside on", async () => {
  const page = await element({ "camera-controls": "" }, { hasTouch: true });
  await page.evaluate(() => (document.body.style.height = "3000px"));
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const drag = async (dx, dy) => {
    await touch("touchStart", [50, 60]);
    for (let i = 1; i <= 4; i++) await touch("touchMove", [50 + i * dx, 60 + i * dy]);
    await touch("touchEnd");
  };
  const state = () => page.evaluate(() => (window.view.jumpCameraToGoal(), { ...window.view.getCameraOrbit(), scrolled: scrollY }));
  const before = await state();
  await drag(1, -10);
  await page.waitForFunction(() => scrollY > 10);
  assert.deepEqual({ ...(await state()), scrolled: 0 }, before);
  await new Promise((resolve) => setTimeout(resolve, 500)); // it rolls on a little
  await page.evaluate(() => scrollTo(0, 0));
  await drag(10, 1);
  const turned = await state();
  assert.equal(turned.scrolled, 0);
  assert.ok(turned.theta < before.theta - 0.3);
  await page.context().close();
});

test("auto-rotate turns the model, not for those who ask for less motion, and the camera then jumps", async () => {
  for (const reducedMotion of ["no-preference", "reduce"]) {
    const page = await element({ "auto-rotate": "" }, { reducedMotion });
    const theta = () => page.evaluate(() => window.view.getCameraOrbit().theta);
    const before = await theta();
    if (reducedMotion === "no-preference") await page.waitForFunction((before) => window.view.getCameraOrbit().theta > before + 0.02, before);
    else {
      await new Promise((resolve) => setTimeout(resolve, 500));
      assert.equal(await theta(), before);
      await page.evaluate(() => new Promise((resolve) => {
        window.view.addEventListener("frame", ({ detail }) => detail.moving && resolve()); // a frame at rest may still be under way
        window.view.cameraOrbit = "80deg 90deg auto";
      }));
      assert.ok(Math.abs((await theta()) - (80 * Math.PI) / 180) < 1e-6, "in one frame");
    }
    await page.context().close();
  }
});

test("several elements live on a page; those off-screen sleep until they are scrolled to", async () => {
  const page = await element({});
  await page.evaluate(({ gem, small }) => {
    for (let i = 0; i < 3; i++) {
      const view = document.createElement("tukor-view");
      for (const [name, value] of Object.entries(gem)) view.setAttribute(name, value);
      view.style.cssText = `width:${small.width}px;height:${small.height}px;${i === 2 ? "margin-top:5000px" : ""}`;
      document.body.append(view);
    }
  }, { gem, small });
  const loaded = () => page.evaluate(() => [...document.querySelectorAll("tukor-view")].map((view) => view.loaded));
  await page.waitForFunction(() => [...document.querySelectorAll("tukor-view")].slice(0, 3).every((view) => view.loaded));
  assert.deepEqual(await loaded(), [true, true, true, false]);
  await page.evaluate(() => document.querySelectorAll("tukor-view")[3].scrollIntoView());
  await page.waitForFunction(() => document.querySelectorAll("tukor-view")[3].loaded);
  // The others draw no more.
  await new Promise((resolve) => setTimeout(resolve, 1500));
  const before = await page.evaluate(() => {
    window.frames = 0;
    window.view.addEventListener("frame", () => window.frames++);
    window.view.exposure = "1";
    return window.frames;
  });
  await new Promise((resolve) => setTimeout(resolve, 500));
  assert.equal(await page.evaluate(() => window.frames), before);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("a poster stays until it is dismissed where the model is revealed by hand", async () => {
  const page = await element({ reveal: "manual", poster: "data:image/png;base64,iVBORw0KGgo=" }, { wait: false });
  const poster = () => page.evaluate(() => window.view.shadowRoot.querySelector(".poster").hidden);
  await new Promise((resolve) => setTimeout(resolve, 500));
  assert.deepEqual([await poster(), await page.evaluate(() => window.view.loaded)], [false, false]);
  await page.evaluate(() => window.view.dismissPoster());
  await page.waitForFunction(() => window.view.loaded);
  assert.equal(await poster(), true);
  await page.context().close();
});

test("a lost context comes back with the same picture, whatever was refused after it", async () => {
  const pages = [await element({}), await element({ src: "missing.glb" }), await element({})]; // one loss: browsers stand few
  const [, file, named] = pages;
  const load = (name, bytes) => file.evaluate(([name, bytes]) => window.view.loadModelFile(new File([new Uint8Array(bytes)], name)), [name, [...bytes]]);
  await load("junk.glb", Buffer.from("junk"));
  await load("good.glb", solidFile());
  await file.waitForFunction(() => window.view.loaded);
  await load("junk.glb", Buffer.from("junk"));
  assert.match(await alert(file), /^junk\.glb: /);
  await named.evaluate(() => {
    window.view.src = "missing.glb";
    window.view.environment = "moon";
  });
  await named.waitForFunction(() => window.said.filter(({ type }) => type === "error").length === 2);
  const before = [];
  for (const page of pages) {
    before.push(await picture(page, { ...small, samples: 1 }));
    await page.evaluate(() => (window.said.length = 0));
  }
  await browser.loseContexts();
  for (const [i, page] of pages.entries()) {
    await page.bringToFront();
    await page.waitForFunction(() => window.said.some(({ type }) => type === "load"), null, { timeout: 60000 });
    assert.deepEqual((await picture(page, { ...small, samples: 1 })).data, before[i].data);
    if (page !== named) assert.deepEqual(await page.said("error"), []);
  }
  assert.match(await file.evaluate(() => window.view.command), /^tukor render good\.glb /);
  for (const page of pages) await page.context().close();
});

test("elements can be taken off the page and put back, many times", async () => {
  const page = await element({});
  for (let i = 0; i < 17; i++) // more contexts than a browser keeps
    await page.evaluate(async () => {
      window.view.remove();
      window.said.length = 0;
      document.body.append(window.view);
      await new Promise((resolve, reject) => {
        window.view.addEventListener("load", resolve, { once: true });
        window.view.addEventListener("error", (event) => reject(new Error(event.detail.message)), { once: true });
      });
    });
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("without WebGL 2 it says so", async () => {
  const bare = await open({ "/test/light.hdr": hdrFile(64), "/test/solid.glb": solidFile() }, { flags: ["--disable-gpu", "--disable-software-rasterizer"] });
  const page = await bare.element(gem, small);
  assert.deepEqual((await page.evaluate(() => window.said.filter(({ type }) => type === "error"))).map(({ message }) => message), ["WebGL 2 is not available in this browser"]);
  assert.equal(await page.evaluate(() => window.view.shadowRoot.querySelector("[role=alert]").textContent), "WebGL 2 is not available in this browser");
  await bare.close();
});

test("where no worker can draw, the page does it itself: the same picture", async () => {
  const page = await element({});
  const drawn = await picture(page, { ...small, samples: 2 });
  await page.context().close();
  const plain = await browser.blank();
  await plain.evaluate(async ({ gem, small }) => {
    delete HTMLCanvasElement.prototype.transferControlToOffscreen;
    window.view = document.createElement("tukor-view");
    for (const [name, value] of Object.entries(gem)) window.view.setAttribute(name, value);
    window.view.style.cssText = `width:${small.width}px;height:${small.height}px`;
    document.body.append(window.view);
  }, { gem, small });
  const own = await picture(plain, { ...small, samples: 2 });
  assert.deepEqual(plain.workers(), []);
  assert.deepEqual(own.data, drawn.data);
  assert.deepEqual(plain.errors, []);
  await plain.context().close();
});
