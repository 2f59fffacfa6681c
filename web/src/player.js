// Draws an element's frames one after the other: while something changes, and at rest until the picture is fine.

const REST_SAMPLES = 256; // frames accumulated at rest; the picture no longer changes visibly after that
const AUTO_ROTATE = Math.PI / 16; // rad/s
export const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

export class Player {
  samples = 0; // a pixel, in the picture at rest
  size = { width: 300, height: 150 }; // of the picture, in pixels
  movedAt = -Infinity; // when a person last steered
  #camera;
  #host;
  #frame = 0;
  #drawing = false;
  #restart = false;
  #last = 0;

  /**
   * `host` has: `awake`, whether anything is to be drawn; `turns`, whether by itself; `size`; `advance(seconds)`, after which the model moves or not;
   * `ask(values)` draws and gives the samples; `drawn(frame)` and `failed(error)` hear of it.
   */
  constructor(camera, host) {
    this.#camera = camera;
    this.#host = host;
  }

  /** The picture has to be drawn anew. */
  changed() {
    this.samples = 0;
    this.#restart = true;
    this.wake();
  }

  wake() {
    if (this.#frame || this.#drawing || !this.#host.awake) return;
    this.#last = performance.now();
    this.#next();
  }

  /** Ends what is under way, whose answer may never come. */
  stop() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#drawing = false;
  }

  #next() {
    this.#frame = requestAnimationFrame((now) => this.#draw(now));
  }

  async #draw(now) {
    const host = this.#host;
    this.#frame = 0;
    if (!host.awake) return;
    const turns = host.turns && !reducedMotion.matches;
    const seconds = (now - this.#last) / 1000;
    this.#last = now;
    const moving = this.#moveCamera(Math.min(seconds, 0.1), now, turns);
    const plays = host.advance(Math.max(seconds, 0));
    this.size = host.size;
    const coarse = this.#restart || moving || plays; // a quick one first, then all of it
    this.#restart = false;
    this.#drawing = true;
    let samples;
    try {
      samples = await host.ask({ view: this.#camera.view(), ...this.size, moving: coarse });
    } catch (error) {
      host.failed(error);
      return;
    } finally {
      this.#drawing = false;
    }
    if (samples === null) return; // of a side that was closed meanwhile
    if (!this.#restart) this.samples = coarse ? 0 : samples;
    host.drawn({ samples, moving });
    if (!this.#frame && host.awake && (this.#restart || coarse || turns || samples < REST_SAMPLES)) this.#next();
  }

  /** Eases the camera towards its goal; whether it moved. */
  #moveCamera(seconds, now, turns) {
    const camera = this.#camera;
    const turning = turns && now - this.movedAt > 3000;
    if (turning) camera.rotate(AUTO_ROTATE * seconds, 0);
    const before = camera.view();
    if (reducedMotion.matches) camera.jump();
    return camera.step(seconds) || turning || before.eye.some((x, i) => x !== camera.view().eye[i]);
  }
}
