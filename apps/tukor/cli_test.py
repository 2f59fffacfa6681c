#!/usr/bin/env python3
"""Runs the `tukor` program as people do and reads what it says.

usage: cli_test.py PROGRAM [NAME...]    NAME: only the tests whose names contain it
"""
import glob
import json
import os
import pty
import re
import signal
import struct
import subprocess
import sys
import time
import zlib

import script_tests

PROGRAM = os.path.abspath(sys.argv[1])
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def run(*arguments, status=0, folder=None):
    """Standard output and error; the exit status must be as expected."""
    result = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120, cwd=folder,
                            errors="replace")
    said = f"{' '.join(arguments)}: status {result.returncode}, expected {status}\n{result.stdout}{result.stderr}"
    assert result.returncode == status, said[-3000:]
    return result.stdout, result.stderr


def fails(*arguments, says, status=1, folder=None):
    """One line of error that begins with the program's name and contains `says`."""
    out, err = run(*arguments, status=status, folder=folder)
    line = err.splitlines()[0]
    assert line.startswith("tukor: ") and says in line, f"{arguments}: expected {says!r} in {err!r}"
    assert out == "", out
    if status == 2:
        assert err.splitlines()[1].startswith("Try `tukor"), err
    else:
        assert len(err.splitlines()) == 1, err


def write_png(path, width, height, pixel):
    """An 8-bit RGB PNG whose pixels are pixel(column, row)."""
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def test_help_teaches(folder):
    out, _ = run("--help")
    for word in ("Usage: tukor COMMAND", "render", "view", "materials", "compare", "Examples", "--version"):
        assert word in out, word
    out, _ = run("compare", "--help")
    assert "Usage: tukor compare A B [options]" in out and "--heat-map OUT" in out, out
    assert "\n\n\n" not in out
    assert max(len(line) for line in out.splitlines()) <= 100


def test_version(folder):
    out, _ = run("--version")
    assert out.startswith("tukor ") and out[6].isdigit(), out


def test_no_command_shows_help(folder):
    _, err = run(status=2)
    assert "Usage: tukor COMMAND" in err, err


def test_misspelt_words(folder):
    fails("compar", says="'compar' is unknown; did you mean compare?", status=2)
    fails("compare", "a", "b", "--heat-mop", "c", says="unknown option --heat-mop; did you mean --heat-map?", status=2)
    fails("compare", "a", "b", "c", says="unexpected argument 'c'", status=2)
    fails("compare", "a", says="B is required", status=2)
    fails("materials", "--xml", says="unknown option --xml", status=2)
    for given, nearest in (("--exposur=1", "--exposure"), ("-size", "--size"), ("--sampels", "--samples"), ("--avo", "--aov")):
        fails("render", "sphere", given, says=f"unknown option {given.split('=')[0]}; did you mean {nearest}?", status=2)
    _, err = run("render", "sphere", "--widht", "3", status=2)
    assert err.splitlines()[0] == "tukor: unknown option --widht", err


def test_materials(folder):
    out, _ = run("materials")
    assert "metal:0.21,0.485,1.29/3.13,2.23,1.76" in out and "ior:1.333" in out, out
    assert "gold+rough:0.2" in out and "matt:0.8,0.2,0.1" in out, out
    materials = {row["name"]: row for row in json.loads(run("materials", "--json")[0])}
    assert materials["gold"]["eta"] == [0.21, 0.485, 1.29] and materials["gold"]["k"] == [3.13, 2.23, 1.76]
    assert materials["silver"]["eta"] == [0.15, 0.14, 0.13] and materials["silver"]["k"] == [3.7, 3.11, 2.47]
    assert materials["glass"]["eta"][0] == 1.46 and materials["water"]["eta"][0] == 1.333
    assert all(row["source"] for row in materials.values())


def test_compare(folder):
    a, b, small = (os.path.join(folder, name) for name in ("a.png", "b.png", "small.png"))
    write_png(a, 8, 4, lambda x, y: (100, 100, 100))
    write_png(b, 8, 4, lambda x, y: (103, 103, 103))
    write_png(small, 4, 4, lambda x, y: (0, 0, 0))
    assert "3.0" in run("compare", a, b)[0]
    run("compare", a, b, "--max-rmse", "3.01")
    run("compare", a, b, "--max-rmse", "2.99", status=1)
    heat = os.path.join(folder, "heat.png")
    run("compare", a, b, "--heat-map", heat)
    assert os.path.getsize(heat) > 0
    fails("compare", a, small, says="8 x 4")
    fails("compare", a, os.path.join(folder, "none.png"), says="none.png")
    fails("compare", a, b, "--heat-map", "heat.bmp", says="heat.bmp")
    fails("compare", a, b, "--max-rmse", "many", says="--max-rmse: 'many' is not a number", status=2)


def small(*arguments, out):
    """A picture that takes no time."""
    return run("render", *arguments, "--size", "64x36", "--samples", "4", "-o", out)


def test_render_help(folder):
    out, _ = run("render", "--help")
    for word in ("Usage: tukor render MODEL... [options] -o OUT", "--fidelity single|double|exact", "(default exact)",
                 "-o, --output OUT", "Examples", "torus-knot", "--eye X,Y,Z"):
        assert word in out, word
    assert max(len(line) for line in out.splitlines()) <= 100


def test_render_usage(folder):
    fails("render", says="MODEL: is missing", status=2)
    fails("render", "sphere", says="-o OUT: is missing", status=2)
    fails("render", "sphere", "--colour", "red", "-o", "a.png", says="unknown option --colour", status=2)
    fails("render", "sphere", "--enviroment", "sky", says="unknown option --enviroment; did you mean --environment?",
          status=2)
    for flag, value, says in (
            ("--eye", "1,2", "--eye: '1,2' is not a vector; X,Y,Z expected, as in 0,1.5,-4"),
            ("--eye", "0,nan,0", "--eye: 'nan' is not a number"),
            ("--eye", "0,1e9,0", "--eye: 1000000000 is out of range; -1000000 to 1000000 expected"),
            ("--size", "640", "--size: '640' is not a size; WxH expected, as in 1280x720"),
            ("--size", "0x10", "--size: 0 is out of range; 1 to 16384 expected"),
            ("--size", "16384x16384", "at most 100 million expected"),
            ("--fov", "180", "--fov: 180 is out of range; 0.1 to 175 expected"),
            ("--samples", "0", "--samples: 0 is out of range; 1 to 65536 expected"),
            ("--samples", "2.5", "--samples: '2.5' is not a whole number"),
            ("--fidelity", "exat", "--fidelity: 'exat' is unknown; did you mean exact? known are: single, double, exact"),
            ("--tonemap", "aces2", "--tonemap: 'aces2' is unknown; did you mean aces?"),
            ("--environment", "", "--environment: is empty"),
    ):
        fails("render", "sphere", flag, value, "-o", "a.png", says=says, status=2)
    fails("render", "sphere", "-o", "a.png", "--fov", says="--fov", status=2)


def test_render_errors(folder):
    here = lambda name: os.path.join(folder, name)
    fails("render", "sphere", "-o", here("a.bmp"), says="a.bmp")
    fails("render", "sphere", "-o", here("a"), says=".png")
    fails("render", "sphere", "-o", here("none/a.png"), says=f"there is no folder {folder}/none")
    os.mkdir(here("folder.png"))
    fails("render", "sphere", "-o", here("folder.png"), says="is a folder; a file name expected")
    fails("render", "sphere", "-o", "/proc/a.png", says="/proc/a.png: cannot write into /proc")
    out = ("-o", here("a.png"))
    fails("render", "none.obj", *out, says="none.obj")
    fails("render", "spere", *out, says="spere")
    fails("render", "sphere", "--material", "glas", *out, says="did you mean 'glass'")
    fails("render", "sphere", "--material", "lid=glass", *out, says="lid")
    fails("render", "sphere", "--material", "gold+rough:2", *out, says="material 'gold+rough:2': roughness 2; expected 0 to 1")
    fails("render", "sphere", "--environment", "none.hdr", *out, says="none.hdr")
    fails("render", "sphere", "--environment", "stdio", *out, says="stdio")
    fails("render", "sphere", "--camera", "front", *out, says="camera 'front': the model has no cameras")
    fails("render", "sphere", "--variant", "red", *out, says="variant 'red': the model has no variants")
    fails("render", "sphere", "--animation", "walk", *out, says="animation 'walk': the model has no animations")
    fails("render", "sphere", "--time-seconds", "1", *out, says="time-seconds 1: the model has no animations")
    fails("render", "sphere", "--eye", "1,2,3", "--target", "1,2,3", *out, says="eye and target are both 1,2,3")
    fails("render", "sphere", "--up", "0,0,0", *out, says="up is 0,0,0")
    for name, content in (("a.obj", b"not a model"), ("b.glb", b"glTF\2\0\0\0"), ("c.stl", b""), ("d.ply", b"ply\n")):
        with open(here(name), "wb") as file:
            file.write(content)
        fails("render", here(name), *out, says=name)
    with open(here("sky.hdr"), "wb") as file:
        file.write(b"#?RADIANCE\n\n-Y 2000000000 +X 2000000000\n")
    fails("render", "sphere", "--environment", here("sky.hdr"), *out, says="sky.hdr")
    assert not os.path.exists(here("a.png"))
    assert os.listdir(folder) and not any(name.startswith(".tukor") for name in os.listdir(folder))


def test_render_writes_every_format(folder):
    for name, magic in (("a.png", b"\x89PNG"), ("a.jpg", b"\xff\xd8"), ("a.exr", b"\x76\x2f\x31\x01"),
                        ("a.hdr", b"#?RADIANCE")):
        out, err = small("sphere", "--material", "glass", "--eye", "-1,0,4", "--target", "-.5,0,0",
                         out=os.path.join(folder, name))
        assert out == "" and err == "", (out, err)
        with open(os.path.join(folder, name), "rb") as file:
            content = file.read()
        assert content.startswith(magic), name
        if name != "a.jpg":
            assert b"tukor render sphere --material glass --eye -1,0,4" in content, f"{name} has no command line"
    run("compare", os.path.join(folder, "a.exr"), os.path.join(folder, "a.hdr"), "--max-rmse", "1")


def test_render_merges_models(folder):
    one, both, again = (os.path.join(folder, name) for name in ("one.exr", "both.exr", "again.exr"))
    view = ("--eye", "0,0,6", "--target", "0,0,0", "--fidelity", "single")
    small("torus-knot", *view, out=one)
    small("torus-knot", "sphere", *view, "--material", "torus*=silver", out=both)
    run("compare", one, both, "--max-rmse", "1", status=1)
    small("torus-knot", *view, out=again)
    run("compare", one, again, "--max-rmse", "0")


def test_print_options(folder):
    out, _ = run("render", "sphere", "--eye", "-1,0,4", "--samples", "8", "--print-options")
    options = json.loads(out)
    assert options["model"] == ["sphere"] and options["eye"] == [-1, 0, 4] and options["samples"] == 8
    assert options["target"] is None and options["fidelity"] == "exact" and options["size"] == "1280x720"


def test_trace_options(folder):
    out = os.path.join(folder, "a.exr")
    small("tumbler", "--aov", "depth,normal,bounces", out=out)
    with open(out, "rb") as file:
        header = file.read(2000)
    for channel in (b"depth.", b"normal.", b"bounces."):
        assert channel in header, channel
    fails("render", "sphere", "--aov", "depth", "-o", os.path.join(folder, "a.png"), says="only .exr holds the layers")
    for option in ("--aov=depth", "--error=1", "--time=1"):
        fails("render", "sphere", "--renderer", "gl", option, "-o", out, says="is for the renderer trace, not for gl")
    run("render", "sphere", "--size", "64x36", "--error", "2", "-o", out)
    run("render", "torus-knot", "--size", "640x360", "--samples", "65536", "--time", "0.5", "-o", out)


def test_thread_count_does_not_show(folder):
    one, two = (os.path.join(folder, name) for name in ("one.exr", "two.exr"))
    small("torus-knot", "--material", "glass", "--threads", "1", out=one)
    small("torus-knot", "--material", "glass", "--threads", "2", out=two)
    run("compare", one, two, "--max-rmse", "0")


def test_open_models_are_reported(folder):
    model = os.path.join(folder, "open.obj")
    with open(model, "w", encoding="ascii") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n")
    _, err = small(model, "--material", "glass", out=os.path.join(folder, "a.png"))
    assert err.startswith("tukor: warning: "), err
    _, err = small(model, "--material", "glass", "--quiet", out=os.path.join(folder, "a.png"))
    assert err == "", err


def test_interrupt_keeps_the_picture(folder):
    out = os.path.join(folder, "a.png")
    process = subprocess.Popen([PROGRAM, "render", "torus-knot", "--size", "640x360", "--samples", "65536", "-o", out],
                               stderr=subprocess.PIPE, text=True)
    time.sleep(3)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130, (process.returncode, err)
    assert "the picture so far is " + out in err, err
    assert os.path.getsize(out) > 1000


def test_ignored_interrupts_stay_ignored(folder):
    """As in the background of a shell, or under nohup."""
    out = os.path.join(folder, "a.png")
    process = subprocess.Popen([PROGRAM, "render", "torus-knot", "--size", "320x180", "--time", "4", "-o", out],
                               stderr=subprocess.PIPE, text=True,
                               preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 0 and os.path.getsize(out) > 1000, (process.returncode, err)


def test_progress_on_a_terminal(folder):
    """One line, written over again and wiped away; nothing of it where standard error is no terminal."""
    command = ["render", "torus-knot", "--size", "320x180", "--samples", "64", "-o", os.path.join(folder, "a.png")]
    ours, theirs = pty.openpty()
    process = subprocess.Popen([PROGRAM, *command], stderr=theirs, stdout=subprocess.DEVNULL)
    os.close(theirs)
    said = b""
    try:
        while piece := os.read(ours, 4096):
            said += piece
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    assert process.wait() == 0
    assert re.search(rb"\r *\d+ %  \[#* *\]  [\d.]+ million rays a second", said), said[-500:]
    assert b"\r\x1b[K" in said, said[-500:]
    assert "%" not in run(*command)[1]


def test_view_without_display(folder):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    result = subprocess.run([PROGRAM, "view", "sphere"], capture_output=True, text=True, env=environment, timeout=60)
    assert result.returncode == 1, result
    assert result.stderr.startswith("tukor: no display") and "`tukor render` needs none" in result.stderr, result.stderr


def test_environment_workshop(folder):
    """Every layout and file type leads back to the same light."""
    run("environment", "convert", "sky", "-o", "sky.exr", "--size", "256", folder=folder)
    for out, more in [("face_{}.exr", []), ("cross.hdr", ["--layout", "vcross"]), ("cube.ktx2", ["--compression", "zstd"]),
                      ("cube.dds", ["--format", "float"]), ("blocks.dds", ["--format", "bc6h"]),
                      ("oct.exr", ["--layout", "octahedral"])]:
        run("environment", "convert", "sky.exr", "-o", out, "--size", "64", *more, folder=folder)
        back = ["--in-layout", "octahedral"] if out == "oct.exr" else []
        info = run("environment", "info", out, *back, folder=folder)[0]
        mean = [float(word) for word in next(line for line in info.splitlines() if line.startswith("mean")).split()[1:]]
        if out == "face_{}.exr":
            expected = mean
        assert all(abs(a - b) < 0.05 * b for a, b in zip(mean, expected)), (out, mean, expected)
    run("environment", "filter", "sky.exr", "-o", "chain.ktx2", "--size", "32", "--levels", "3", "--sun", "sun.json",
        folder=folder)
    with open(os.path.join(folder, "sun.json"), encoding="utf-8") as file:
        sun = json.load(file)
    assert sun["direction"][1] > 0.5 and 0.2 < sun["angularRadiusDegrees"] < 1.5, sun
    run("environment", "filter", "sky.exr", "-o", "light.json", "--kind", "sh", "--bands", "4", folder=folder)
    with open(os.path.join(folder, "light.json"), encoding="utf-8") as file:
        assert len(json.load(file)["coefficients"]) == 16
    run("environment", "filter", "-o", "brdf.exr", "--kind", "brdf", "--size", "8", folder=folder)
    run("environment", "info", "studio", "--thumbnail", "sheet.png", folder=folder)
    fails("environment", "convert", "studio", "-o", "a.exr", "--sun", "a.json", says="no sun found", folder=folder)
    assert not os.path.exists(os.path.join(folder, "a.json"))
    fails("environment", "convert", "nowhere", "-o", "a.exr", says="built in are studio, sky", folder=folder)
    fails("environment", "convert", "nowhere", "-o", "none/a.exr", says="there is no folder none", folder=folder)
    fails("environment", "filter", "nowhere", "-o", "none/a.ktx2", says="there is no folder none", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a.foo", says="for cube maps .dds .ktx .ktx2", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a.exr", "--layout", "faces", says="need a pattern", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a_{}.ktx2", says="this file type holds all six", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a.exr", "--in-layout", "hcross",
          says="256 x 128 pixels, which is the shape of an equirectangular panorama", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a.exr", "--sun", "none/a.json", says="no folder none", folder=folder)
    fails("environment", "info", "sky.exr", "--thumbnail", "none/a.png", says="there is no folder none", folder=folder)
    out = run("environment", "--help", folder=folder)[0]
    assert "tukor environment filter street.hdr" in out and "tukor render" not in out, out
    fails("environment", "convert", "sky.exr", "-o", "a.exr", "--size", "33", says="an even number", folder=folder)
    run("environment", "convert", "sky.exr", "-o", "half.exr", "--format", "half", folder=folder)
    assert os.path.getsize(os.path.join(folder, "half.exr")) < 0.7 * os.path.getsize(os.path.join(folder, "sky.exr"))
    fails("environment", "convert", "sky.exr", "-o", "a.exr", "--format", "rgb9e5", says="float or half", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a.exr", "--format", "bc6h", says="float or half", folder=folder)
    fails("environment", "convert", "sky.exr", "-o", "a.png", "--format", "half", says="--png-depth", folder=folder)
    fails("environment", "filter", "sky.exr", "-o", "a.exr", "--size", "4", "--levels", "9", says="at most 3", folder=folder)
    fails("environment", "filter", "-o", "a.exr", says="IN is missing", folder=folder)
    fails("environment", "filter", "sky.exr", "-o", "a.png", "--kind", "sh", says=".json or .h", folder=folder)


def test_environment_info_for_programs(folder):
    info = json.loads(run("environment", "info", "studio", "--json", folder=folder)[0])
    assert info["layout"] == "built in" and info["faceSize"] == 512 and info["repairs"] == [] and info["sun"] is None, info
    assert len(info["sphericalHarmonics"]) == 9 and all(low < mean < high for low, mean, high in zip(info["least"], info["mean"], info["most"]))
    sun = json.loads(run("environment", "info", "sky", "--json", folder=folder)[0])["sun"]
    assert abs(sum(x * x for x in sun["direction"]) - 1) < 1e-5 and 0.2 < sun["angularRadiusDegrees"] < 0.4, sun


def test_environment_exposure(folder):
    """A stop doubles the radiance of every output, once."""
    def least(name):  # a sun would be clipped by .png
        info = run("environment", "info", name, folder=folder)[0]
        return [float(word) for word in re.search(r"least +(.*)", info).group(1).split()]

    run("environment", "convert", "sky", "-o", "sky.exr", "--size", "64", folder=folder)
    for out in ("a.exr", "a.hdr", "a.ktx2", "a.dds", "a_{}.exr", "a.png"):
        for stops, name in (("-6", "dim_" + out), ("-5", out)):
            run("environment", "convert", "sky.exr", "-o", name, "--exposure", stops, *(["--png-depth", "16"] if out == "a.png" else []),
                folder=folder)
        pairs = list(zip(least(out), least("dim_" + out)))
        assert all(abs(a / b - 2) < (0.04 if out in ("a.png", "a.hdr") else 0.004) for a, b in pairs), (out, pairs)
    for stops, name in (("0", "one.json"), ("1", "two.json")):
        run("environment", "filter", "sky.exr", "-o", name, "--kind", "sh", "--exposure", stops, "--sun", "sun_" + name, folder=folder)
    first = [json.load(open(os.path.join(folder, name), encoding="utf-8")) for name in ("one.json", "two.json")]
    assert abs(first[1]["coefficients"][0][1] / first[0]["coefficients"][0][1] - 2) < 1e-4, first
    suns = [json.load(open(os.path.join(folder, "sun_" + name), encoding="utf-8")) for name in ("one.json", "two.json")]
    assert abs(suns[1]["irradiance"][1] / suns[0]["irradiance"][1] - 2) < 1e-3, suns


def test_environment_clipping(folder):
    """What a format cannot hold is said once, with what holds it."""
    run("environment", "convert", "sky", "-o", "sky.exr", "--size", "256", "--exposure", "8", folder=folder)

    def said(out, *more):
        return run("environment", "convert", "sky.exr", "-o", out, *more, folder=folder)[1]

    for out, more, limit in (("a.ktx2", [], "65504, the most that half"), ("a.dds", ["--format", "bc6h"], "65504, the most that bc6h"),
                             ("a.ktx", ["--format", "rgb9e5"], "65408, the most that rgb9e5"), ("a.exr", ["--format", "half"], "65504, the most that half"),
                             ("a_{}.exr", ["--exr-pixels", "half"], "65504, the most that half")):
        text = said(out, *more)
        assert text.count("\n") == 1 and f" above {limit} holds" in text and "--format float keeps it, --sun FILE" in text, text
        share = float(re.search(r"clipped: (\S+) % of the light", text).group(1))
        assert 20 < share < 100, text
    for out, more in (("a.exr", []), ("a.hdr", []), ("a.png", []), ("a.ktx2", ["--format", "float"]), ("a.ktx2", ["--exposure", "-8"])):
        assert said(out, *more) == "", (out, more)


def test_render_clipping(folder):
    """As environment does; a picture that loses nothing, or a quiet program, says nothing."""
    def said(*more, intensity="1e5"):
        return small("sphere", "--environment", "sky", "--environment-intensity", intensity, *more, out=os.path.join(folder, "a.exr"))[1]

    text = said("--exr-pixels", "half")
    assert text.count("\n") == 1 and re.search(r"a\.exr: \d+ pixels above 65504, the most that half holds, were clipped: \S+ % of the light; "
                                              r"--exr-pixels full keeps it", text), text
    assert said() == "" and said("--exr-pixels", "half", "--quiet") == ""
    assert said("--exr-pixels", "half", intensity="1e-3") == ""


def test_environment_filtered_sizes(folder):
    """`--size` is the width of a panorama and the edge of a face or picture, whatever is filtered."""
    for kind, more in (("ggx", ["--levels", "3"]), ("irradiance", []), ("blur", [])):
        for layout, size in (("equirect", "64 x 32"), ("octahedral", "64 x 64"), ("ball", "64 x 64"), ("hcross", "256 x 192")):
            run("environment", "filter", "sky", "-o", "a.exr", "--kind", kind, "--layout", layout, "--size", "64", *more, folder=folder)
            back = ["--in-layout", layout] if layout in ("octahedral", "ball") else []
            info = run("environment", "info", "a_0.exr" if kind == "ggx" else "a.exr", *back, folder=folder)[0]
            assert f"size       {size}\n" in info, (kind, layout, info)
    info = run("environment", "info", "a_2.exr", folder=folder)[0]
    assert "size       64 x 48\n" in info, info


def test_environment_options_that_do_not_apply(folder):
    """They are refused by name, not ignored."""
    def refused(*arguments, says):
        fails("environment", *arguments, says=says, status=2, folder=folder)

    refused("convert", "sky", "-o", "a.exr", "--compression", "zstd", says="a.exr: --compression is of .ktx2")
    refused("convert", "sky", "-o", "a.png", "--exr-pixels", "half", says="a.png: --exr-pixels is of .exr")
    refused("convert", "sky", "-o", "a.hdr", "--tonemap", "aces", says="a.hdr: --tonemap is of .png and .jpg")
    refused("filter", "sky", "-o", "a.ktx2", "--blur", "3", says="--blur is of --kind blur")
    refused("filter", "sky", "-o", "a.ktx2", "--bands", "3", says="--bands is of --kind sh")
    refused("filter", "sky", "-o", "a.json", "--kind", "sh", "--size", "3", says="--size is of pictures")
    refused("filter", "sky", "-o", "a.json", "--kind", "sh", "--to", "three", says="--to is of pictures")
    for option in (["none.exr"], ["--to", "three"], ["--layout", "faces"], ["--sun", "a.json"], ["--exposure", "1"]):
        refused("filter", *option, "-o", "a.exr", "--kind", "brdf",
                says=f"{option[0] if option[0].startswith('-') else 'IN'} is of")
    fails("environment", "filter", "-o", "a.exr", "--kind", "brdf", "--format", "bc6h", says="float or half", folder=folder)
    fails("environment", "filter", "-o", "a.png", "--kind", "brdf", says="expected .exr or .hdr", folder=folder)
    for form in ("float", "half"):
        run("environment", "filter", "-o", form + ".exr", "--kind", "brdf", "--size", "32", "--format", form, folder=folder)
    assert os.path.getsize(os.path.join(folder, "half.exr")) < 0.7 * os.path.getsize(os.path.join(folder, "float.exr"))


def test_series_of_pictures(folder):
    """--turntable and --fps number their pictures, and no two are the same."""
    small = ("--size", "32x18", "--samples", "4")

    def pictures(*words):
        for old in glob.glob(os.path.join(folder, "film-*.png")):
            os.remove(old)
        run("render", *words, *small, "-o", "film-#.png", folder=folder)
        names = sorted(os.listdir(folder))
        contents = [open(os.path.join(folder, name), "rb").read() for name in names if name.startswith("film-")]
        assert len(set(contents)) == len(contents), names
        return len(contents)

    subprocess.run([sys.executable, os.path.join(ROOT, "tools", "feature_scenes.py"), folder, "moved"], check=True)
    assert pictures("torus-knot", "--turntable", "3") == 3
    assert pictures("moved.glb", "--fps", "4", "--time-seconds", "0.25") == 3  # of one second
    assert pictures("moved.glb", "--fps", "4", "--turntable", "5") == 5
    fails("render", "torus-knot", "--fps", "4", *small, "-o", "film.png", says="animation", folder=folder)


def test_options_page(folder):
    """docs/options.md is what the program writes."""
    page = os.path.join(ROOT, "docs", "options.md")
    written = run("markdown-options")[0]
    with open(page, encoding="utf-8") as file:
        assert file.read() == written, "docs/options.md is old: tukor markdown-options > docs/options.md"


script_tests.main(dict(globals()), sys.argv[2:])
