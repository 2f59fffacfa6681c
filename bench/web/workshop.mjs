// Bundles a peer's page as a site would, serves it, opens it in a fresh browser, and asks it things.
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { readFile } from "node:fs/promises";
import { extname, join } from "node:path";
import { brotliCompressSync } from "node:zlib";

const FLAGS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--force-color-profile=srgb",
               "--disable-frame-rate-limit", "--disable-gpu-vsync"];
const TYPES = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html", ".glb": "model/gltf-binary" };
const CLASSIC = { filament: "filament.js" }; // finds its .wasm by the script that it is

export class Workshop {
  static async open({ here, root, folder, files }) {
    const workshop = new Workshop();
    const web = createRequire(join(root, "web/package.json"));
    Object.assign(workshop, { here, root, folder, files, chromium: web("playwright-core").chromium, esbuild: web("esbuild"), built: new Map() });
    workshop.server = createServer((request, response) => workshop.#answer(request, response));
    await new Promise((resolve) => workshop.server.listen(0, "127.0.0.1", resolve));
    return workshop;
  }

  async #answer(request, response) {
    const path = new URL(request.url, "http://localhost").pathname;
    const headers = { "Content-Type": TYPES[extname(path)] ?? "application/octet-stream", "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" };
    try {
      const body = await this.body(path);
      response.writeHead(200, headers).end(body);
    } catch {
      response.writeHead(404).end();
    }
  }

  async body(path) {
    if (this.files[path]) return this.files[path];
    const [, script, name] = path.split("/");
    if (name === "page.html") {
      const classic = CLASSIC[script] ? `<script src="${CLASSIC[script]}"></script>` : "";
      return `<!doctype html><link rel="icon" href="data:,"><style>body{margin:0}</style><div id="host"></div>${classic}<script type="module" src="${script}-page.js"></script>`;
    }
    if (script === "filament" && name.startsWith("filament.")) return readFile(join(this.here, "node_modules/filament", name));
    if (script === "tukor" && name !== "tukor-page.js") return readFile(join(this.root, "web/dist", name));
    return readFile(join(this.folder, script, name));
  }

  /** Only our own element is not bundled again: it is as its package ships it. */
  #build(script) {
    if (!this.built.has(script))
      this.built.set(script, this.esbuild.build({
        stdin: { contents: `import "./peers/${script}.js";`, resolveDir: this.here, sourcefile: `${script}-page.js` }, entryNames: `${script}-page`,
        bundle: true, splitting: true, format: "esm", minify: true, target: "es2022", outdir: join(this.folder, script), logLevel: "error",
        plugins: [{ name: "shipped", setup: (build) => build.onResolve({ filter: /tukor-view\.js$/ }, () => ({ path: "./tukor-view.js", external: true })) }],
      }));
    return this.built.get(script);
  }

  async page(script, options) {
    await this.#build(script);
    const browser = await this.chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: FLAGS });
    this.version = `Chromium ${browser.version()}`;
    const page = await browser.newPage({ viewport: { width: options.width, height: options.height } });
    const fetched = new Set(), said = [];
    page.context().on("request", (request) => /\.(js|wasm)$/.test(request.url()) && fetched.add(new URL(request.url()).pathname));
    page.on("console", (message) => message.type() === "error" && said.push(message.text()));
    page.on("pageerror", (error) => said.push(error.message));
    const limited = (work) => Promise.race([work, new Promise((_, reject) => setTimeout(() => reject(new Error(`no answer in 120 s. ${said.join("; ")}`)), 120000).unref())]);
    const origin = `http://127.0.0.1:${this.server.address().port}`;
    await page.goto(`${origin}/${script}/page.html#${encodeURIComponent(JSON.stringify(options))}`);
    const workshop = this;
    return {
      /** Milliseconds from asking for the page to a whole picture. */
      first: () => limited(page.waitForFunction(() => window.shown, null, { timeout: 120000 }).then((handle) => handle.jsonValue())),
      lights: (url, times) => limited(page.evaluate(async ([url, times]) => {
        const taken = [];
        for (let i = 0; i < times; i++) {
          const bytes = new Uint8Array(await (await fetch(url)).arrayBuffer());
          const begun = performance.now();
          await window.peer.light(bytes);
          taken.push(performance.now() - begun);
        }
        return taken;
      }, [url, times])),
      frames: (count) => limited(page.evaluate(async (count) => {
        const taken = [];
        for (let i = -3; i < count; i++) {
          const begun = performance.now();
          await window.peer.frame(0.05 * (i + 4));
          if (i >= 0) taken.push(performance.now() - begun);
        }
        return taken;
      }, count)),
      rest: () => limited(page.evaluate(() => window.peer.rest())),
      /** What is on the screen, four numbers a pixel; kept as a file. */
      async picture(path) {
        const png = await page.screenshot({ path });
        const text = await page.evaluate(async (png) => {
          const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob(), { colorSpaceConversion: "none" });
          const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
          context.drawImage(bitmap, 0, 0);
          const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
          let text = "";
          for (let i = 0; i < data.length; i += 32768) text += String.fromCharCode(...data.subarray(i, i + 32768));
          return btoa(text);
        }, png.toString("base64"));
        return Buffer.from(text, "base64");
      },
      /** Of code, as a server would send it. */
      bytes() {
        return Promise.all([...fetched].map(async (path) => brotliCompressSync(await workshop.body(path)).length)).then((sizes) => sizes.reduce((a, b) => a + b, 0));
      },
      close: () => browser.close(),
    };
  }

  async close() {
    this.server.close();
  }
}
