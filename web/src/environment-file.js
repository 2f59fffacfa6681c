// Environment files that the browser or a lazily loaded decoder reads; the rest goes to the library as bytes.

/**
 * What the library is to be given: `bytes` to decode itself (.hdr), those of a `texture` (.ktx2 .ktx .dds), linear `radiance`
 * (three floats a pixel), or `srgb` (four bytes a pixel).
 */
export async function readEnvironment(name, bytes) {
  if (startsWith(bytes, [0x76, 0x2f, 0x31, 0x01])) return readExr(name, bytes);
  if (startsWith(bytes, [0x89, 0x50, 0x4e, 0x47]) || startsWith(bytes, [0xff, 0xd8])) return readPicture(name, bytes);
  if (startsWith(bytes, [0xab, 0x4b, 0x54, 0x58]) || startsWith(bytes, [0x44, 0x44, 0x53, 0x20])) return { texture: bytes };
  return { bytes };
}

function startsWith(bytes, magic) {
  return magic.every((value, i) => bytes[i] === value);
}

async function readPicture(name, bytes) {
  const bitmap = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: "none", premultiplyAlpha: "none" }).catch(() => {
    throw new Error(`${name}: the browser cannot decode this picture`);
  });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { srgb: new Uint8Array(context.getImageData(0, 0, width, height).data.buffer), width, height };
}

async function readExr(name, bytes) {
  const { readExr: decode } = await import("./hdrify.js"); // 30 KB, fetched only for an .exr
  let image;
  try {
    image = await decode(bytes);
  } catch (error) {
    throw new Error(`${name}: ${error.message}`);
  }
  const radiance = new Float32Array(3 * image.width * image.height);
  for (let i = 0, n = image.width * image.height; i < n; i++)
    for (let c = 0; c < 3; c++) radiance[3 * i + c] = image.data[4 * i + c];
  return { radiance, width: image.width, height: image.height };
}
