// The models that every peer is given, as GLB files: a sphere and a torus knot, of gold or of glass.

/** Gold by its linear reflectance at normal incidence, as glTF wants it: metals have no complex index there. */
export function gold({ eta, k }) {
  const facing = eta.map((n, i) => ((n - 1) ** 2 + k[i] ** 2) / ((n + 1) ** 2 + k[i] ** 2));
  return { name: "gold", pbrMetallicRoughness: { metallicFactor: 1, roughnessFactor: 0, baseColorFactor: [...facing, 1] } };
}

/** Clear, this thick where light goes straight through its middle. */
export function glass(ior, thicknessFactor) {
  return {
    name: "glass",
    pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0 },
    extensions: { KHR_materials_transmission: { transmissionFactor: 1 }, KHR_materials_ior: { ior }, KHR_materials_volume: { thicknessFactor } },
  };
}

/** The unit sphere: vertices a hair outside, so that its area is a sphere's. */
export function sphere(rows = 80, columns = 160) {
  const normals = [[0, 1, 0]];
  const triangles = [];
  for (let row = 1; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const theta = (Math.PI * row) / rows, phi = (2 * Math.PI * column) / columns;
      normals.push([Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi)]);
    }
  const south = normals.push([0, -1, 0]) - 1;
  const at = (row, column) => 1 + (row - 1) * columns + (column % columns);
  for (let column = 0; column < columns; column++) {
    triangles.push([0, at(1, column), at(1, column + 1)], [south, at(rows - 1, column + 1), at(rows - 1, column)]);
    for (let row = 1; row < rows - 1; row++)
      triangles.push([at(row, column), at(row + 1, column), at(row, column + 1)], [at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)]);
  }
  let area = 0;
  for (const [a, b, c] of triangles) {
    const [u, v] = [b, c].map((i) => normals[i].map((x, axis) => x - normals[a][axis]));
    area += 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  const radius = Math.sqrt((4 * Math.PI) / area);
  return { positions: normals.map((n) => n.map((x) => radius * x)), normals, triangles };
}

/** A (2, 3) torus knot about as large as the sphere. */
export function knot(along = 640, around = 48, tube = 0.2) {
  const centre = (t) => {
    const r = 0.55 * (1 + 0.4 * Math.cos(3 * t));
    return [r * Math.cos(2 * t), 0.35 * Math.sin(3 * t), r * Math.sin(2 * t)];
  };
  const minus = (a, b) => a.map((x, i) => x - b[i]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => a.map((x) => x / Math.hypot(...a));
  const positions = [], normals = [], triangles = [];
  for (let i = 0; i < along; i++) {
    const t = (2 * Math.PI * i) / along;
    const middle = centre(t);
    const forward = unit(minus(centre(t + 1e-3), centre(t - 1e-3)));
    const side = unit(cross(forward, middle));
    const up = cross(side, forward);
    for (let j = 0; j < around; j++) {
      const angle = (2 * Math.PI * j) / around;
      const n = side.map((x, axis) => x * Math.cos(angle) + up[axis] * Math.sin(angle));
      normals.push(n);
      positions.push(middle.map((x, axis) => x + tube * n[axis]));
      const next = ((i + 1) % along) * around, other = (j + 1) % around;
      triangles.push([i * around + j, next + j, i * around + other], [next + j, next + other, i * around + other]);
    }
  }
  return { positions, normals, triangles };
}

/** One part of one material. */
export function glb({ positions, normals, triangles }, material) {
  const views = [Float32Array.from(positions.flat()), Float32Array.from(normals.flat()), Uint32Array.from(triangles.flat())].map((array) => Buffer.from(array.buffer));
  let end = 0;
  const bufferViews = views.map((view, i) => ({ buffer: 0, byteOffset: (end += view.length) - view.length, byteLength: view.length, target: i < 2 ? 34962 : 34963 }));
  const bounds = (pick) => [0, 1, 2].map((axis) => positions.reduce((found, p) => pick(found, p[axis]), positions[0][axis]));
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [material],
    extensionsUsed: Object.keys(material.extensions ?? {}),
    accessors: [
      { bufferView: 0, componentType: 5126, count: positions.length, type: "VEC3", min: bounds(Math.min), max: bounds(Math.max) },
      { bufferView: 1, componentType: 5126, count: normals.length, type: "VEC3" },
      { bufferView: 2, componentType: 5125, count: 3 * triangles.length, type: "SCALAR" },
    ],
    bufferViews,
    buffers: [{ byteLength: end }],
  };
  if (json.extensionsUsed.length === 0) delete json.extensionsUsed;
  const chunk = (type, bytes, padding) => {
    const body = Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, padding)]);
    const head = Buffer.alloc(8);
    head.writeUInt32LE(body.length, 0);
    head.writeUInt32LE(type, 4);
    return Buffer.concat([head, body]);
  };
  const body = Buffer.concat([chunk(0x4e4f534a, Buffer.from(JSON.stringify(json)), " "), chunk(0x004e4942, Buffer.concat(views), 0)]);
  const head = Buffer.from("glTF\x02\0\0\0\0\0\0\0", "latin1");
  head.writeUInt32LE(12 + body.length, 8);
  return Buffer.concat([head, body]);
}
