#!/usr/bin/env python3
"""CPU time at equal error: `tukor render --renderer trace` beside Cycles, one thread each, in one run. Writes docs/bench-offline.md and .svg.

usage: bench/offline/offline.py [--quick] [--scenes all,knot,sphere,mesh] [--maps courtyard,city,sky4k]
after: cmake --preset release -DTUKOR_BENCH=ON && cmake --build --preset release
needs: tools/install_packages.sh bench demo

A picture's error is measured without a common reference, since two renderers never agree on a look-up's filter to the last
digit: Cycles is unbiased, so two renders with different seeds differ by sqrt(2) times their noise. tukor's is the larger of
the same figure and the distance to its own picture at 2048 samples, which also shows bias.
"""
import argparse
import json
import math
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TUKOR = ROOT / "build/release/apps/tukor/tukor"
EXPORT = ROOT / "build/release/bench/export_shape"
PHOTOGRAPHS = pathlib.Path("/usr/share/blender/datafiles/studiolights/world")
TINT, IOR, EYE, FOV, SIZE = (1.0, 0.77, 0.34), 1.5, (0.0, 0.0, 9.0), 40.0, (480, 270)
MODELS = {"knot": ("torus-knot", -2.6, "gold"), "sphere": ("sphere", 0.0, "glass"), "mesh": ("torus-knot", 2.6, "glass")}
SCENES = {"all": ["knot", "sphere", "mesh"], "knot": ["knot"], "sphere": ["sphere"], "mesh": ["mesh"]}
MATERIALS = {"gold": "mirror:" + ",".join(map(str, TINT)), "glass": f"ior:{IOR}"}


def cpu(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode:
        sys.exit(f"{command[0]} failed:\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, result.stdout


def difference(a, b):
    """(RMSE in 8-bit sRGB, relative RMSE, linear relative mean) between two pictures."""
    text = subprocess.run([TUKOR, "compare", a, b], capture_output=True, text=True, check=True).stdout
    return [float(re.search(rf"{head}RMSE ([-+.e\d]+)", text)[1]) for head in ("8-bit sRGB: ", "relative: +")]


def tukor(folder, models, environment, samples, seed):
    out = folder / f"tukor-{samples}-{seed}.exr"
    command = [TUKOR, "render", "--quiet", "--renderer", "trace", "--threads", 1, "--environment", environment, "--seed", seed,
               "--eye", ",".join(map(str, EYE)), "--target", "0,0,0", "--fov", FOV, "--size", "%dx%d" % SIZE, "--samples", samples, "-o", out]
    for name, path, kind in models:
        command += [path, "--material", f"{name}={MATERIALS[kind]}"]
    return cpu(command)[0], out


def cycles(folder, models, environment, samples, seed):
    out = folder / f"cycles-{samples}-{seed}.exr"
    job = {"models": [[str(path), kind] for _, path, kind in models], "tint": TINT, "ior": IOR, "environment": str(environment),
           "eye": EYE, "fov": FOV, "size": SIZE, "samples": samples, "seed": seed, "out": str(out)}
    _, text = cpu(["blender", "-b", "--factory-startup", "--python", ROOT / "bench/offline/cycles.py", "--", json.dumps(job)])
    return float(re.search(r"CYCLES_CPU ([\d.]+)", text)[1]), out  # the render alone, without Blender's start


def curve(renderer, counts, reference=None):
    """[(samples, CPU s, RMSE in 8-bit sRGB, relative RMSE)], CPU the mean of two renders."""
    rows = []
    for samples in counts:
        first, second = renderer(samples, 1), renderer(samples, 2)
        errors = [value / math.sqrt(2) for value in difference(first[1], second[1])]
        if reference:
            errors = [max(pair) for pair in zip(errors, difference(first[1], reference))]
        rows.append((samples, (first[0] + second[0]) / 2, *errors))
    return rows


def cpu_at(rows, error, column):
    """CPU seconds at which a curve reaches an error, by a line in the logarithms through the two nearest points."""
    pairs = sorted((row[column], row[1]) for row in rows if row[column] > 0)
    if len(pairs) < 2:
        return float("nan")
    after = next((i for i, pair in enumerate(pairs) if pair[0] >= error), len(pairs) - 1)
    (e0, c0), (e1, c1) = pairs[max(after - 1, 0)], pairs[max(after, 1)]
    slope = (math.log(c1) - math.log(c0)) / (math.log(e1) - math.log(e0)) if e1 != e0 else 0.0
    return c0 * math.exp(slope * (math.log(error) - math.log(e0)))


def svg(curves):
    """All curves, error over CPU time, logarithmic, one small panel each."""
    width, height, parts = 300, 220, []
    for index, (title, rows) in enumerate(curves.items()):
        left, top = (index % 3) * width, (index // 3) * height
        points = [row for name in rows for row in rows[name] if row[2] > 0]
        xs, ys = [math.log(row[1]) for row in points], [math.log(row[2]) for row in points]

        def place(row):
            x = left + 40 + (width - 60) * (math.log(row[1]) - min(xs)) / max(max(xs) - min(xs), 1e-9)
            y = top + height - 40 - (height - 70) * (math.log(row[2]) - min(ys)) / max(max(ys) - min(ys), 1e-9)
            return f"{x:.1f},{y:.1f}"

        parts.append(f'<text x="{left + 40}" y="{top + 20}">{title}</text>'
                     f'<text x="{left + 40}" y="{top + height - 15}">{math.exp(min(xs)):.2g} .. {math.exp(max(xs)):.2g} CPU s</text>'
                     f'<text x="{left + 40}" y="{top + height - 2}">RMSE {math.exp(min(ys)):.2g} .. {math.exp(max(ys)):.2g}</text>')
        for name, colour in (("tukor", "#c80"), ("cycles", "#06c")):
            parts.append(f'<polyline fill="none" stroke="{colour}" stroke-width="2" points="{" ".join(place(r) for r in rows[name] if r[2] > 0)}"/>')
    rows = (len(curves) + 2) // 3
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {3 * width} {rows * height + 20}" font-family="sans-serif" font-size="11">'
            f'<rect width="100%" height="100%" fill="#fff"/>{"".join(parts)}'
            f'<text x="40" y="{rows * height + 14}" fill="#c80">tukor</text><text x="90" y="{rows * height + 14}" fill="#06c">Cycles</text></svg>\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default="all,knot,sphere,mesh")
    parser.add_argument("--maps", default="courtyard,city,sky4k")
    parser.add_argument("--quick", action="store_true", help="fewer points on the curves")
    args = parser.parse_args()
    counts = {"tukor": [4, 16, 64], "cycles": [256]} if args.quick else {"tukor": [2, 4, 8, 16, 32, 64, 128], "cycles": [16, 64, 256]}
    curves, lines = {}, []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, (shape, x, _) in MODELS.items():
            subprocess.run([EXPORT, shape, folder / f"{name}.obj", str(x), "0", "0"], check=True)
        for map_name in args.maps.split(","):
            environment = PHOTOGRAPHS / f"{map_name}.exr"
            if map_name == "sky4k":
                environment = folder / "sky4k.exr"
                subprocess.run([TUKOR, "environment", "convert", "sky", "-o", environment, "--layout", "equirect", "--size", "4096"], check=True)
            for scene in args.scenes.split(","):
                models = [(name, folder / f"{name}.obj", MODELS[name][2]) for name in SCENES[scene]]
                title = f"{scene}, {map_name}"
                print(title, flush=True)
                reference = tukor(folder, models, environment, 2048, 99)[1]
                rows = {
                    "tukor": curve(lambda n, s: tukor(folder, models, environment, n, s), counts["tukor"], reference),
                    "cycles": curve(lambda n, s: cycles(folder, models, environment, n, s), counts["cycles"]),
                }
                curves[title] = rows
                peer = rows["cycles"][-1]
                equal8, equal_relative = cpu_at(rows["tukor"], peer[2], 2), cpu_at(rows["tukor"], peer[3], 3)
                lines.append(f"| {scene} | {map_name} | {peer[1]:.1f} | {peer[2]:.2f} | {equal8:.2f} | {peer[1] / equal8:.1f} | {peer[3]:.3g} | {peer[1] / equal_relative:.1f} |")
                print(lines[-1], flush=True)
                for name, points in rows.items():
                    for point in points:
                        print("   ", name, *(f"{value:.4g}" for value in point), flush=True)
    text = "\n".join([
        "# CPU time at equal error: trace beside Cycles", "",
        "`bench/offline/offline.py`: 480x270, one thread each, Cycles of Blender 3.4 at 256 samples; CPU seconds, user and system. How errors are",
        "measured is said in the script's first lines. tukor's time is the whole process, Cycles' the render without Blender's start.", "",
        "| scene | environment | Cycles CPU s | its RMSE, 8-bit sRGB | tukor CPU s at that RMSE | times less | its relative RMSE | times less at that |",
        "|---|---|---|---|---|---|---|---|", *lines, "", "![error over CPU time](bench-offline.svg)", ""])
    for path, content in ((ROOT / "docs/bench-offline.md", text), (ROOT / "docs/bench-offline.svg", svg(curves))):
        partial = path.with_suffix(".partial")
        partial.write_text(content)
        partial.rename(path)


main()
