#!/usr/bin/env python3
"""Files of `tukor environment convert` in the hands of other programs: OpenImageIO, Blender, Filament's cmgen,
three.js.

usage: other_tools_test.py TUKOR
needs: openimageio-tools, blender, libfilament-tools, chromium, node and npm (which fetches three)
"""
import glob
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

TUKOR = sys.argv[1]
HERE = os.path.dirname(os.path.abspath(__file__))


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def close(found, expected, relative, what):
    assert len(found) == len(expected) and all(abs(a - b) <= relative * abs(b) for a, b in zip(found, expected)), \
        f"{what}: {found}; expected {expected}"


def channel_means(path):
    """As OpenImageIO reads it."""
    stats = run("oiiotool", "--stats", path)
    line = re.search(r"Stats Avg: ([^\n(]*)", stats)
    assert line, stats
    return [float(word) for word in line.group(1).split()[:3]]


def coloured_panorama(path):
    """A world whose every direction is its colour, -Z in the middle: 0.5 + 0.5 d in the codes of a .png."""
    width, height = 512, 256
    pixels = bytearray()
    for row in range(height):
        polar = math.pi * (row + 0.5) / height
        for column in range(width):
            longitude = 2 * math.pi * ((column + 0.5) / width - 0.5)
            direction = (math.sin(polar) * math.sin(longitude), math.cos(polar), -math.sin(polar) * math.cos(longitude))
            pixels += bytes(round(255 * (0.5 + 0.5 * d)) for d in direction)
    with open(f"{path}.ppm", "wb") as file:
        file.write(f"P6 {width} {height} 255\n".encode() + pixels)
    run("oiiotool", f"{path}.ppm", "-o", path)


def worst_difference(one, other):
    """Of any channel of any pixel."""
    result = subprocess.run(["oiiotool", one, other, "--diff"], capture_output=True, text=True)
    return float(re.search(r"Max error *= *([0-9.e+-]+)", result.stdout).group(1))


def test_openimageio(folder):
    """The same mean out of every file type that it reads."""
    run(TUKOR, "environment", "convert", "sky", "-o", f"{folder}/a.exr", "--size", "256")
    expected = channel_means(f"{folder}/a.exr")
    for name, more, error in [("half.exr", ["--exr-pixels", "half"], 1e-3), ("a.hdr", [], 8e-3)]:
        run(TUKOR, "environment", "convert", f"{folder}/a.exr", "-o", f"{folder}/{name}", *more)
        close(channel_means(f"{folder}/{name}"), expected, error, name)
    for name in ("a.png", "a.jpg"):
        run(TUKOR, "environment", "convert", f"{folder}/a.exr", "-o", f"{folder}/{name}")
        assert "256 x  128, 3 channel" in run("oiiotool", "--info", f"{folder}/{name}"), name
    # BC6H: every face of a cube map as we decode it ourselves, bit for bit.
    run(TUKOR, "environment", "convert", f"{folder}/a.exr", "-o", f"{folder}/cube.dds", "--format", "bc6h", "--size", "64")
    run(TUKOR, "environment", "convert", f"{folder}/cube.dds", "-o", f"{folder}/ours_{{}}.exr", "--format", "float")
    for i, face in enumerate(("px", "nx", "py", "ny", "pz", "nz")):
        run("oiiotool", f"{folder}/cube.dds", "--cut", f"64x64+0+{64 * i}", "-d", "float", "-o", f"{folder}/theirs.exr")
        run("oiiotool", f"{folder}/theirs.exr", f"{folder}/ours_{face}.exr", "--diff")


def test_blender(folder):
    """`--to blender`: what looks along -Z here, Blender sees along +Y (its axes are turned upright)."""
    # A panorama with one bright place, in the middle: -Z.
    with open(f"{folder}/spot.ppm", "wb") as file:
        pixels = bytearray(b"\x10\x10\x10" * 64 * 32)
        for row in range(14, 18):
            for column in range(30, 34):
                at = 3 * (64 * row + column)
                pixels[at:at + 3] = b"\xff\xff\xff"
        file.write(b"P6 64 32 255\n" + pixels)
    run("oiiotool", f"{folder}/spot.ppm", "-o", f"{folder}/spot.png")
    run(TUKOR, "environment", "convert", f"{folder}/spot.png", "-o", f"{folder}/spot.exr", "--to", "blender")
    with open(f"{folder}/look.py", "w", encoding="utf-8") as file:
        file.write(f"""
import bpy, math
scene = bpy.context.scene
scene.render.engine = 'CYCLES'
scene.cycles.samples = 1
scene.cycles.use_denoising = False
scene.cycles.device = 'CPU'
scene.view_settings.view_transform = 'Standard'
scene.render.resolution_x = scene.render.resolution_y = 8
for item in list(bpy.data.objects):
    bpy.data.objects.remove(item)
world = bpy.data.worlds.new('w')
scene.world = world
world.use_nodes = True
node = world.node_tree.nodes.new('ShaderNodeTexEnvironment')
node.image = bpy.data.images.load('{folder}/spot.exr')
world.node_tree.links.new(node.outputs[0], world.node_tree.nodes['Background'].inputs[0])
camera = bpy.data.objects.new('c', bpy.data.cameras.new('c'))
camera.data.angle = math.radians(10)
scene.collection.objects.link(camera)
scene.camera = camera
scene.render.image_settings.file_format = 'OPEN_EXR'
# A glTF camera that looks along -Z looks along Blender's +Y.
for name, turn in [('front', 0), ('left', 90), ('back', 180), ('right', 270)]:
    camera.rotation_euler = (math.radians(90), 0, math.radians(turn))
    scene.render.filepath = '{folder}/' + name + '.exr'
    bpy.ops.render.render(write_still=True)
""")
    run("blender", "-b", "--factory-startup", "-noaudio", "-P", f"{folder}/look.py")
    seen = {name: channel_means(f"{folder}/{name}.exr")[0] for name in ("front", "left", "back", "right")}
    assert seen["front"] > 0.9 and max(seen[name] for name in ("left", "back", "right")) < 0.1, seen


def test_cmgen(folder):
    """Filament's tool finds the same light in our panorama and in our cross."""
    run(TUKOR, "environment", "convert", "studio", "-o", f"{folder}/studio.hdr", "--size", "512")
    run(TUKOR, "environment", "convert", f"{folder}/studio.hdr", "-o", f"{folder}/cross.hdr", "--layout", "hcross",
        "--size", "256")

    def harmonics(path):
        run("cmgen", "-q", "--no-mirror", "--sh=1", f"--sh-output={folder}/sh.txt", path)
        with open(f"{folder}/sh.txt", encoding="utf-8") as file:
            return [float(word) for word in re.search(r"\(([^)]*)\)", file.readline()).group(1).split(",")]

    close(harmonics(f"{folder}/cross.hdr"), harmonics(f"{folder}/studio.hdr"), 0.01, "mean radiance by cmgen")

    # `--to filament`: the faces that cmgen makes of our panorama and takes from our cross are our faces.
    coloured_panorama(f"{folder}/world.png")
    for name, more in [("panorama.hdr", []), ("cross.hdr", ["--layout", "hcross", "--size", "64"]),
                       ("face_{}.exr", ["--size", "64"])]:
        run(TUKOR, "environment", "convert", f"{folder}/world.png", "-o", f"{folder}/{name}", "--to", "filament", *more)
    for name, more in [("panorama.hdr", []), ("cross.hdr", ["--no-mirror"])]:
        run("cmgen", "-q", "--size=64", "--format=exr", f"--extract={folder}/{name}_faces", *more, f"{folder}/{name}")
        for face in ("px", "nx", "py", "ny", "pz", "nz"):
            theirs = glob.glob(f"{folder}/{name}_faces/**/{face}.exr", recursive=True)[0]
            # A quarter of a texel of linear interpolation, and the eight bits of .hdr; a mirrored face differs by 1.
            worst = worst_difference(theirs, f"{folder}/face_{face}.exr")
            assert worst < 0.03, f"{name}: {face} differs by {worst}"


def unpack_three(folder):
    run("npm", "pack", "--silent", "--pack-destination", folder, "three@0.187.0")
    run("tar", "-xzf", f"{folder}/three-0.187.0.tgz", "-C", folder)


def test_three(folder):
    """three.js's loaders read the same pixels."""
    unpack_three(folder)
    run(TUKOR, "environment", "convert", "sky", "-o", f"{folder}/expected.exr", "--size", "256")

    def write(name, *more):
        run(TUKOR, "environment", "convert", f"{folder}/expected.exr", "-o", f"{folder}/{name}", *more)

    write("half.exr", "--exr-pixels", "half")
    write("a.hdr")
    write("face_{}.exr", "--size", "64")
    write("half.ktx2", "--size", "64")
    write("float.ktx2", "--size", "64", "--format", "float")
    write("zstd.ktx2", "--size", "64", "--compression", "zstd")
    write("bc6h.dds", "--size", "64", "--format", "bc6h")
    print(run("node", f"{HERE}/three_loaders.mjs", f"{folder}/package", folder),
          end="")


def test_three_directions(folder):
    """`--to three`: three.js shows every direction of a panorama and of six faces where it is."""
    unpack_three(folder)
    coloured_panorama(f"{folder}/world.png")
    for name, more in [("panorama.png", []), ("face_{}.png", ["--size", "256"])]:
        run(TUKOR, "environment", "convert", f"{folder}/world.png", "-o", f"{folder}/{name}", "--to", "three", *more)
    shutil.copy(f"{HERE}/three_directions.html", folder)
    page = run("chromium", "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
               "--allow-file-access-from-files", "--virtual-time-budget=20000", "--dump-dom",
               f"file://{folder}/three_directions.html")
    result = re.search(r'<pre id="result">([^<]*)</pre>', page).group(1)
    print(result)
    seen = dict(line.split() for line in result.splitlines())
    # Codes are interpolated, at the poles across pixels a degree wide: a turned or mirrored face differs by 255.
    assert set(seen) == {"panorama", "faces"} and max(map(float, seen.values())) < 6, result


def main():
    for test in (test_openimageio, test_blender, test_cmgen, test_three, test_three_directions):
        with tempfile.TemporaryDirectory() as folder:
            test(folder)
            print(f"{test.__name__}: passed")


main()
