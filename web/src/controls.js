// Mouse, touch and keyboard on the picture, turned into moves of an OrbitCamera.

const TURN = Math.PI; // rad for a drag over the picture's height
const KEY_TURN = Math.PI / 16;
const KEY_ZOOM = 1.15;
const KEYS = { // right, up, back
  ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0], Home: [0, 0, 0], // as double-click
  PageUp: [0, 0, -1], "+": [0, 0, -1], "=": [0, 0, -1], PageDown: [0, 0, 1], "-": [0, 0, 1],
};

/** Listens on `canvas` until `signal` aborts; `moved(home)` is called after every change of the camera's goal, which `home` asks to be as at first. */
export function listen(canvas, camera, moved, signal) {
  const pointers = new Map();
  const on = (type, handler, options = {}) => canvas.addEventListener(type, handler, { ...options, signal });

  on("pointerdown", (event) => {
    if (event.button > 2) return;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    pointers.set(event.pointerId, event);
  });
  const lift = (event) => pointers.delete(event.pointerId);
  on("lostpointercapture", lift);
  on("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const height = canvas.clientHeight || 1;
    const before = spread(pointers);
    const dx = (event.clientX - last.clientX) / height;
    const dy = (event.clientY - last.clientY) / height;
    pointers.set(event.pointerId, event);
    if (pointers.size === 1) {
      const touches = event.pointerType === "touch";
      if (touches && last.type === "pointerdown" && Math.abs(dy) > Math.abs(dx)) return lift(event); // it scrolls the page
      if (!touches && (event.buttons & 6 || event.shiftKey || event.ctrlKey)) camera.pan(-dx, dy);
      else camera.rotate(-dx * TURN, -dy * TURN);
    } else if (pointers.size === 2) {
      const after = spread(pointers);
      if (before > 0 && after > 0) camera.zoom(before / after);
      camera.pan(-dx / 2, dy / 2); // each finger carries half of the pair's motion
    }
    moved();
  });
  on("touchmove", (event) => event.touches[1] && event.preventDefault(), { passive: false }); // two fingers scroll nothing
  on("contextmenu", (event) => event.preventDefault());
  on("wheel", (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(0.0015 * [1, 16, 400][event.deltaMode] * event.deltaY)); // pixels, lines or pages
    moved();
  }, { passive: false });
  on("dblclick", () => moved(true));
  on("keydown", (event) => {
    const move = KEYS[event.key];
    if (!move || event.altKey || event.metaKey || event.ctrlKey) return; // those are the browser's
    event.preventDefault();
    const [right, up, back] = move;
    if (event.shiftKey) camera.pan(right / 20, up / 20);
    else camera.rotate(right * KEY_TURN, -up * KEY_TURN);
    camera.zoom(KEY_ZOOM ** back);
    moved(event.key === "Home");
  });
}

function spread(pointers) {
  if (pointers.size !== 2) return 0;
  const [a, b] = pointers.values();
  return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
}

/** The view in words, for screen readers, after model-viewer's custom. */
export function spokenView(theta, phi) {
  const quarter = ["front", "right", "back", "left"][Math.round(theta / (Math.PI / 2)) & 3];
  const height = phi < Math.PI / 4 ? "upper-" : phi > (3 * Math.PI) / 4 ? "lower-" : "";
  return `View from stage ${height}${quarter}`;
}
