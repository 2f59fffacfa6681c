#!/usr/bin/env python3
"""Small glTF scenes, one for each feature of materials: tools/feature_scenes.py FOLDER [NAME...]

Each is a row of spheres, or a sheet, with one figure growing from left to right. Everything is made here; nothing is fetched.
"""
import json
import math
import pathlib
import struct
import sys
import zlib


def png(width, height, pixel):
    """An 8-bit RGBA PNG; pixel(x, y) gives four numbers from 0 to 255."""
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class Scene:
    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0", "generator": "tools/feature_scenes.py"}, "scene": 0,
                     "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "accessors": [], "bufferViews": [],
                     "materials": [], "extensionsUsed": []}

    def view(self, data):
        while len(self.binary) % 4:
            self.binary += b"\0"
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, rows, kind, code="f"):
        size = len(rows[0]) if isinstance(rows[0], tuple) else 1
        flat = [c for row in rows for c in (row if isinstance(row, tuple) else (row,))]
        item = {"bufferView": self.view(struct.pack(f"<{len(flat)}{code}", *flat)), "count": len(rows),
                "componentType": {"f": 5126, "I": 5125, "H": 5123}[code], "type": kind}
        if kind == "VEC3" and size == 3:
            item["min"] = [min(row[i] for row in rows) for i in range(3)]
            item["max"] = [max(row[i] for row in rows) for i in range(3)]
        self.json["accessors"].append(item)
        return len(self.json["accessors"]) - 1

    def mesh(self, attributes, indices, material, **more):
        primitive = {"attributes": attributes, "indices": indices, **more}
        if material is not None:
            primitive["material"] = material
        self.json["meshes"].append({"primitives": [primitive]})
        return len(self.json["meshes"]) - 1

    def node(self, **figures):
        self.json["nodes"].append(figures)
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)
        return len(self.json["nodes"]) - 1

    def material(self, base=(0.8, 0.8, 0.8, 1), metallic=0, roughness=1, extensions=None, textures=None, **more):
        item = {"pbrMetallicRoughness": {"baseColorFactor": list(base), "metallicFactor": metallic,
                                         "roughnessFactor": roughness, **(textures or {})}, **more}
        if extensions:
            item["extensions"] = extensions
            self.json["extensionsUsed"] = sorted(set(self.json["extensionsUsed"]) | set(extensions))
        self.json["materials"].append(item)
        return len(self.json["materials"]) - 1

    def texture(self, image, **info):
        """A texture of PNG bytes, as a textureInfo."""
        images = self.json.setdefault("images", [])
        images.append({"bufferView": self.view(image), "mimeType": "image/png"})
        self.json.setdefault("textures", []).append({"source": len(images) - 1, "sampler": 0})
        self.json.setdefault("samplers", [{}])
        return {"index": len(images) - 1, **info}

    def sphere(self, x, material, radius=0.5, y=0.0, rings=48, name=None, morph=None):
        sectors = 2 * rings
        positions, normals, uvs, indices = [], [], [], []
        for i in range(rings + 1):
            for j in range(sectors + 1):
                theta, phi = math.pi * i / rings, 2 * math.pi * (j % sectors) / sectors
                across = math.sin(theta) if 0 < i < rings else 0.0  # closed at the poles and along the seam
                n = (across * math.sin(phi), math.cos(theta), across * math.cos(phi))
                normals.append(n)
                positions.append(tuple(radius * c for c in n))
                uvs.append((j / sectors, i / rings))
        for i in range(rings):
            for j in range(sectors):
                a, b = i * (sectors + 1) + j, (i + 1) * (sectors + 1) + j
                indices += ([] if i == 0 else [a, b, a + 1]) + ([] if i == rings - 1 else [a + 1, b, b + 1])
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor(normals, "VEC3"),
                      "TEXCOORD_0": self.accessor(uvs, "VEC2")}
        more = {"targets": [{"POSITION": self.accessor([morph(p) for p in positions], "VEC3")}]} if morph else {}
        mesh = self.mesh(attributes, self.accessor(indices, "SCALAR", "I"), material, **more)
        return self.node(mesh=mesh, translation=[x, y, 0], **({"name": name} if name else {}))

    def sheet(self, material, width=1.0, height=1.0, x=0.0, y=0.0, z=0.0, repeat=1.0, more=None, lying=False):
        w, h = width / 2, height / 2
        positions = [(-w, -h, 0.0), (w, -h, 0.0), (w, h, 0.0), (-w, h, 0.0)]
        normal = (0.0, 0.0, 1.0)
        if lying:
            positions, normal = [(p[0], 0.0, -p[1]) for p in positions], (0.0, 1.0, 0.0)
        uvs = [(0.0, repeat), (repeat, repeat), (repeat, 0.0), (0.0, 0.0)]
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor([normal] * 4, "VEC3"),
                      "TEXCOORD_0": self.accessor(uvs, "VEC2"), **(more or {})}
        mesh = self.mesh(attributes, self.accessor([0, 1, 2, 0, 2, 3], "SCALAR", "I"), material)
        return self.node(mesh=mesh, translation=[x, y, z])

    def box(self, material, size, x=0.0, y=0.0, z=0.0):
        positions, normals, uvs, indices = [], [], [], []
        for axis in range(3):
            for side in (-1, 1):
                first = len(positions)
                for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p, n = [0.0] * 3, [0.0] * 3
                    p[axis], n[axis] = side * size / 2, float(side)
                    right, up = (0, 2) if axis == 1 else ((axis + 2) % 3 if axis == 0 else 0, 1)
                    p[right], p[up] = (u - 0.5) * size, (v - 0.5) * size
                    positions.append(tuple(p))
                    normals.append(tuple(n))
                    uvs.append((u, 1 - v))
                a, b, c = (positions[first + i] for i in range(3))
                e, f = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
                outward = (e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0])[axis] * side > 0
                corners = (0, 1, 2, 0, 2, 3) if outward else (0, 2, 1, 0, 3, 2)
                indices += [first + i for i in corners]
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor(normals, "VEC3"),
                      "TEXCOORD_0": self.accessor(uvs, "VEC2")}
        mesh = self.mesh(attributes, self.accessor(indices, "SCALAR", "I"), material)
        return self.node(mesh=mesh, translation=[x, y, z])

    def write(self, path):
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps({k: v for k, v in self.json.items() if v != []}).encode()
        text += b" " * (-len(text) % 4)
        data = self.binary + b"\0" * (-len(self.binary) % 4)
        path.write_bytes(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data)) +
                         struct.pack("<II", len(text), 0x4E4F534A) + text +
                         struct.pack("<II", len(data), 0x004E4942) + data)


def checker(size, squares, a, b):
    return png(size, size, lambda x, y: a if (x * squares // size + y * squares // size) % 2 else b)


def row(figures):
    """Spheres side by side, with the material that figures(scene, share) makes; share grows from 0 to 1."""
    scene = Scene()
    for i in range(5):
        scene.sphere(1.1 * (i - 2), figures(scene, i / 4))
    return scene


def metal():
    return row(lambda s, x: s.material((1.0, 0.77, 0.34, 1), 1, max(x, 0.02)))


def plastic():
    return row(lambda s, x: s.material((0.6, 0.05, 0.04, 1), 0, max(x, 0.02)))


def metallic():
    return row(lambda s, x: s.material((0.9, 0.5, 0.3, 1), x, 0.35))


def ior():
    return row(lambda s, x: s.material((0.1, 0.2, 0.5, 1), 0, 0.15, {"KHR_materials_ior": {"ior": 1 + x}}))


def specular():
    return row(lambda s, x: s.material((0.1, 0.1, 0.1, 1), 0, 0.2, {"KHR_materials_specular": {
        "specularFactor": x, "specularColorFactor": [1, 0.6, 0.2]}}))


def clearcoat():
    return row(lambda s, x: s.material((0.3, 0.02, 0.02, 1), 0.5, 0.6, {"KHR_materials_clearcoat": {
        "clearcoatFactor": x, "clearcoatRoughnessFactor": 0.05}}))


def sheen():
    return row(lambda s, x: s.material((0.15, 0.02, 0.04, 1), 0, 1, {"KHR_materials_sheen": {
        "sheenColorFactor": [1, 0.7, 0.7], "sheenRoughnessFactor": max(x, 0.1)}}))


def anisotropy():
    return row(lambda s, x: s.material((0.9, 0.9, 0.9, 1), 1, 0.3, {"KHR_materials_anisotropy": {"anisotropyStrength": x}}))


def iridescence():
    return row(lambda s, x: s.material((0.4, 0.4, 0.4, 1), 1, 0.15, {"KHR_materials_iridescence": {
        "iridescenceFactor": 1, "iridescenceIor": 1.4, "iridescenceThicknessMaximum": 200 + 400 * x}}))


def frosted():
    return row(lambda s, x: s.material((1, 1, 1, 1), 0, x, {
        "KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.5},
        "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 1, "attenuationColor": [0.7, 0.9, 0.8]}}))


def thin():
    return row(lambda s, x: s.material((0.9, 0.6, 0.5, 1), 0, x, {"KHR_materials_transmission": {"transmissionFactor": 0.9}}))


def emission():
    return row(lambda s, x: s.material((0.1, 0.1, 0.1, 1), 0, 0.5, {"KHR_materials_emissive_strength": {
        "emissiveStrength": 4 * x}}, emissiveFactor=[1, 0.5, 0.1]))


def unlit():
    return row(lambda s, x: s.material((x, 0.4, 1 - x, 1), 0, 0.5, {"KHR_materials_unlit": {}}))


def blend():
    return row(lambda s, x: s.material((0.8, 0.3, 0.1, max(x, 0.1)), 0, 0.4, alphaMode="BLEND"))


def textured():
    s = Scene()
    base = checker(256, 8, (230, 180, 60, 255), (40, 60, 120, 255))
    figures = png(256, 256, lambda x, y: (255, 40 + 200 * (x * 8 // 256 % 2), 255 * (y * 8 // 256 % 2), 255))
    bumps = png(256, 256, lambda x, y: (int(127.5 + 70 * math.sin(x * math.pi / 16)),
                                        int(127.5 + 70 * math.sin(y * math.pi / 16)), 230, 255))
    dots = png(128, 128, lambda x, y: (255, 120, 30, 255) if (x % 32 - 16) ** 2 + (y % 32 - 16) ** 2 < 60 else (0, 0, 0, 255))
    s.sphere(-2.2, s.material((1, 1, 1, 1), 0, 0.6, textures={"baseColorTexture": s.texture(base)}))
    s.sphere(-1.1, s.material((0.9, 0.85, 0.8, 1), 1, 1, textures={"metallicRoughnessTexture": s.texture(figures)}))
    s.sphere(0, s.material((0.9, 0.6, 0.4, 1), 1, 0.3, normalTexture=s.texture(bumps)))
    s.sphere(1.1, s.material((0.2, 0.2, 0.2, 1), 0, 0.3, emissiveFactor=[1, 1, 1], emissiveTexture=s.texture(dots)))
    s.sphere(2.2, s.material((1, 1, 1, 1), 0, 0.6, textures={"baseColorTexture": s.texture(base, extensions={
        "KHR_texture_transform": {"scale": [2, 2], "rotation": 0.5}})}))
    s.json["extensionsUsed"] = ["KHR_texture_transform"]
    return s


def mask():
    s = Scene()
    holes = png(256, 256, lambda x, y: (60, 140, 60, 0 if (x % 64 - 32) ** 2 + (y % 64 - 32) ** 2 < 400 else 255))
    for i, mode in enumerate(("OPAQUE", "MASK", "BLEND")):
        s.sphere(1.1 * (i - 1), s.material((1, 1, 1, 1), 0, 0.5, textures={"baseColorTexture": s.texture(holes)},
                                           alphaMode=mode, doubleSided=True))
    return s


def colors():
    s = Scene()
    tints = [(1.0, 0.1, 0.1, 1.0), (0.1, 1.0, 0.1, 1.0), (0.1, 0.1, 1.0, 1.0), (1.0, 1.0, 0.1, 1.0)]
    for i in range(3):
        s.sheet(s.material((1, 1, 1, 1), 0, 0.3 + 0.3 * i), x=1.1 * (i - 1), more={"COLOR_0": s.accessor(tints, "VEC4")})
    return s


GLASS = {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_volume": {"thicknessFactor": 1}}


def tiled_floor(s, width, depth):
    tiles = checker(256, 8, (200, 200, 200, 255), (110, 110, 115, 255))
    s.sheet(s.material((1, 1, 1, 1), 0, 0.5, textures={"baseColorTexture": s.texture(tiles)}), width, depth, y=-0.5, lying=True)


def group():
    """Rough and diffuse things beside exact glass and metal, on a floor."""
    s = Scene()
    tiled_floor(s, 6, 4)
    s.sphere(-1.7, s.material((1, 1, 1, 1), 0, 0, GLASS), name="glass")
    s.sphere(-0.55, s.material((1.0, 0.77, 0.34, 1), 1, 0.3), name="rough gold")
    s.sphere(0.55, s.material((0.7, 0.1, 0.08, 1), 0, 0.6), name="clay")
    s.sphere(1.7, s.material((1.0, 0.77, 0.34, 1), 1, 0), name="gold")
    return s


def behind():
    """A glass ball before a textured box and a rough one, a silver ball that shows all of them."""
    s = Scene()
    wood = checker(256, 8, (210, 120, 50, 255), (60, 70, 150, 255))
    holes = png(256, 256, lambda x, y: (60, 160, 60, 0 if (x % 64 - 32) ** 2 + (y % 64 - 32) ** 2 < 400 else 255))
    s.sheet(s.material((0.6, 0.6, 0.6, 1), 0, 0.7), 8, 8, y=-0.5, z=-1, lying=True)
    s.box(s.material((1, 1, 1, 1), 0, 0.6, textures={"baseColorTexture": s.texture(wood)}), 1.0, -0.5, 0.0, -1.6)
    s.sphere(-0.75, s.material((1, 1, 1, 1), 0, 0, GLASS), name="glass")
    s.sphere(0.9, s.material((0.96, 0.95, 0.93, 1), 1, 0), name="silver")
    s.sphere(2.0, s.material((1.0, 0.77, 0.34, 1), 1, 0.35), name="rough gold")
    s.sphere(-2.0, s.material((0.7, 0.1, 0.08, 1), 0, 0.6), name="clay")
    s.sheet(s.material((1, 1, 1, 1), 0, 0.8, textures={"baseColorTexture": s.texture(holes)}, alphaMode="MASK",
                       doubleSided=True), 0.8, 0.8, 0.75, -0.1, -1.3)
    return s


def lamps():
    """A lamp, a spotlight and light from one direction over white spheres on a floor."""
    s = Scene()
    s.sheet(s.material((0.7, 0.7, 0.7, 1), 0, 0.9), 6, 4, y=-0.5, lying=True)
    for i in range(3):
        s.sphere(1.6 * (i - 1), s.material((0.8, 0.8, 0.8, 1), 0, 0.4))
    lights = [{"type": "point", "color": [1, 0.5, 0.2], "intensity": 3},
              {"type": "spot", "color": [0.4, 0.7, 1], "intensity": 12, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.3}},
              {"type": "directional", "intensity": 0.8}]
    s.json["extensionsUsed"] = ["KHR_lights_punctual"]
    s.json["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
    down = [-math.sqrt(0.5), 0, 0, math.sqrt(0.5)]  # from -Z to -Y
    for i, (place, turn) in enumerate((([-2.4, 0.8, 0.8], None), ([0, 3, 0], down), (None, [-0.3, 0.25, 0.08, 0.92]))):
        node = {"extensions": {"KHR_lights_punctual": {"light": i}}}
        if turn:
            length = math.sqrt(sum(c * c for c in turn))
            node["rotation"] = [c / length for c in turn]
        if place:
            node["translation"] = place
        s.node(**node)
    return s


def moved():
    """At 1 s: a box that has turned, a sphere morphed to half its height, a strip bent by its skin."""
    s = Scene()
    box = s.box(s.material((0.8, 0.3, 0.1, 1), 0, 0.5), 0.7, -1.3)
    ball = s.sphere(0, s.material((0.2, 0.5, 0.8, 1), 0, 0.4), morph=lambda p: (0.0, -0.5 * p[1], 0.0))
    rows = [i / 16 for i in range(17)]
    corners = [(x, y - 0.5, 0.0) for y in rows for x in (-0.25, 0.25)]
    bends = [min(max(2 * y - 0.5, 0), 1) for y in rows for _ in range(2)]
    indices = [2 * i + k for i in range(16) for k in (0, 1, 3, 0, 3, 2)]
    joints, weights = [(0, 1, 0, 0)] * 34, [(1 - b, b, 0.0, 0.0) for b in bends]
    mesh = s.mesh({"POSITION": s.accessor(corners, "VEC3"), "NORMAL": s.accessor([(0.0, 0.0, 1.0)] * 34, "VEC3"),
                   "JOINTS_0": s.accessor(joints, "VEC4", "H"), "WEIGHTS_0": s.accessor(weights, "VEC4")},
                  s.accessor(indices, "SCALAR", "I"), s.material((0.3, 0.6, 0.2, 1), 0, 0.6, doubleSided=True))
    strip = s.node(mesh=mesh, skin=0)
    root, joint = s.node(translation=[1.3, 0, 0]), s.node(translation=[0, 0, 0])
    s.json["nodes"][root]["children"] = [joint]
    s.json["scenes"][0]["nodes"].remove(joint)
    at_rest = tuple(float(i % 5 == 0) for i in range(16))
    s.json["skins"] = [{"joints": [root, joint], "inverseBindMatrices": s.accessor([at_rest] * 2, "MAT4")}]
    sixty = [(0.0, 0.0, 0.0, 1.0), (0.0, 0.5, 0.0, math.sqrt(0.75))], [(0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.5, math.sqrt(0.75))]
    times = s.accessor([0.0, 1.0], "SCALAR")
    s.json["accessors"][times].update(min=[0.0], max=[1.0])
    moves = [(box, "rotation", s.accessor(sixty[0], "VEC4")), (ball, "weights", s.accessor([0.0, 1.0], "SCALAR")),
             (joint, "rotation", s.accessor(sixty[1], "VEC4"))]
    s.json["animations"] = [{
        "samplers": [{"input": times, "output": output} for _, _, output in moves],
        "channels": [{"sampler": i, "target": {"node": node, "path": path}} for i, (node, path, _) in enumerate(moves)]}]
    return s


def instances():
    """One mesh five times: places, turns and sizes are EXT_mesh_gpu_instancing's."""
    s = Scene()
    s.box(s.material((1.0, 0.77, 0.34, 1), 1, 0.3), 0.6)
    turns = [(0.0, math.sin(0.2 * i), 0.0, math.cos(0.2 * i)) for i in range(5)]
    s.json["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {
        "TRANSLATION": s.accessor([(1.1 * (i - 2), 0.0, 0.0) for i in range(5)], "VEC3"),
        "ROTATION": s.accessor(turns, "VEC4"),
        "SCALE": s.accessor([(0.6 + 0.2 * i,) * 3 for i in range(5)], "VEC3")}}}
    s.json["extensionsUsed"] += ["EXT_mesh_gpu_instancing"]
    return s


def variants():
    """Clay by itself; every second sphere gilt as the variant `festive`."""
    s = Scene()
    clay, gilt = s.material((0.45, 0.2, 0.12, 1), 0, 0.8), s.material((1.0, 0.77, 0.34, 1), 1, 0.2)
    for i in range(5):
        s.sphere(1.1 * (i - 2), clay)
        if i % 2 == 0:
            mappings = [{"material": gilt, "variants": [0]}]
            s.json["meshes"][i]["primitives"][0]["extensions"] = {"KHR_materials_variants": {"mappings": mappings}}
    s.json["extensions"] = {"KHR_materials_variants": {"variants": [{"name": "festive"}]}}
    s.json["extensionsUsed"] += ["KHR_materials_variants"]
    return s


def rough():
    """Rough gold, clay, textured spheres and a white one on a floor, to be measured."""
    base = checker(256, 8, (230, 180, 60, 255), (40, 60, 120, 255))
    figures = png(256, 256, lambda x, y: (255, 40 + 200 * (x * 8 // 256 % 2), 255 * (y * 8 // 256 % 2), 255))
    s = Scene()
    tiled_floor(s, 8, 5)
    s.sphere(-2.3, s.material((1.0, 0.77, 0.34, 1), 1, 0.3))
    s.sphere(-1.15, s.material((0.7, 0.1, 0.08, 1), 0, 0.6))
    s.sphere(0, s.material((1, 1, 1, 1), 0, 0.3, textures={"baseColorTexture": s.texture(base)}))
    s.sphere(1.15, s.material((0.9, 0.85, 0.8, 1), 1, 1, textures={"metallicRoughnessTexture": s.texture(figures)}))
    s.sphere(2.3, s.material((0.8, 0.8, 0.8, 1), 0, 1))
    return s


SCENES = {f.__name__: f for f in (metal, plastic, metallic, ior, specular, clearcoat, sheen, anisotropy, iridescence, frosted,
                                  thin, emission, unlit, blend, textured, mask, colors, group, behind, lamps, moved, instances,
                                  variants, rough)}

if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[2:] or SCENES:
        SCENES[name]().write(folder / f"{name}.glb")
