// Pictures on models, decoded by the browser; on its own so that only pages with some fetch it.
import { fileOf, ofDataUri, viewBytes } from "./gltf-buffers.js";
import { imagesOf } from "./gltf-json.js";

const LARGEST = 4096; // texels a side: beyond, more memory than a phone's tab should be asked for

function encodedBytes(image, contents, files) {
  if (typeof image?.uri === "string") return ofDataUri(image.uri) ?? fileOf(image.uri, files);
  return viewBytes(contents.json.bufferViews?.[image?.bufferView], contents, files);
}

async function bitmapOf(bytes) {
  const options = { colorSpaceConversion: "none", premultiplyAlpha: "none" };
  const bitmap = await createImageBitmap(new Blob([bytes]), options);
  const scale = LARGEST / Math.max(bitmap.width, bitmap.height);
  if (scale >= 1) return bitmap;
  const size = { resizeWidth: Math.max(1, Math.round(scale * bitmap.width)), resizeHeight: Math.max(1, Math.round(scale * bitmap.height)), resizeQuality: "high" };
  return createImageBitmap(bitmap, { ...options, ...size });
}

/** Its texels, read back from WebGL: a 2D canvas would multiply them by their alpha. */
function texelsOf(gl, bitmap) {
  const { width, height } = bitmap;
  const texture = gl.createTexture();
  const framebuffer = gl.createFramebuffer();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const texels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(framebuffer);
  gl.deleteTexture(texture);
  bitmap.close();
  return { texels, width, height };
}

/** Calls `give(index, texels, width, height)` for every image that can be decoded. */
export async function decodeImages(gl, contents, files, give) {
  for (const [index, image] of imagesOf(contents).entries()) {
    try {
      const bytes = encodedBytes(image, contents, files);
      if (!bytes) continue; // the library says that it is left out
      const { texels, width, height } = texelsOf(gl, await bitmapOf(bytes));
      give(index, texels, width, height);
    } catch (error) {
      if (error.name !== "InvalidStateError" && error.name !== "InvalidCharacterError") throw error; // not a picture
    }
  }
}
