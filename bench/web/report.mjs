// The table of compare.mjs as a page of docs/.
import { writeFile } from "node:fs/promises";
import { createRequire } from "node:module";

const version = (name) => createRequire(import.meta.url)(`./node_modules/${name}/package.json`).version;
const seconds = (milliseconds) => (milliseconds / 1000).toFixed(1);
const whole = (number) => number.toFixed(0);

/** Key of a result, what stands above it, how it is written; less is better in each. */
const COLUMNS = [
  ["first gold", "first picture, gold, s", seconds],
  ["first glass", "glass, s", seconds],
  ["light", "another environment, ms", whole],
  ["frame gold", "a frame, gold, ms", whole],
  ["frame glass", "glass, ms", whole],
  ["bytes", "code, KB", (bytes) => whole(bytes / 1000)],
  ["distance gold", "distance, gold", (x) => x.toFixed(2)],
  ["distance glass", "glass", (x) => x.toFixed(2)],
];

const FILTERED = "Filament's light was filtered by cmgen beforehand, which is not counted; preparing it on the page takes us more than the difference (the column of another environment).";
/** Why a peer may be ahead in a column; written where one is. */
const REASONS = {
  "first gold": FILTERED,
  "first glass": FILTERED,
  light: "Filament reads cube maps that cmgen filtered beforehand, which the other rows do on the page.",
  "frame gold": "We gather floats over frames and map them to the screen in a second pass; peers write the screen's bytes at once.",
};

const SETTINGS = {
  "tukor-view": "`tone-map=\"none\"`; materials by name (`gold`, `glass`), so that gold has its complex index; 16 samples a pixel at rest. A frame is one more sample of every pixel at rest: "
    + "while the view moves, a controller would lower the resolution of frames that take longer than 33 ms.",
  three: "`WebGLRenderer`, no tone map; GLTFLoader, HDRLoader with floats, PMREM by the renderer; bundled and shaken by esbuild.",
  "@google/model-viewer": "its shipped module; `tone-mapping=\"linear\"`, no shadow, `minimumRenderScale` 1.",
  filament: "gltfio's materials, linear tone map; no shadow.",
  "@babylonjs/core": "`HDRCubeTexture` of 512 texels, supersampled and not prefiltered: prefiltering takes 45 s on SwiftShader, and smooth surfaces do not need it; bundled by esbuild.",
};

const isOurs = ({ name }) => name.startsWith("tukor-view");
const isNumber = (value) => typeof value === "number";

function row(result, best) {
  if (result.failure) return `| ${result.name} | did not run: ${result.failure} |${" |".repeat(COLUMNS.length - 1)}`;
  return `| ${result.name} | ${COLUMNS.map(([key, , text]) => (!isNumber(result[key]) ? "" : result[key] === best[key] ? `**${text(result[key])}**` : text(result[key]))).join(" | ")} |`;
}

/** For each column in which a peer is ahead of both of our levels: which, and why. */
function behind(results) {
  return COLUMNS.flatMap(([key, title]) => {
    const figures = (wanted) => results.filter((result) => wanted(result) && isNumber(result[key]));
    const own = Math.min(...figures(isOurs).map((result) => result[key]));
    const ahead = figures((result) => !isOurs(result)).filter((result) => result[key] < own).map(({ name }) => name);
    return ahead.length === 0 ? [] : [`- **${key}** (${title}): ${ahead.join(", ")} ahead. ${REASONS[key] ?? "Not explained yet."}`];
  });
}

export async function write(path, results, { width, height, rounds, cmgen, once, browser }) {
  const best = Object.fromEntries(COLUMNS.map(([key]) => [key, Math.min(...results.map((result) => result[key]).filter(isNumber))]));
  const late = behind(results);
  await writeFile(path, `# Beside other viewers in the browser

\`bench/web/compare.mjs --rounds ${rounds}${once ? " --once" : ""}\`: ${browser}, headless, WebGL by SwiftShader on 2 cores without a GPU, ${width}x${height}. Medians; less is better, the best of a column is bold.

| | ${COLUMNS.map(([, title]) => title).join(" | ")} |
|---|${"---|".repeat(COLUMNS.length)}
${results.map((result) => row(result, best)).join("\n")}

- **First picture**: a torus knot of 61,440 triangles as GLB in a .hdr of 1024x512, in a browser just started, from asking for the page until the GPU has drawn the first whole picture.
  For us that is the first at full resolution; a coarse one comes before it.
- **Another environment**: from the bytes of the .hdr until the GPU has drawn the next whole picture. Filament cannot read .hdr here: cmgen took ${seconds(cmgen)} s beforehand.
- **A frame**: of the knot, at full resolution, until the GPU is done. ${once ? "Multisampling is off, but for model-viewer, where it cannot be." : "Peers draw outlines with four samples, as they are used; we draw one sample a pixel and gather them over frames."}
- **Code**: all scripts and WebAssembly that the page fetched, each by brotli.
- **Distance**: RMSE in codes of 8-bit sRGB between what is on the screen at rest and the closed form of a sphere; of glass, with every reflection inside. At level \`single\` glass is the
  lecture's one interface, which is another thing than a solid ball: 0.4 from its own closed form (\`./test web\`). Gold of glTF is its reflectance at normal incidence; where that is all
  that a viewer knows, the distance counts it.

## Where we are not ahead
${late.length > 0 ? late.join("\n") : "Nowhere in this run."}

## Settings
${Object.entries(SETTINGS).map(([name, text]) => `- ${name}${name === "tukor-view" ? "" : ` ${version(name)}`}: ${text}`).join("\n")}
`);
}
