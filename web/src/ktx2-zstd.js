// .ktx2 files in zstd, made plain: fzstd (MIT); on its own so that only such a file fetches it.
import { decompress } from "fzstd";

const WIDTH = 20, HEIGHT = 24, FACES = 36, LEVELS = 40, SCHEME = 44, INDEX = 80; // where they stand in the file, and how much a level takes there:
const ENTRY = 24; // offset, stored size, size
const TEXEL = 16; // bytes of the largest
const TRUSTED = 2 ** 23, MOST = 2 ** 28, PER_BYTE = 2 ** 12; // pixels, as src/tukor/image bounds them

/** How many bytes a level may have, from the picture's size; throws where a file of so many bytes cannot hold the picture. */
function mostBytes(view) {
  const [width, height, faces] = [WIDTH, HEIGHT, FACES].map((at) => view.getUint32(at, true));
  const pixels = width * height * faces;
  if (pixels > MOST || (pixels > TRUSTED && pixels > PER_BYTE * view.byteLength)) throw new Error(`${width} x ${height} pixels in ${view.byteLength} bytes`);
  return (level) => TEXEL * Math.max(1, width >>> level) * Math.max(1, height >>> level) * faces;
}

/** The same file without supercompression; what is damaged beyond that is for the library to tell. */
export function expanded(name, bytes) {
  try {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const most = mostBytes(view);
    const levels = Array.from({ length: Math.max(1, view.getUint32(LEVELS, true)) }, (_, i) => {
      const [offset, stored, size] = [0, 8, 16].map((at) => Number(view.getBigUint64(INDEX + ENTRY * i + at, true)));
      if (i > 31 || size > most(i)) throw new Error(`${size} bytes in level ${i}; expected at most ${most(i)}`);
      return decompress(bytes.subarray(offset, offset + stored), new Uint8Array(size));
    });
    const out = new Uint8Array(bytes.length + levels.reduce((sum, level) => sum + level.length, 0));
    out.set(bytes); // the levels as they were stay where they are, unused
    const index = new DataView(out.buffer);
    index.setUint32(SCHEME, 0, true);
    let at = bytes.length;
    levels.forEach((level, i) => {
      [at, level.length, level.length].forEach((value, j) => index.setBigUint64(INDEX + ENTRY * i + 8 * j, BigInt(value), true));
      out.set(level, at);
      at += level.length;
    });
    return out;
  } catch (error) {
    throw new Error(`${name}: damaged KTX2 file: ${error.message}`);
  }
}
