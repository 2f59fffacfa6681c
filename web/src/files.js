// Files of an element: fetched from where its attributes say, or dropped by a person; read here, never sent anywhere.

import { gltfContents, neighbourUris } from "./gltf-json.js";

export const baseName = (url) => url.split(/[?#]/)[0].split("/").at(-1);

/** The bytes behind a URL; `arrived` hears the fraction of them that is there. */
export async function download(url, name, arrived = () => {}) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
  const total = Number(response.headers.get("Content-Length"));
  if (!(total > 0) || !response.body) return new Uint8Array(await response.arrayBuffer());
  const pieces = [];
  let size = 0;
  for (const reader = response.body.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    pieces.push(value);
    arrived(Math.min(1, (size += value.length) / total)); // more arrives than the length says where it was compressed
  }
  return new Uint8Array(await new Blob(pieces).arrayBuffer());
}

/** [path, bytes] of what lies beside a model: those dropped with it, or those that a .gltf names, from its own folder or below, nowhere else. */
export async function neighbours({ name, bytes, url, others }) {
  const uris = /\.gltf$/i.test(name) ? neighbourUris(gltfContents(bytes)?.json) : [];
  if (!url) // dropped ones have lost their folders
    return Promise.all(others.map(async (file) => [uris.map(decodeURIComponent).find((uri) => `/${uri}`.endsWith(`/${file.name}`)) ?? file.name, new Uint8Array(await file.arrayBuffer())]));
  const folder = new URL(".", url).href;
  return Promise.all(uris.map(async (uri) => {
    const target = new URL(uri, url);
    if (!target.href.startsWith(folder)) throw new Error(`${name}: names ${uri}, which is outside its own folder`);
    return [decodeURIComponent(uri), await download(target, uri)];
  }));
}
