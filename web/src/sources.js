// Where an element's model and environment come from: a dropped file, a name of something built in, or a URL. The newest request wins.
import { baseName, download } from "./files.js";

const BUILT_IN = { src: /^[a-z-]+$/, environment: /^[a-z]+$/ };

export class Sources {
  files = { src: null, environment: null }; // dropped ones, each with what lies beside it, until the attribute changes
  names = { src: "", environment: "studio" }; // of what is shown
  #kept = {}; // dropped ones that are shown
  #newest = {}; // of what was asked for
  #ready = {};
  #share = { src: 0, environment: 0 }; // fractions that have arrived

  /** Nothing is shown, and nothing is under way. */
  forget() {
    this.#ready = {};
    this.#share = { src: 0, environment: 0 };
    this.#newest = {};
  }

  isReady(what) { return this.#ready[what]; }
  get allReady() { return this.#ready.src && this.#ready.environment; }
  get arrived() { return 0.5 * this.#share.src + 0.5 * this.#share.environment; }

  /** How it is called: a file's name, or what the attribute says. */
  nameOf(what, attribute) {
    return this.files[what]?.[0].name ?? attribute;
  }

  /**
   * Fetches it and hands it to `send` as {name, bytes, url, others}, no bytes for what is built in; `arrives()` is called after progress. True when
   * it is shown now; false when nothing is named, or something newer was asked for meanwhile. Rejects only for the newest.
   */
  async load(what, attribute, send, arrives) {
    const newest = (this.#newest[what] = {});
    const current = () => newest === this.#newest[what];
    const files = this.files[what];
    const [file, ...others] = files ?? [];
    const source = this.nameOf(what, attribute);
    if (!source) return false;
    const name = file ? file.name : baseName(source);
    const share = (fraction) => {
      this.#share[what] = fraction;
      arrives();
    };
    try {
      const found = { name, others };
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
    this.#kept[what] = files;
    this.names[what] = source;
    this.#ready[what] = true;
    share(1);
    return true;
  }
}
