// The example page and the editor, and what a page has to fetch.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { brotliCompressSync } from "node:zlib";
import { open } from "./browser.mjs";
import { hdrFile } from "./light.mjs";
import { solidFile } from "./solid.mjs";

const files = { "/test/light.hdr": hdrFile(256), "/test/solid.glb": solidFile(), "/test/junk": Buffer.from("junk"),
                "/test/ball.obj": Buffer.from("mtllib ball.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"), "/test/ball.mtl": Buffer.from("newmtl red\nKd 1 0 0\n") };
let browser;
before(async () => (browser = await open(files, { isolated: true }))); // as `./demo web` serves it
after(() => browser.close());

async function audit(page) {
  await page.evaluate(await readFile(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8"));
  const { violations } = await page.evaluate(() => window.axe.run());
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
}

async function visit(path) {
  const page = await browser.blank({ deviceScaleFactor: 0.25 }); // SwiftShader draws it
  await page.goto(`${browser.origin}${path}`);
  await page.waitForFunction(() => document.querySelector("tukor-view").loaded, null, { timeout: 120000 });
  return page;
}

for (const path of ["/", "/editor.html"])
  test(`${path} loads without an error, and axe-core finds nothing`, async () => {
    const page = await visit(path);
    assert.deepEqual(await audit(page), []);
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

/** Drops files of the server's on an element, as a person does: pairs of a URL and a name. */
function drop(page, selector, ...files) {
  return page.evaluate(async ([selector, files]) => {
    const data = new DataTransfer();
    for (const [url, name] of files) data.items.add(new File([await (await fetch(url)).arrayBuffer()], name));
    document.querySelector(selector).dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [selector, files]);
}

test("a picture of the example page takes a dropped model and a dropped environment", async () => {
  const page = await visit("/");
  await drop(page, "#gold", ["test/solid.glb", "mine.glb"]);
  await drop(page, "#gold", ["test/light.hdr", "mine.hdr"]);
  await page.waitForFunction(() => / mine\.glb .*--environment mine\.hdr/.test(document.querySelector("#gold").command), null, { timeout: 60000 });
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("the editor takes a dropped environment and writes HTML and command", async () => {
  const page = await visit("/editor.html");
  await drop(page, "tukor-view", ["test/light.hdr", "dropped.hdr"]);
  await page.waitForFunction(() => document.querySelector("tukor-view").command.includes("--environment dropped.hdr"));
  await page.selectOption("#part", "water");
  await page.fill("#material", "ice");
  await page.locator("#material").blur();
  assert.equal(await page.getAttribute("tukor-view", "material"), "water=ice");
  await page.selectOption("#ground", "lowest");
  await page.fill("#dispersion", "1.5");
  assert.match(await page.inputValue("#html"), /<tukor-view src="tumbler".* material="water=ice".* dispersion="1.5" ground="lowest"/);
  assert.match(await page.inputValue("#command"), / --ground lowest --dispersion 1.5 /);
  await page.selectOption("#ground", "");
  assert.equal(await page.getAttribute("tukor-view", "ground"), null);
  assert.match(await page.inputValue("#command"), /^tukor render tumbler --material 'water=ice'|^tukor render tumbler --material water=ice/);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

const notice = (page, text) => page.waitForFunction((text) => document.querySelector("#notice").textContent.includes(text), text);
const choices = (page, list) => page.evaluate((list) => [...document.querySelectorAll(`${list} option`)].map(({ value }) => value), list);

test("the editor's lists are the library's", async () => {
  const page = await visit("/editor.html");
  assert.equal(await page.inputValue("#tone-map"), "neutral");
  const shapes = await choices(page, "#src");
  await page.fill("#material", "unobtainium");
  await page.locator("#material").blur();
  await notice(page, `known are ${(await choices(page, "#materials")).join(", ")}; or figures`);
  await page.evaluate(() => (document.querySelector("tukor-view").src = "cone"));
  await notice(page, `expected a file or one of ${shapes.join(", ")}`);
  assert.equal(shapes.length, 8);
  await page.context().close();
});

test("the editor writes dropped files and no refused material, and forgets notices and materials", async () => {
  const page = await visit("/editor.html");
  await page.selectOption("#fidelity", "single"); // which is quick
  await page.fill("#material", "gold");
  await page.locator("#material").blur();
  await page.fill("#material", "glod");
  await page.locator("#material").blur();
  await notice(page, "did you mean 'gold'?");
  assert.match(await page.inputValue("#html"), / material="gold"/);
  assert.match(await page.inputValue("#command"), / --material gold /);
  await drop(page, "tukor-view", ["test/junk", "junk.glb"]);
  await notice(page, "junk.glb: ");
  await page.waitForFunction(() => document.querySelector("#html").value.includes('<tukor-view src="tumbler" environment="studio" material="gold"'));
  await drop(page, "tukor-view", ["test/solid.glb", "mine.glb"], ["test/light.hdr", "mine.hdr"]);
  await page.waitForFunction(() => /^[^]*<tukor-view src="mine.glb" environment="mine.hdr" fidelity="single" camera-orbit=.* alt="mine" style="[^"]*height:/.test(document.querySelector("#html").value));
  await page.waitForFunction(() => /^tukor render mine.glb --environment mine.hdr /.test(document.querySelector("#command").value));
  assert.deepEqual(await page.evaluate(() => ["notice", "material", "src"].map((id) => document.getElementById(id).value ?? document.getElementById(id).textContent)), ["", "", ""]);
  await page.selectOption("#src", "tumbler");
  await page.waitForFunction(() => document.querySelector("#command").value.startsWith("tukor render tumbler --environment mine.hdr "));
  assert.deepEqual(await choices(page, "#src [value='']"), []);
  await page.context().close();
});

test("files dropped together are a model with those that it names; its textures are no environments", async () => {
  const page = await visit("/editor.html");
  await drop(page, "tukor-view", ["test/junk", "red.png"], ["test/ball.mtl", "ball.mtl"], ["test/ball.obj", "ball.obj"]);
  await page.waitForFunction(() => document.querySelector("#command").value.startsWith("tukor render ball.obj --environment studio "));
  assert.equal(await page.textContent("#notice"), "");
  assert.deepEqual(await page.evaluate(() => document.querySelector("tukor-view").warnings()), []);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("the editor saves the picture, and keeps it in sight on narrow screens", async () => {
  const page = await visit("/editor.html");
  await page.selectOption("#fidelity", "single");
  await page.setViewportSize({ width: 360, height: 640 });
  const saved = page.waitForEvent("download");
  await page.click("#save");
  assert.equal((await saved).suggestedFilename(), "view.png");
  await page.locator("#environment-rotation").scrollIntoViewIfNeeded();
  assert.ok(await page.evaluate(() => scrollY > 0 && document.querySelector("tukor-view").getBoundingClientRect().top >= 0 && document.documentElement.scrollWidth <= 360));
  await page.fill("#exposure", "1.5");
  assert.equal(await page.textContent("label:has(#exposure) span"), "1.5");
  await page.context().close();
});

test("in the editor a click on a part chooses it, and HTML and command can be copied", async () => {
  const page = await visit("/editor.html");
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.selectOption("#environment", "sky");
  const box = await page.locator("tukor-view").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForFunction(() => document.querySelector("#part").value === "glass");
  await page.fill("#material", "flint-glass");
  await page.locator("#material").blur();
  assert.equal(await page.getAttribute("tukor-view", "material"), "glass=flint-glass");
  await page.waitForFunction(() => /sky.*flint-glass/.test(document.querySelector("#html").value) && document.querySelector("#command").value.includes("sky"));
  for (const [what, expected] of [["html", /<tukor-view src="tumbler" environment="sky" material="glass=flint-glass"[^>]* alt="tumbler"[^>]*camera-controls><\/tukor-view>/], ["command", /^tukor render tumbler --material glass=flint-glass --environment sky /]]) {
    await page.click(`#copy-${what}`);
    await page.waitForFunction(() => document.querySelector("#notice").textContent === "Copied");
    await page.evaluate(() => (document.querySelector("#notice").textContent = ""));
    assert.match(await page.evaluate(() => navigator.clipboard.readText()), expected);
  }
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test("the package's README names every attribute and every built-in shape", async () => {
  const readme = await readFile(new URL("../README.md", import.meta.url), "utf8");
  const page = await browser.blank();
  for (const name of await page.evaluate(() => customElements.get("tukor-view").observedAttributes)) assert.ok(readme.includes(`\`${name}\``), name);
  await page.goto(`${browser.origin}/editor.html`);
  assert.ok(readme.includes(`or ${(await choices(page, "#src")).join(", ")} |`));
  await page.context().close();
});

test("all that a page fetches for a GLB with an .hdr is at most 130 KB, compressed", async () => {
  const plain = await open(files);
  const page = await plain.blank();
  const fetched = new Set();
  page.context().on("request", (request) => /\/dist\//.test(request.url()) && fetched.add(new URL(request.url()).pathname));
  await page.reload();
  await page.evaluate(() => {
    document.body.innerHTML = '<tukor-view src="solid.glb" environment="light.hdr" fidelity="single"></tukor-view>';
  });
  await page.waitForFunction(() => document.querySelector("tukor-view").loaded, null, { timeout: 60000 });
  let bytes = 0;
  for (const path of fetched) bytes += brotliCompressSync(await readFile(new URL(`..${path}`, import.meta.url))).length;
  console.log(`# ${[...fetched].join(" ")}: ${(bytes / 1000).toFixed(1)} KB`);
  for (const part of ["tukor-view.js", "tukor-worker.js", "tukor.wasm"]) assert.ok(fetched.has(`/dist/${part}`), `${part} was fetched`);
  assert.ok(!fetched.has("/dist/tukor-extras.wasm"));
  assert.ok(bytes <= 130000, `${bytes} bytes`);
  assert.deepEqual(page.errors, []);
  await plain.close();
});
