// What every peer's page does: show the model under the light, and keep what the driver asks for.
//
// A peer's `show(host, options)` resolves once a whole picture of model and environment is drawn, to
//   frame(radians)   draws a picture from so far around, at full resolution, and waits for the GPU
//   light(bytes)     takes another environment and waits until it is shown
//   rest()           waits for the picture at rest, where a peer refines it
const options = JSON.parse(decodeURIComponent(location.hash.slice(1)));
const host = document.querySelector("#host");
host.style.cssText = `width:${options.width}px;height:${options.height}px`;

/** Waits until the GPU has done all that it was told. */
export function finished(gl) {
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

export function fetched(url) {
  return fetch(url).then((response) => response.arrayBuffer()).then((buffer) => new Uint8Array(buffer));
}

export function canvasIn(host, { width, height }) {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  canvas.style.cssText = "display:block;width:100%;height:100%";
  host.append(canvas);
  return canvas;
}

export function run(show) {
  window.shown = show(host, options).then((peer) => {
    const milliseconds = performance.now(); // since the page was asked for
    window.peer = peer;
    return milliseconds;
  });
}
