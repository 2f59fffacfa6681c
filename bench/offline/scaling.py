#!/usr/bin/env python3
"""How trace's time and memory grow with triangles, environment, pixels, samples and threads. Writes docs/offline-scaling.md.

after: cmake --preset release -DTUKOR_BENCH=ON && cmake --build --preset release
needs: tools/install_packages.sh bench; 8 GB below build/offline, and a machine with nothing else to do
"""
import argparse
import os
import sys
import time

import scenes

SIZE, SAMPLES = "480x270", 8
TRIANGLES = [10 ** n for n in range(3, 8)]
WIDTHS = [512, 1024, 2048, 4096, 8192, 16384]
PIXELS = ["160x90", "320x180", "640x360", "1280x720", "1920x1080"]
COUNTS = [2, 4, 8, 16, 32, 64]


def ball(triangles):
    """Made by a process of its own: what this one holds would count as the peak of those that it starts."""
    path = scenes.FOLDER / f"ball-{triangles}.ply"
    if not path.exists():
        scenes.run([sys.executable, scenes.ROOT / "bench/offline/wavy_ball.py", triangles, path])
    return path


def render(model, environment, size=SIZE, samples=SAMPLES, threads=1):
    """CPU seconds, seconds, GiB at the peak, rays of one process."""
    out = scenes.FOLDER / "scaling.exr"
    words = [scenes.TUKOR, "render", "--quiet", "--renderer", "trace", "--threads", threads, "--environment", environment, "--eye", "0,0,5",
             "--target", "0,0,0", "--fov", 25, "--size", size, "--samples", samples, "-o", out, "--material", "*=ior:1.5", model]
    begin = time.monotonic()
    process = os.posix_spawn(words[0], [str(word) for word in words], os.environ)
    _, status, used = os.wait4(process, 0)
    if status:
        raise SystemExit(f"{' '.join(map(str, words))} failed")
    return used.ru_utime + used.ru_stime, time.monotonic() - begin, used.ru_maxrss / 2 ** 20, int(scenes.header_text(out, "rays"))


def start(model, environment):
    return render(model, environment, "16x9", 1)


def row(name, model, environment, **quality):
    """A line of a table: what the start takes, what the rays take, and how much memory."""
    begin, whole = (min(times) for times in zip(*((start(model, environment), render(model, environment, **quality)) for _ in range(2))))
    cpu = whole[0] - begin[0]
    line = f"| {name} | {begin[0]:.2f} | {whole[3] / 1e6:.2f} | {cpu:.2f} | {cpu / whole[3] * 1e6:.2f} | {whole[2]:.2f} |"
    print(line, flush=True)
    return line


def threads(model, environment):
    """How much sooner two threads end than one, in turns: the best of three each, start-up included and not."""
    whole, begin = ([min(times) for times in zip(*([render(model, environment, *quality, n)[1] for n in (1, 2)] for _ in range(3)))]
                    for quality in (("960x540", 16), ("16x9", 1)))
    return (f"{whole[0]:.2f} s with one thread, {whole[1]:.2f} s with two: {whole[0] / whole[1]:.2f} times; "
            f"without the start, {begin[0]:.2f} and {begin[1]:.2f} s, {(whole[0] - begin[0]) / (whole[1] - begin[1]):.2f} times")


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    scenes.prepare()
    maps = {}
    for width in WIDTHS:
        maps[width] = scenes.FOLDER / f"detailed-{width}.exr"
        if not maps[width].exists():
            scenes.run([scenes.TUKOR, "environment", "convert", scenes.environment("detailed"), "--size", width, "-o", maps[width]])
    usual, forest = ball(10 ** 5), scenes.environment("forest")
    tables = {
        "with_triangles": [row(f"{n:.0e}".replace("e+0", "e"), ball(n), forest) for n in TRIANGLES],
        "with_environment": [row(f"{width} x {width // 2}", usual, maps[width]) for width in WIDTHS],
        "with_pixels": [row(size, usual, forest, size=size) for size in PIXELS],
        "with_samples": [row(n, usual, forest, samples=n) for n in COUNTS],
        "with_both": [row("1e7 triangles, 8192 x 4096", ball(10 ** 7), maps[8192])],
    }
    text = TEXT.format(threads=threads(usual, forest), size=SIZE, samples=SAMPLES,
                       **{name: HEAD.format(name[5:]) + "\n".join(rows) for name, rows in tables.items()})
    partial = scenes.ROOT / "docs/.offline-scaling.partial"
    partial.write_text(text)
    partial.rename(scenes.ROOT / "docs/offline-scaling.md")


HEAD = "| {} | start, CPU s | million rays | CPU s for them | CPU microseconds a ray | peak, GiB |\n|---|---|---|---|---|---|\n"

TEXT = """# How cost grows

Written by `bench/offline/scaling.py`. A wavy ball of glass (100,000 triangles), {size}, {samples} samples a pixel, under `forest` (1024x512), one thread,
unless a line says otherwise; the environments are `detailed` of offline.md at other widths. *Start* is a process of its own that renders one sample of 16x9
pixels: reading the model and the environment, Embree's tree. *CPU s for them* is the whole process less that, the lesser of two each. The peak is that of the process.

## With triangles
{with_triangles}

## With the environment
{with_environment}

## With pixels
{with_pixels}

## With samples
{with_samples}

## Much of both
{with_both}

## With threads
960x540, 16 samples: {threads}.
"""

if __name__ == "__main__":
    main()
