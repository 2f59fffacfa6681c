// Files of `tukor environment convert` as three.js's own loaders read them.
//
// usage: node three_loaders.mjs THREE FOLDER
// THREE: the unpacked npm package `three`. FOLDER: expected.exr, the same in half.exr and a.hdr; a cube map in half.ktx2,
// float.ktx2, zstd.ktx2, bc6h.dds and, as floats, in face_px.exr to face_nz.exr.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { register } from 'node:module';

const [three, folder] = process.argv.slice(2).map((path) => resolve(path));
const root = pathToFileURL(`${three}/`).href;
// The loaders import 'three' by name.
register('data:text/javascript,' + encodeURIComponent(`
  export const resolve = (name, context, next) =>
    name === 'three' ? { url: '${root}build/three.module.js', shortCircuit: true } : next(name, context);`));

const { DataUtils, FloatType } = await import(`${root}build/three.module.js`);
const loader = async (name) => new (await import(`${root}examples/jsm/loaders/${name}.js`))[name]();
const bytes = (name) => new Uint8Array(readFileSync(`${folder}/${name}`)).buffer;

/** Rows from the top, RGB as numbers. three.js's EXR loader gives rows from the bottom, as textures want them. */
function pixels({ data, width, height }, upsideDown) {
  const channels = data.length / (width * height);
  const value = (i) => (data instanceof Uint16Array ? DataUtils.fromHalfFloat(data[i]) : data[i]);
  const out = new Float64Array(3 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      for (let c = 0; c < 3; ++c)
        out[3 * (y * width + x) + c] = value(channels * ((upsideDown ? height - 1 - y : y) * width + x) + c);
  return out;
}

/** The largest difference over a pixel's largest channel (which is what shared exponents keep). */
function difference(found, expected) {
  if (found.length !== expected.length) throw new Error(`${found.length} values; expected ${expected.length}`);
  let worst = 0;
  for (let i = 0; i < found.length; i += 3) {
    const most = Math.max(expected[i], expected[i + 1], expected[i + 2], 1e-3);
    for (let c = 0; c < 3; ++c) worst = Math.max(worst, Math.abs(found[i + c] - expected[i + c]) / most);
  }
  return worst;
}

let failed = false;
function check(name, found, expected, limit) {
  const worst = difference(found, expected);
  console.log(`${name}: ${worst.toExponential(1)} of ${limit}`);
  failed ||= !(worst <= limit);
}

const exr = await loader('EXRLoader');
exr.setDataType(FloatType);
const readExr = (name) => pixels(exr.parse(bytes(name)), true);
const expected = readExr('expected.exr');
check('half.exr', readExr('half.exr'), expected, 2 ** -11);
const hdr = await loader('HDRLoader');
hdr.setDataType(FloatType);
// Rounded to eight bits (1 / 256), of which three.js divides the mantissa by 255 instead of 256: 257 / 255 in all.
check('a.hdr', pixels(hdr.parse(bytes('a.hdr'))), expected, 2 / 255);

// KTX2: uncompressed textures need no transcoder, so no browser. three.js 0.187 gives an uncompressed cube map as one
// flat texture whose data hold the six faces one after another.
const ktx2 = await loader('KTX2Loader');
ktx2.detectSupport({ capabilities: {}, extensions: { has: () => false, get: () => null } });
for (const [file, limit] of [['half.ktx2', 2 ** -11], ['float.ktx2', 1e-6], ['zstd.ktx2', 2 ** -11]]) {
  const { data, width, height } = (await new Promise((done, fail) => ktx2.parse(bytes(file), done, fail))).mipmaps[0];
  const length = data.length / 6;
  ['px', 'nx', 'py', 'ny', 'pz', 'nz'].forEach((face, i) => {
    const texels = data.subarray(i * length, (i + 1) * length);
    check(`${file} ${face}`, pixels({ data: texels, width, height }), readExr(`face_${face}.exr`), limit);
  });
}

// BC6H: DDSLoader hands on the blocks of a cube map as they lie in the file, face by face with all levels.
const { RGB_BPTC_UNSIGNED_Format } = await import(`${root}build/three.module.js`);
const dds = (await loader('DDSLoader')).parse(bytes('bc6h.dds'), true);
const blocks = Buffer.concat(dds.mipmaps.map(({ data }) => data));
const whole = dds.format === RGB_BPTC_UNSIGNED_Format && dds.isCubemap && dds.mipmaps.length === 6 * dds.mipmapCount &&
  blocks.equals(Buffer.from(bytes('bc6h.dds')).subarray(148));
console.log(`bc6h.dds: ${whole ? 'its blocks' : 'something else'}`);
failed ||= !whole;
if (failed) process.exit(1);
