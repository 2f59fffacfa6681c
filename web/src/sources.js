// Where an element's model and environment come from: a dropped file, a name of something built in, or a URL. The newest request wins.
import { baseName, download } from "./files.js";

const BUILT_IN = { src: /^[a-z-]+$/, environment: /^[a-z]+$/ };

export class Sources {
  files = { src: null, environment: null }; // dropped ones, until the attribute changes
  names = { src: "", environment: "studio" }; // of what is shown
  #kept = { src: null, environment: null }; // dropped ones that are shown
  #serial = { src: 0, environment: 0 };
  #ready = { src: false, environment: false };
  #share = { src: 0, environment: 0 }; // fractions that have arrived

  /** Nothing is shown, and nothing is under way. */
  forget() {
    this.#ready = { src: false, environment: false };
    this.#share = { src: 0, environment: 0 };
    for (const what of ["src", "environment"]) this.#serial[what]++;
  }

  isReady(what) { return this.#ready[what]; }
  get allReady() { return this.#ready.src && this.#ready.environment; }
  get arrived() { return 0.5 * this.#share.src + 0.5 * this.#share.environment; }

  /** How it is called: a file's name, or what the attribute says. */
  nameOf(what, attribute) {
    return this.files[what] ? this.files[what].name : attribute;
  }

  /**
   * Fetches it and hands it to `send` as {name, bytes, url}, no bytes for what is built in; `arrives()` is called after progress. True when
   * it is shown now; false when nothing is named, or something newer was asked for meanwhile. Rejects only for the newest.
   */
  async load(what, attribute, send, arrives) {
    const serial = ++this.#serial[what];
    const current = () => serial === this.#serial[what];
    const file = this.files[what];
    const source = this.nameOf(what, attribute);
    if (!source) return false;
    const name = file ? file.name : baseName(source);
    const share = (fraction) => {
      this.#share[what] = fraction;
      arrives();
    };
    try {
      const found = { name, bytes: undefined, url: null };
      if (file) found.bytes = new Uint8Array(await file.arrayBuffer());
      else if (!BUILT_IN[what].test(source)) {
        found.url = new URL(source, document.baseURI);
        found.bytes = await download(found.url, name, (fraction) => current() && share(0.9 * fraction));
      }
      if (found.bytes?.length === 0) throw new Error(`${name}: an empty file`);
      if (!current()) return false;
      await send(found, current);
      if (!current()) return false;
    } catch (error) {
      if (!current()) return false;
      this.files[what] = this.#kept[what];
      throw error;
    }
    this.#kept[what] = file;
    this.names[what] = source;
    this.#ready[what] = true;
    share(1);
    return true;
  }
}
