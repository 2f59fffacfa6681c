// Mouse, touch and keyboard on the picture, turned into moves of an OrbitCamera.

const TURN = Math.PI; // rad for a drag over the picture's height
const KEY_TURN = Math.PI / 16;
const KEY_ZOOM = 1.15;

/** Listens on `canvas` until `signal` aborts; `moved()` is called after every change of the camera's goal. */
export function listen(canvas, camera, moved, signal) {
  const pointers = new Map();
  const on = (type, handler, options = {}) => canvas.addEventListener(type, handler, { ...options, signal });

  on("pointerdown", (event) => {
    if (event.pointerType === "mouse" && event.button > 2) return;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  const lift = (event) => pointers.delete(event.pointerId);
  on("pointerup", lift);
  on("pointercancel", lift);
  on("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const height = canvas.clientHeight || 1;
    const before = spread(pointers);
    const dx = (event.clientX - last.x) / height;
    const dy = (event.clientY - last.y) / height;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) {
      const panning = event.pointerType === "mouse" && ((event.buttons & 6) !== 0 || event.shiftKey || event.ctrlKey);
      if (panning) camera.pan(-dx, dy);
      else camera.rotate(-dx * TURN, -dy * TURN);
    } else if (pointers.size === 2) {
      const after = spread(pointers);
      if (before > 0 && after > 0) camera.zoom(before / after);
      camera.pan(-dx / 2, dy / 2); // each finger carries half of the pair's motion
    }
    moved();
  });
  on("contextmenu", (event) => event.preventDefault());
  on("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
    camera.zoom(Math.exp(0.0015 * lines * event.deltaY));
    moved();
  }, { passive: false });
  on("keydown", (event) => {
    if (event.altKey || event.metaKey) return;
    const shift = event.shiftKey;
    const act = {
      ArrowLeft: () => (shift ? camera.pan(-0.05, 0) : camera.rotate(-KEY_TURN, 0)),
      ArrowRight: () => (shift ? camera.pan(0.05, 0) : camera.rotate(KEY_TURN, 0)),
      ArrowUp: () => (shift ? camera.pan(0, 0.05) : camera.rotate(0, -KEY_TURN)),
      ArrowDown: () => (shift ? camera.pan(0, -0.05) : camera.rotate(0, KEY_TURN)),
      PageUp: () => camera.zoom(1 / KEY_ZOOM),
      PageDown: () => camera.zoom(KEY_ZOOM),
      "+": () => camera.zoom(1 / KEY_ZOOM),
      "=": () => camera.zoom(1 / KEY_ZOOM),
      "-": () => camera.zoom(KEY_ZOOM),
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
    moved();
  });
}

function spread(pointers) {
  if (pointers.size !== 2) return 0;
  const [a, b] = pointers.values();
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** The view in words, for screen readers, after model-viewer's custom. */
export function spokenView(theta, phi) {
  const quarter = ["front", "right", "back", "left"][Math.round((((theta % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI)) / (Math.PI / 2)) % 4];
  const height = phi < Math.PI / 4 ? "upper-" : phi > (3 * Math.PI) / 4 ? "lower-" : "";
  return `View from stage ${height}${quarter}`;
}
