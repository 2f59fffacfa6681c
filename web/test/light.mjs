// A computed environment with its .hdr file, and the closed form of a sphere in it: what pictures are held against.

/** Smooth radiance from all around, with structure about 15 degrees wide; direction is unit. */
export function radiance([x, y, z]) {
  const waves = [
    0.5 + 0.3 * Math.sin(9 * x + 2 * y) * Math.cos(7 * z),
    0.5 + 0.3 * Math.sin(8 * y - 3 * z + 1) * Math.cos(6 * x),
    0.5 + 0.3 * Math.sin(10 * z + 4 * x - 2) * Math.cos(5 * y),
  ];
  return waves.map((w) => w * (0.75 + 0.25 * y));
}

/** The same as an equirectangular Radiance picture: the middle looks along -Z, +X to the right of it. */
export function hdrFile(width = 1024) {
  const height = width / 2;
  const header = Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`);
  const pixels = Buffer.alloc(4 * width * height);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++) {
      const theta = (Math.PI * (row + 0.5)) / height;
      const phi = 2 * Math.PI * ((column + 0.5) / width - 0.5);
      const L = radiance([Math.sin(theta) * Math.sin(phi), Math.cos(theta), -Math.sin(theta) * Math.cos(phi)]);
      const exponent = Math.ceil(Math.log2(Math.max(...L) * 1.0001));
      L.forEach((value, i) => (pixels[4 * (row * width + column) + i] = Math.min(255, Math.round((value * 256) / 2 ** exponent))));
      pixels[4 * (row * width + column) + 3] = exponent + 128;
    }
  return Buffer.concat([header, pixels]);
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));
const mix = (a, b, t) => a.map((x, i) => x + t * (b[i] - x));

/** Exact reflectance of a dielectric interface; eta is far over near index. */
function dielectric(cos, eta) {
  const g2 = eta * eta - 1 + cos * cos;
  if (g2 <= 0) return 1;
  const g = Math.sqrt(g2);
  return 0.5 * (((cos - g) / (cos + g)) ** 2 + ((eta * eta * cos - g) / (eta * eta * cos + g)) ** 2);
}

/** Exact reflectance of a conductor with index eta + i k, after complex Snell. */
function conductor(cos, eta, k) {
  const s2 = 1 - cos * cos;
  const t0 = eta * eta - k * k - s2;
  const ab = Math.sqrt(t0 * t0 + 4 * eta * eta * k * k);
  const a = Math.sqrt(Math.max(0, 0.5 * (ab + t0)));
  const Rs = (ab + cos * cos - 2 * a * cos) / (ab + cos * cos + 2 * a * cos);
  return 0.5 * Rs * (1 + (cos * cos * ab + s2 * s2 - 2 * a * cos * s2) / (cos * cos * ab + s2 * s2 + 2 * a * cos * s2));
}

/** What leaves the unit sphere at the origin against direction `d`, hit at `n`: every reflection inside counts. */
function shaded(material, d, n, lookup) {
  const cos = -dot(d, n);
  const mirrored = add(d, n, 2 * cos);
  if (material.k) return lookup(mirrored).map((L, i) => L * conductor(cos, material.eta[i], material.k[i]));
  const R = dielectric(cos, material.ior);
  let sum = lookup(mirrored).map((L) => L * R);
  const cosT = Math.sqrt(1 - (1 - cos * cos) / material.ior ** 2);
  let inside = add(d.map((x) => x / material.ior), n, cos / material.ior - cosT);
  if (material.single) return add(sum, lookup(inside), 1 - R);
  let point = n;
  for (let weight = 1 - R, event = 0; event < 40 && weight > 1e-7; event++, weight *= R) {
    point = add(point, inside, 2 * cosT);
    const out = add(inside.map((x) => x * material.ior), point, cos - cosT * material.ior);
    sum = add(sum, lookup(unit(out)), weight * (1 - R));
    inside = add(inside, point, -2 * cosT);
  }
  return sum;
}

const encode = (x) => 255 * (x <= 0 ? 0 : x >= 1 ? 1 : x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/**
 * The unit sphere seen from (0, 0, distance), in 8-bit sRGB of the clipped linear picture, supersampled; rows from the top, four
 * numbers a pixel.
 */
export function spherePicture(material, { width, height, distance, fov, grid = 8 }) {
  const data = new Float64Array(4 * width * height);
  const eye = [0, 0, distance];
  const scale = Math.tan(fov / 2);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++) {
      let sum = [0, 0, 0];
      for (let s = 0; s < grid * grid; s++) {
        const x = column + ((s % grid) + 0.5) / grid;
        const y = row + (Math.floor(s / grid) + 0.5) / grid;
        const d = unit([((2 * x) / width - 1) * scale * (width / height), (1 - (2 * y) / height) * scale, -1]);
        const b = dot(eye, d);
        const h = b * b - distance * distance + 1;
        sum = add(sum, h <= 0 ? radiance(d) : shaded(material, d, add(eye, d, -b - Math.sqrt(h)), radiance));
      }
      for (let c = 0; c < 3; c++) data[4 * (row * width + column) + c] = encode(sum[c] / (grid * grid));
      data[4 * (row * width + column) + 3] = 255;
    }
  return data;
}

/** Root mean square difference over pixels and channels, alpha aside. */
export function distanceBetween(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) if (i % 4 !== 3) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / ((3 * a.length) / 4));
}
