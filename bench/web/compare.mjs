#!/usr/bin/env node
// <tukor-view> beside three, model-viewer, Filament and Babylon.js in headless Chromium (SwiftShader): writes docs/bench-web.md.
//
// usage: bench/web/compare.mjs [--only PEER] [--once] [--rounds N]     after: tools/web_build.sh
//   --only   one of them, into build/bench-web
//   --once   times of one sample a pixel, without the multisampling that peers are used with; into build/bench-web
// needs: tools/install_packages.sh bench web; the peers themselves are fetched into bench/web/node_modules on the first run
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { distanceBetween, hdrFile, spherePicture } from "../../web/test/light.mjs";
import { glass, glb, gold, knot, sphere } from "./models.mjs";
import { write } from "./report.mjs";
import { Workshop } from "./workshop.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const root = join(here, "../..");
const folder = join(root, "build/bench-web");
const { only, once, rounds } = parseArgs({ options: { only: { type: "string" }, once: { type: "boolean", default: false }, rounds: { type: "string", default: "3" } } }).values;

const size = { width: 320, height: 240 };
const camera = { distance: 4, fov: (40 * Math.PI) / 180 };
const truths = { gold: { eta: [0.21, 0.485, 1.29], k: [3.13, 2.23, 1.76] }, glass: { ior: 1.46 } };
const ours = { script: "tukor", samples: 16 };
/** `turn`: by how many degrees to the left a peer wants panoramas rolled whose middle is -Z. */
const peers = {
  "tukor-view, single": { ...ours, fidelity: "single" },
  "tukor-view, exact": { ...ours, fidelity: "exact" },
  three: { script: "three", turn: 90 },
  "model-viewer": { script: "model-viewer", turn: 90 },
  Filament: { script: "filament", turn: 180 },
  "Babylon.js": { script: "babylon" },
};

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

/** A flat .hdr with its columns moved to the left. */
function rolled(hdr, width, degrees) {
  const header = hdr.length - 2 * width * width; // four bytes a pixel
  const row = 4 * width, step = (row * degrees) / 360;
  const out = Buffer.from(hdr);
  for (let at = header; at < hdr.length; at += row)
    for (let i = 0; i < row; i++) out[at + i] = hdr[at + ((i + step) % row)];
  return out;
}

/** The shapes in both materials, the light, and the light as Filament takes it. */
async function prepare() {
  if (!existsSync(join(here, "node_modules"))) execFileSync("npm", ["ci", "--no-audit", "--no-fund", "--ignore-scripts", "--loglevel=error"], { cwd: here, stdio: "inherit" });
  await mkdir(folder, { recursive: true });
  const files = {};
  for (const turn of new Set(Object.values(peers).map(({ turn = 0 }) => turn))) files[`/light-${turn}.hdr`] = rolled(hdrFile(1024), 1024, turn);
  const light = join(folder, "light.hdr");
  await writeFile(light, files[`/light-${peers.Filament.turn}.hdr`]);
  const begun = performance.now();
  execFileSync("cmgen", ["-q", "--format=ktx", "--size=256", `--deploy=${join(folder, "cmgen")}`, light]);
  const cmgen = performance.now() - begun;
  for (const part of ["ibl", "skybox"]) files[`/${part}.ktx`] = await readFile(join(folder, `cmgen/cmgen_${part}.ktx`));
  for (const [shape, mesh] of [["sphere", sphere()], ["knot", knot()]])
    for (const [name, material] of [["gold", gold(truths.gold)], ["glass", glass(truths.glass.ior, shape === "sphere" ? 2 : 0.4)]]) files[`/${shape}-${name}.glb`] = glb(mesh, material);
  return { files, cmgen };
}

async function measure(workshop, peer, round, result) {
  const options = (shape, material) => ({ model: `/${shape}-${material}.glb`, material, environment: `/light-${peer.turn ?? 0}.hdr`, filtered: ["/ibl.ktx", "/skybox.ktx"], multisampled: shape === "sphere" || !once, ...size, ...camera, ...peer });
  for (const material of ["gold", "glass"]) {
    const page = await workshop.page(peer.script, options("knot", material));
    (result[`first ${material}`] ??= []).push(await page.first());
    if (peer.fidelity !== "exact") {
      if (material === "gold") (result.light ??= []).push(...(await page.lights(options().environment, 3)));
      (result[`frame ${material}`] ??= []).push(median(await page.frames(16)));
    }
    await page.picture(join(folder, `${result.name}-knot-${material}.png`));
    result.bytes = await page.bytes();
    await page.close();
    if (round > 0) continue;
    const still = await workshop.page(peer.script, options("sphere", material));
    await still.first();
    const truth = spherePicture(truths[material], { ...size, ...camera, grid: 4 });
    const distance = async (moment) => distanceBetween(await still.picture(join(folder, `${result.name}-sphere-${material}-${moment}.png`)), truth);
    result[`begins ${material}`] = await distance("first");
    await still.rest();
    result[`distance ${material}`] = await distance("rest");
    await still.close();
  }
}

const { files, cmgen } = await prepare();
const results = [];
const workshop = await Workshop.open({ here, root, folder, files });
try {
  for (let round = 0; round < Number(rounds); round++)
    for (const [name, peer] of Object.entries(peers)) {
      if (only && !name.startsWith(only)) continue;
      let result = results.find((other) => other.name === name);
      if (!result) results.push((result = { name }));
      if (result.failure) continue;
      await measure(workshop, peer, round, result).catch((error) => (result.failure = error.message.split("\n")[0]));
      console.log(JSON.stringify(result));
    }
} finally {
  await workshop.close();
}
for (const result of results) for (const [key, value] of Object.entries(result)) if (Array.isArray(value)) result[key] = median(value);
await write(only || once ? join(folder, "bench-web.md") : join(root, "docs/bench-web.md"), results, { ...size, rounds, cmgen, once, browser: workshop.version });
