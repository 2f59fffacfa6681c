#!/usr/bin/env bash
# Builds <tukor-view> into web/dist: the library as WebAssembly, the element and its lazily loaded parts, types.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh build web
export NODE_PATH=/usr/share/nodejs # where Debian's emscripten keeps its JavaScript tools

tools/stage_web_deps.sh build/web-deps
mkdir -p build web/dist
for preset in web web-threads; do
    { cmake --preset $preset && cmake --build --preset $preset; } >build/$preset.log 2>&1 ||
        { tail -40 build/$preset.log >&2; echo "the web build failed; all of it: build/$preset.log" >&2; exit 1; }
done

cd web
if [ ! -e node_modules/.package-lock.json ] || [ package-lock.json -nt node_modules/.package-lock.json ]; then
    npm ci --no-audit --no-fund --ignore-scripts --loglevel=error
fi
rm -rf dist
bundle() {
    node_modules/.bin/esbuild "$@" --bundle --format=esm --minify --target=es2022 --outdir=dist --log-level=warning
}
# Others' decoders and threads by themselves, lest what only they need or share becomes part of what every page fetches; Draco's asks for fs
# and path in Node.js.
bundle src/{draco,hdrify,ktx2-zstd,meshopt,tukor-threads}.js --external:fs --external:path
bundle src/tukor-{view,worker,extras,finish,images,unpack}.js --splitting --external:./{draco,hdrify,ktx2-zstd,meshopt,tukor-threads}.js
cp ../build/web/apps/web/*.wasm node_modules/draco3dgltf/draco_decoder_gltf.wasm src/tukor-view.d.ts dist/
for module in ../build/web-threads/apps/web/*.wasm; do cp "$module" "dist/$(basename "$module" .wasm)-threads.wasm"; done
