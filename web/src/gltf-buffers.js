// The bytes behind a glTF file's buffer views: of its binary chunk, of a data URI, or of a file that it names.

/** Bytes of a data URI; null where it is none. */
export function ofDataUri(uri) {
  const match = /^data:[^,]*?(;base64)?,(.*)$/s.exec(uri);
  if (!match) return null;
  const text = match[1] ? atob(match[2]) : decodeURIComponent(match[2]);
  return Uint8Array.from(text, (c) => c.charCodeAt(0));
}

export const fileOf = (uri, files) => files.find(([path]) => path === decodeURIComponent(uri))?.[1];

/** Of a view, or of what says `buffer`, `byteOffset` and `byteLength` as one; nothing where they are not there. */
export function viewBytes(view, { json, binary }, files) {
  const buffer = json.buffers?.[view?.buffer];
  if (!buffer) return null;
  const bytes = buffer.uri === undefined ? binary : (ofDataUri(buffer.uri) ?? fileOf(buffer.uri, files));
  const from = view.byteOffset ?? 0;
  return bytes?.subarray(from, from + view.byteLength);
}
