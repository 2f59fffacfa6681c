// Serves web/ and the photographic environments of Debian's blender-data on this machine only.
//
// usage: node serve.mjs [PORT]
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL(".", import.meta.url));
const photographs = "/usr/share/blender/datafiles/studiolights/world";
const types = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".mjs": "text/javascript", ".css": "text/css", ".wasm": "application/wasm",
                ".json": "application/json", ".png": "image/png", ".glb": "model/gltf-binary", ".gltf": "model/gltf+json" };

/** Starts a server on 127.0.0.1; `extra` maps further paths to bytes. Port 0 takes any free one. Pages are cross-origin isolated unless told otherwise. */
export function serve(port, extra = {}, { isolated = true } = {}) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname));
    const headers = {
      "Content-Type": types[extname(path)] ?? (path.endsWith("/") ? types[".html"] : "application/octet-stream"),
      ...(isolated && { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" }), "Cache-Control": "no-cache",
      // The strictest policy that the element needs; see docs/web.md.
      "Content-Security-Policy": "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self' blob:",
    };
    try {
      const file = path.startsWith("/photographs/") ? join(photographs, path.slice(13)) : join(root, path.endsWith("/") ? path + "index.html" : path);
      const body = extra[path] ?? (await readFile(file));
      response.writeHead(200, headers).end(body);
    } catch {
      response.writeHead(404, { "Content-Type": "text/plain" }).end("not found\n");
    }
  });
  return new Promise((resolve, reject) => server.on("error", reject).listen(port, "127.0.0.1", () => resolve(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(Number(process.argv[2] ?? 8080)).catch((error) => {
    console.error(`serve.mjs: ${error.code === "EADDRINUSE" ? `port ${error.port} is taken; choose another with PORT=...` : error.message}`);
    process.exit(1);
  });
  const { port } = server.address();
  console.log(`Examples: http://localhost:${port}/\nEditor:   http://localhost:${port}/editor.html\nCtrl-C ends.`);
}
