#!/usr/bin/env python3
"""Files that mean harm, given to the whole program: one line of error, status 1, a second of CPU time, 200 MB.

usage: hostile_test.py PROGRAM [NAME...]    NAME: only the tests whose names contain it
"""
import os
import random
import resource
import struct
import subprocess
import sys
import zlib

import script_tests

PROGRAM = os.path.abspath(sys.argv[1])
MEASURED = os.environ.get("TUKOR_SANITIZED") is None  # sanitizers have time and memory of their own


def run(*arguments, folder):
    """Status, standard error; fails where it took too much."""
    process = subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=folder,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (20, 20)))
    said = process.stderr.read().decode(errors="replace")
    process.stderr.close()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    seconds, megabytes = usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024
    assert not MEASURED or (seconds < 1.0 and megabytes < 200), \
        f"{arguments}: {seconds:.2f} s and {megabytes:.0f} MB; said {said!r}"
    return process.returncode, said


def refused(*arguments, folder, says=""):
    status, said = run(*arguments, folder=folder)
    lines = [line for line in said.splitlines() if not line.startswith("tukor: warning: ")]
    assert status == 1 and len(lines) == 1 and lines[0].startswith("tukor: ") and says in lines[0], \
        f"{arguments}: status {status}, expected an error with {says!r}; said {said!r}"


def survived(*arguments, folder):
    """Damage that may be just another picture: read or refused, but within bounds."""
    status, said = run(*arguments, folder=folder)
    assert status in (0, 1), f"{arguments}: status {status}; said {said!r}"


def write(folder, name, data):
    with open(os.path.join(folder, name), "wb") as file:
        file.write(data)
    return name


def patched(data, at, new):
    return data[:at] + new + data[at + len(new):]


def damaged(data):
    """Some bytes changed, the same ones each time."""
    source = random.Random(7)
    changed = bytearray(data)
    for _ in range(max(4, len(data) // 50)):
        changed[source.randrange(len(changed))] = source.randrange(256)
    return bytes(changed)


def nan_exr(width, height):
    """Uncompressed, of one row a block, every value not a number."""
    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value

    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    header = b"\x76\x2f\x31\x01\x02\0\0\0" + attribute(b"channels", b"chlist", channels) + \
        attribute(b"compression", b"compression", b"\0") + attribute(b"dataWindow", b"box2i", box) + \
        attribute(b"displayWindow", b"box2i", box) + attribute(b"lineOrder", b"lineOrder", b"\0") + \
        attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)) + \
        attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)) + \
        attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"
    row = struct.pack("<f", float("nan")) * width * 3
    start = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", start + y * (8 + len(row))) for y in range(height))
    return header + offsets + b"".join(struct.pack("<ii", y, len(row)) + row for y in range(height))


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) + \
        chunk(b"IDAT", zlib.compress(b"\0" * 5000)) + chunk(b"IEND", b"")


def environments(folder):
    """A good file of each type, by extension."""
    files = {}
    for extension, more in ((".exr", []), (".hdr", []), (".png", []), (".jpg", []), (".dds", ["--format", "float"]),
                            (".ktx", ["--format", "float"]), (".ktx2", ["--format", "float"])):
        size = "32" if extension in (".exr", ".hdr", ".png", ".jpg") else "16"
        name = "good" + extension
        subprocess.run([PROGRAM, "environment", "convert", "sky", "-o", name, "--size", size, *more], cwd=folder,
                       check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, name), "rb") as file:
            files[extension] = file.read()
    return files


def test_environments(folder):
    files = environments(folder)
    two_to_the_31 = {
        ".exr": lambda data: patched(data, data.index(b"box2i") + 10 + 8, b"\xfe\xff\xff\x7f" * 2),
        ".hdr": lambda data: data.replace(b"-Y 16 +X 32", b"-Y 1073741824 +X 2147483647"),
        ".png": lambda data: png(0x7fffffff, 0x3fffffff),
        ".jpg": lambda data: patched(data, data.index(b"\xff\xc0") + 5, b"\xff\xff\xff\xff"),
        ".dds": lambda data: patched(data, 12, b"\xff\xff\xff\x7f" * 2),
        ".ktx": lambda data: patched(data, 36, b"\xff\xff\xff\x7f" * 2),
        ".ktx2": lambda data: patched(data, 20, b"\xff\xff\xff\x7f" * 2)}
    bad = {}
    for extension, data in files.items():
        bad["empty" + extension] = b""
        bad["start" + extension] = data[:12]
        bad["half" + extension] = data[:len(data) // 2]
        bad["huge" + extension] = two_to_the_31[extension](data)
        bad["text" + extension] = b"this is not a picture\n" * 100
        bad["zero" + extension] = bytes(100_000)
    # A file whose pixels are no numbers: the last 6 x 16 x 16 x 4 floats of a cube map are texels of some level.
    bad["nan.exr"] = nan_exr(64, 32)
    bad["large_nan.exr"] = nan_exr(1024, 512)
    for extension in (".dds", ".ktx", ".ktx2"):
        data = files[extension]
        start = {".dds": 148, ".ktx": 64 + struct.unpack_from("<I", data, 60)[0]}.get(extension)
        if extension == ".ktx2":
            start = min(struct.unpack_from("<Q", data, 80 + 24 * level)[0] for level in range(5))
        numbers = bytearray(data)
        for at in range(start + (4 if extension == ".ktx" else 0), start + 6 * 16 * 16 * 16, 4):
            if extension == ".ktx2" or at + 4 <= len(data):
                numbers[at:at + 4] = struct.pack("<f", float("nan"))
        if extension == ".ktx2":  # the largest level is the last in the file
            numbers[start:] = struct.pack("<f", float("nan")) * ((len(data) - start) // 4)
        bad["nan" + extension] = bytes(numbers[:len(data)])
    bad["aspect.png"] = png(100, 37)
    bad["png.dds"] = files[".png"]
    for name, data in bad.items():
        write(folder, name, data)
        refused("environment", "info", name, folder=folder, says=name)
        if not name.startswith(("text", "zero", "start")):
            refused("environment", "convert", name, "-o", "out.exr", "--size", "16", folder=folder, says=name)
    refused("environment", "filter", "half.dds", "-o", "out.ktx2", folder=folder, says="half.dds")
    refused("environment", "info", "none.ktx2", folder=folder, says="none.ktx2")
    os.mkdir(os.path.join(folder, "folder.dds"))
    refused("environment", "info", "folder.dds", folder=folder, says="folder.dds")
    for extension, data in files.items():
        survived("environment", "info", write(folder, "damaged" + extension, damaged(data)), folder=folder)
    assert not os.path.exists(os.path.join(folder, "out.exr")) and not os.path.exists(os.path.join(folder, "out.ktx2"))


def gltf(rest):
    return b'{"asset": {"version": "2.0"}, ' + rest + b"}"


def test_crafted_gltf(folder):
    """Lists of millions, which JSON makes cheap to write."""
    million = 1_000_000
    for name, text in (
            ("children", b'"nodes": [{"children": [' + b"0," * (3 * million) + b"0]}]"),
            ("few_children", b'"nodes": [{"children": [' + b"0," * (2 * million) + b"0]}]"),
            ("scene", b'"nodes": [{}], "scenes": [{"nodes": [' + b"0," * (3 * million) + b"0]}]"),
            ("nodes", b'"nodes": [' + b"{}," * (2 * million) + b"{}]"),
            ("some_nodes", b'"nodes": [' + b"{}," * million + b"{}]"),
            ("meshes", b'"meshes": [{"primitives": []}], "nodes": [' + b'{"mesh":0},' * (400_000) + b'{"mesh":0}]'),
            ("some_meshes", b'"meshes": [{"primitives": []}], "nodes": [' + b'{"mesh":0},' * (250_000) + b'{"mesh":0}]'),
            ("primitives", b'"nodes": [{"mesh": 0}], "meshes": [{"primitives": [' + b"{}," * million + b"{}]}]"),
            ("strings", b'"extras": [' + b'"",' * (2 * million) + b'""]'),
            ("accessors", b'"accessors": [' + b"[]," * (2 * million) + b"[]]"),
            ("members", b'"extras": {' + b",".join(b'"%x":0' % i for i in range(million)) + b"}"),
            ("buffers", b'"buffers": [' + b'{"byteLength":1},' * 300_000 + b'{"byteLength":1}]'),
            ("depth", b'"extras": ' + b"[" * (5 * million))):
        refused("render", write(folder, name + ".gltf", gltf(text)), "-o", "a.png", folder=folder, says=name + ".gltf")
        os.remove(os.path.join(folder, name + ".gltf"))


def models(folder):
    """A good file of each type, by extension."""
    triangle = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    accessor = b'"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", ' \
        b'"min": [0, 0, 0], "max": [1, 1, 0]}], "bufferViews": [{"buffer": 0, "byteLength": 36}], ' \
        b'"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], '
    json = gltf(accessor + b'"buffers": [{"byteLength": 36}]')
    json += b" " * (-len(json) % 4)
    glb = struct.pack("<III", 0x46546c67, 2, 12 + 8 + len(json) + 8 + 36) + \
        struct.pack("<II", len(json), 0x4e4f534a) + json + struct.pack("<II", 36, 0x004e4942) + triangle
    write(folder, "triangle.bin", triangle)
    ply = b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" \
        b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + triangle + \
        struct.pack("<B3i", 3, 0, 1, 2)
    dae = b'<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">' \
        b"<library_geometries/></COLLADA>"
    return {".gltf": gltf(accessor + b'"buffers": [{"byteLength": 36, "uri": "triangle.bin"}]'), ".glb": glb,
            ".obj": b"mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n", ".ply": ply,
            ".stl": bytes(80) + struct.pack("<I", 1) + bytes(12) + triangle + bytes(2), ".dae": dae}


def test_models(folder):
    files = models(folder)
    write(folder, "a.mtl", b"newmtl m\nKd 1 1 1\n")
    nan = struct.pack("<f", float("nan"))
    bad = {"nan.obj": b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "nan.stl": files[".stl"].replace(files[".stl"][96:132], nan * 9),
           "nan.ply": files[".ply"].replace(files[".stl"][96:132], nan * 9),
           "nan.glb": files[".glb"][:-36] + nan * 9,
           "huge.stl": patched(files[".stl"], 80, b"\xff\xff\xff\x7f"),
           "huge.ply": files[".ply"].replace(b"vertex 3", b"vertex 2147483647"),
           "huge_faces.ply": files[".ply"].replace(b"face 1", b"face 2147483647"),
           "huge_list.ply": files[".ply"].replace(b"uchar int", b"uint int"),
           "huge.obj": b"v 0 0 0\nf 1 2147483647 3\n",
           "huge.gltf": files[".gltf"].replace(b'"count": 3', b'"count": 2147483648'),
           "huge_buffer.gltf": files[".gltf"].replace(b'"byteLength": 36, "uri"', b'"byteLength": 2147483648, "uri"'),
           "huge.glb": patched(files[".glb"], 12, b"\xff\xff\xff\x7f"),
           "outside.gltf": files[".gltf"].replace(b"triangle.bin", b"../triangle.bin"),
           "folder.obj": None}
    for extension in [*files, ".fbx", ".3ds", ".x", ".blend", ".lwo", ".3mf", ".x3d", ".ac", ".ms3d"]:
        bad["empty" + extension] = b""
        bad["zero" + extension] = bytes(100_000)
        bad["text" + extension] = b"this is not a model\n" * 100
        if extension in files:
            bad["half" + extension] = files[extension][:len(files[extension]) // 2]
    for name, data in bad.items():
        if data is None:
            os.mkdir(os.path.join(folder, name))
        else:
            write(folder, name, data)
        refused("render", name, "-o", "a.png", "--size", "8x8", "--samples", "1", folder=folder, says=name)
    for extension, data in files.items():
        survived("render", write(folder, "damaged" + extension, damaged(data)), "-o", "a.png", "--size", "8x8", "--samples",
                 "1", folder=folder)


script_tests.main(dict(globals()), sys.argv[2:])
