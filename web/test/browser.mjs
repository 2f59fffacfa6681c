// A headless Chromium with software WebGL, the page server, and pages that fail on any console error.
import { chromium } from "playwright-core";
import { serve } from "../serve.mjs";

const FLAGS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--force-color-profile=srgb"];

/** Starts server and browser; `extra` maps further paths to what the server answers. Close it with close(). */
export async function open(extra = {}, { flags = FLAGS, isolated = false } = {}) {
  const server = await serve(0, extra, { isolated });
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: flags });
  const origin = `http://127.0.0.1:${server.address().port}`;
  return {
    origin,
    /** A page of an element with these attributes, loaded; `errors` collects what the console says is wrong. */
    async element(attributes, { width = 320, height = 180, wait = true, ...options } = {}) {
      const page = await this.blank(options);
      await page.evaluate(async ({ attributes, width, height }) => {
        const view = document.createElement("tukor-view");
        for (const [name, value] of Object.entries(attributes)) view.setAttribute(name, value);
        view.style.cssText = `width:${width}px;height:${height}px`;
        window.said = [];
        for (const type of ["load", "error", "progress", "camera-change"])
          view.addEventListener(type, (event) => window.said.push({ type, ...(event.detail ?? {}), sourceError: undefined }));
        document.body.append(view);
        window.view = view;
      }, { attributes, width, height });
      if (wait) await page.waitForFunction(() => window.said.some(({ type }) => type === "load" || type === "error"), null, { timeout: 60000 });
      return page;
    },
    async blank(options = {}) {
      const context = await browser.newContext({ viewport: { width: 800, height: 600 }, ...options });
      const page = await context.newPage();
      page.errors = [];
      page.on("console", (message) => message.type() === "error" && page.errors.push(message.text()));
      page.on("pageerror", (error) => page.errors.push(String(error)));
      await page.goto(`${origin}/test/blank.html`);
      await page.waitForFunction(() => customElements.get("tukor-view"));
      return page;
    },
    /** Ends the GPU process, as a driver's fault does: every context is lost. */
    async loseContexts() {
      const session = await browser.newBrowserCDPSession();
      await session.send("Browser.crashGpuProcess").catch(() => {});
      await session.detach();
    },
    async close() {
      await browser.close();
      server.close();
    },
  };
}

/** The present view of `window.view`, rendered to the end: bytes, four a pixel. */
export async function picture(page, options = {}) {
  const image = await page.evaluate(async (options) => {
    const { width, height, data } = await window.view.render(options);
    let text = "";
    for (let i = 0; i < data.length; i += 32768) text += String.fromCharCode(...data.subarray(i, i + 32768));
    return { width, height, data: btoa(text) };
  }, options);
  return { width: image.width, height: image.height, data: Buffer.from(image.data, "base64") };
}
