#!/usr/bin/env python3
"""Drives the window of `tukor view` by real input events on a virtual display.

usage: view_test.py PROGRAM [FOLDER]    FOLDER keeps the pictures

Needs Xvfb, xdotool and xclip; exits with 77, skipped, without them.
"""
import base64
import json
import os
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import time

import x11_drop

PROGRAM = os.path.abspath(sys.argv[1])
PATIENCE = 60  # seconds; software rendering on a busy machine


def wait_for(what, condition):
    """The first true value of condition()."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.1)
    raise AssertionError(f"waited {PATIENCE} s for {what}")


def xdotool(*arguments):
    """Sends events; its standard output."""
    return subprocess.run(["xdotool", *map(str, arguments)], check=True, capture_output=True, text=True).stdout


class Display:
    """A virtual screen, named by DISPLAY while it lives."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x900x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number_file:  # to its end: the server writes the number in two pieces
            number = number_file.readline().strip()
        os.environ["DISPLAY"] = f":{number}"
        os.environ.pop("WAYLAND_DISPLAY", None)
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Viewer:
    """A running `tukor view` whose screenshots go into `folder`."""

    def __init__(self, folder, *arguments):
        self.folder = folder
        self.errors = open(os.path.join(folder, "stderr.txt"), "w+", encoding="utf-8")
        self.process = subprocess.Popen([PROGRAM, "view", *arguments], cwd=folder, stderr=self.errors)
        self.window = wait_for("the window", self.find_window)
        xdotool("windowfocus", "--sync", self.window)
        self.pictures = 0

    def find_window(self):
        assert self.process.poll() is None, f"the program ended with {self.process.returncode}: {self.said()}"
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(self.process.pid)],
                               capture_output=True, text=True).stdout.split()
        return found[0] if found else None

    def said(self):
        with open(self.errors.name, encoding="utf-8") as file:
            return file.read()

    def picture(self):
        """Presses F12; the new file."""
        self.pictures += 1
        path = os.path.join(self.folder, f"tukor-{self.pictures:04}.png")
        assert not os.path.exists(path)
        xdotool("key", "F12")
        wait_for(path, lambda: os.path.exists(path))
        return path

    def drag(self, start, end, button=1):
        xdotool("mousemove", "--window", self.window, *start)
        time.sleep(0.3)
        xdotool("mousedown", button)
        time.sleep(1.5)  # a slow frame: what is under the mouse then is what it took
        steps = 8
        for i in range(1, steps + 1):
            xdotool("mousemove", "--window", self.window, *(round(a + (b - a) * i / steps) for a, b in zip(start, end)))
            time.sleep(0.05)
        time.sleep(1.0)
        xdotool("mouseup", button)
        time.sleep(0.3)

    def click(self, place, button=1, repeat=1):
        xdotool("mousemove", "--window", self.window, *place)
        time.sleep(0.3)
        xdotool("click", "--repeat", repeat, "--delay", 80, button)
        time.sleep(0.3)

    def processor_seconds(self):
        with open(f"/proc/{self.process.pid}/stat", encoding="ascii") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def close(self):
        xdotool("key", "ctrl+q")
        assert self.process.wait(timeout=PATIENCE) == 0, self.said()


def rmse(a, b):
    """As `tukor compare` has it, in 8-bit codes."""
    out = subprocess.run([PROGRAM, "compare", a, b], check=True, capture_output=True, text=True).stdout
    return float(re.search(r"RMSE ([0-9.]+)", out).group(1))


def size_of(path):
    with open(path, "rb") as file:
        return struct.unpack(">II", file.read(24)[16:])


def test_window(folder):
    """Every way to move, a save, the command that reproduces it, resizing, idleness."""
    viewer = Viewer(folder, "torus-knot", "--fidelity", "single", "--size", "640x360", "--samples", "16", "--renderer",
                    "trace", "--error", "2", "--aov", "depth")  # which are for trace: said, and not copied
    xdotool("key", "Tab")  # hides the panel, so that all of the picture takes the mouse
    first = viewer.picture()
    assert size_of(first) == (640, 360)

    viewer.drag((320, 180), (440, 220))
    turned = viewer.picture()
    assert rmse(first, turned) > 5, "a drag does not turn"
    viewer.drag((320, 180), (260, 180), button=3)
    moved = viewer.picture()
    assert rmse(turned, moved) > 5, "a right drag does not move"
    viewer.click((320, 180), button=4, repeat=3)
    near = viewer.picture()
    assert rmse(moved, near) > 3, "the wheel does not go nearer"
    viewer.click((380, 180), repeat=2)
    focused = viewer.picture()
    assert rmse(near, focused) > 1, "a double click does not focus"
    xdotool("key", "--repeat", 3, "minus")
    far = viewer.picture()
    assert rmse(focused, far) > 3, "the minus key does not go farther"

    for key in ("KP_Add", "plus", "equal"):
        xdotool("key", key)
    assert rmse(focused, viewer.picture()) < 0.5, "signs do not go nearer again by as much"
    for key in ("KP_Subtract", "minus", "KP_Subtract"):
        xdotool("key", key)
    assert rmse(far, viewer.picture()) < 0.5, "the number pad's minus does not go farther"

    words = copied_command(viewer)
    assert words[:3] == ["tukor", "render", "torus-knot"] and words[-2:] == ["-o", "picture.png"], words
    again = os.path.join(folder, "again.png")
    subprocess.run([PROGRAM, *words[1:-1], again], check=True)
    assert rmse(far, again) < 0.5, f"another picture: {words}"
    with open(far, "rb") as file:
        assert b"--samples 16 --fidelity single --renderer gl" in file.read(), "the picture tells of another command"

    xdotool("key", "Home")
    home = viewer.picture()
    assert rmse(first, home) < 0.5, "Home does not show the whole model as at first"

    time.sleep(8)  # the notices go away
    before = viewer.processor_seconds()
    time.sleep(3)
    assert viewer.processor_seconds() - before < 0.1, "an idle window keeps a processor busy"

    xdotool("windowsize", viewer.window, 500, 400)
    time.sleep(1)
    assert size_of(viewer.picture()) == (500, 400)
    xdotool("key", "Tab")
    viewer.drag((40, 86), (60, 106))  # on the panel: the picture stays
    viewer.close()
    assert viewer.said() == "", viewer.said()


def copied_command(viewer):
    """The words of the command that Ctrl+C copies."""
    xdotool("key", "ctrl+c")
    time.sleep(1)
    command = subprocess.run(["xclip", "-o", "-selection", "clipboard"], check=True, capture_output=True, text=True,
                             timeout=PATIENCE).stdout
    return shlex.split(command)


def test_drops(folder):
    """Models and environments dropped onto the window; what is no model is refused, and nothing lost."""
    viewer = Viewer(folder, "sphere", "--material", "gold", "--fidelity", "single", "--size", "320x240", "--samples", "4")
    xdotool("key", "Tab")
    ball = viewer.picture()
    light = os.path.join(folder, "ein Himmel.hdr")
    subprocess.run([PROGRAM, "environment", "convert", "sky", "-o", light, "--layout", "equirect", "--size", "64"], check=True)
    x11_drop.drop(int(viewer.window), light)
    under_sky = viewer.picture()
    assert rmse(ball, under_sky) > 5, "the dropped environment does not light"
    model = os.path.join(folder, "wedge.obj")
    with open(model, "w", encoding="ascii") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
    x11_drop.drop(int(viewer.window), model)
    wedge = viewer.picture()
    assert rmse(under_sky, wedge) > 5, "the dropped model does not show"
    words = copied_command(viewer)
    assert model in words and light in words, words
    cube = os.path.join(folder, "cube.ktx2")
    subprocess.run([PROGRAM, "environment", "convert", "studio", "-o", cube, "--size", "64"], check=True)
    x11_drop.drop(int(viewer.window), cube)
    assert rmse(wedge, viewer.picture()) > 5, "the dropped texture does not light"
    words = copied_command(viewer)
    assert words[2] == model and words[words.index("--environment") + 1] == cube and "gold" not in words, words
    x11_drop.drop(int(viewer.window), os.path.join(folder, "wedge.mtl"), model, wedge)
    time.sleep(1)
    assert copied_command(viewer) == words, "a neighbour of the model was taken, too"
    junk = os.path.join(folder, "junk.glb")
    with open(junk, "wb") as file:
        file.write(b"glTF, says who?")
    x11_drop.drop(int(viewer.window), junk)
    time.sleep(1)
    assert copied_command(viewer) == words, "a file that cannot be read changes what is shown"
    viewer.close()


def test_panel(folder):
    """Figures typed, levels compared, the divider drawn aside."""
    viewer = Viewer(folder, "sphere", "--material", "iron", "--fidelity", "single", "--size", "900x760", "--samples", "4")
    # Where the widgets are: rows of 24 pixels with the font that the window prefers, 23 with its own.
    row = 1.0 if os.path.exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf") else 23 / 24
    exact = viewer.picture()
    viewer.pictures += 1
    saved = os.path.join(folder, f"tukor-{viewer.pictures:04}.png")
    viewer.click((58, round(40 * row)))  # the button
    wait_for(saved, lambda: os.path.exists(saved))
    assert rmse(exact, saved) < 0.5, "the button saves another picture"
    viewer.click((26, round(580 * row)))  # compare with Schlick's approximation
    half = viewer.picture()
    assert rmse(exact, half) > 1, "nothing is compared"
    viewer.drag((450, 380), (860, 380))  # past the ball
    assert rmse(exact, viewer.picture()) < 0.5 * rmse(exact, half), "the divider does not move"
    viewer.click((26, round(580 * row)))
    assert rmse(exact, viewer.picture()) < 0.5, "the comparison does not end, or the divider's drag turned the model"
    viewer.click((90, round(229 * row)))
    xdotool("type", "--delay", 60, "mirror:1+rough:0.4")
    xdotool("key", "Return")
    xdotool("mousemove", "--window", viewer.window, 700, 700)
    wait_for("the figures to be taken", lambda: rmse(exact, viewer.picture()) > 5)
    viewer.click((700, 700))  # out of the text
    words = copied_command(viewer)
    assert words[words.index("--material") + 1] == "mirror:1+rough:0.4", words
    viewer.close()


def test_animation(folder):
    """A model plays, and pauses; the command is that of the moment."""
    data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<2f", 0, 2) + struct.pack("<6f", 0, 0, 0, 0, -1, 0)
    accessors = [{"bufferView": 0, "componentType": 5126, "type": kind, "count": count, "byteOffset": offset}
                 for kind, count, offset in (("VEC3", 3, 0), ("SCALAR", 2, 36), ("VEC3", 2, 44))]
    document = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(data), "uri": "data:;base64," + base64.b64encode(data).decode()}],
                "bufferViews": [{"buffer": 0, "byteLength": len(data)}], "accessors": accessors,
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}],
                "animations": [{"samplers": [{"input": 1, "output": 2}],
                                "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]}
    with open(os.path.join(folder, "falling.gltf"), "w", encoding="ascii") as file:
        json.dump(document, file)
    viewer = Viewer(folder, "falling.gltf", "--fidelity", "single", "--size", "700x400", "--samples", "4")
    row = 1.0 if os.path.exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf") else 23 / 24
    rest = viewer.picture()
    button = (34, round(179 * row))
    viewer.click(button)  # play
    time.sleep(1)
    viewer.click(button)  # pause
    moment = viewer.picture()
    words = copied_command(viewer)
    assert 0 < float(words[words.index("--time-seconds") + 1]) < 2, words
    assert rmse(rest, moment) > 1, "nothing moves"
    viewer.close()


def test_layout(folder):
    """Keys are what they type: of a French keyboard q is where that of the US has a."""
    subprocess.run(["setxkbmap", "fr"], check=True)
    try:
        viewer = Viewer(folder, "sphere", "--fidelity", "single", "--size", "320x240", "--samples", "4")
        xdotool("key", "Tab")
        first = viewer.picture()
        xdotool("key", "minus")  # there with 6
        assert rmse(first, viewer.picture()) > 1, "the minus does not go farther"
        viewer.close()
    finally:
        subprocess.run(["setxkbmap", "us"], check=True)


def test_wrong_start(folder):
    """What is wrong with the arguments is said before a window opens."""
    result = subprocess.run([PROGRAM, "view", "none.obj"], capture_output=True, text=True, cwd=folder, timeout=PATIENCE)
    assert result.returncode == 1 and result.stderr.startswith("tukor: none.obj: "), result


def main():
    if not all(map(shutil.which, ("Xvfb", "xdotool", "xclip"))):
        print("skipped: needs Xvfb, xdotool and xclip")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder, Display():
        if len(sys.argv) > 2:
            folder = sys.argv[2]
            os.makedirs(folder, exist_ok=True)
        for test in (test_window, test_drops, test_panel, test_animation, test_layout, test_wrong_start):
            own = os.path.join(folder, test.__name__)
            os.makedirs(own, exist_ok=True)
            test(own)
            print(f"ok      {test.__name__}")


main()
