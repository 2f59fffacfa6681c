#!/usr/bin/env python3
"""What `tukor environment convert --format` loses and costs in BC6H, and in the packed formats beside it: cube maps
with all levels, against the same as halves.

usage: bc6h.py BUILD [FACE_SIZE [FORMAT...]]     needs: blender-data
"""
import math
import os
import re
import resource
import subprocess
import sys
import tempfile

WORLDS = "/usr/share/blender/datafiles/studiolights/world"


def run(*command):
    """What it prints, and the user and system time that it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return out, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def compared(tukor, one, other):
    """RMSE in codes of 8-bit sRGB, and relative."""
    text, _ = run(tukor, "compare", one, other)
    return [float(number) for number in re.findall(r"RMSE ([0-9.e+-]+)", text)[:2]]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    tukor = f"{sys.argv[1]}/apps/tukor/tukor"
    size = sys.argv[2] if len(sys.argv) > 2 else "512"
    formats = sys.argv[3:] or ["bc6h"]
    print(f"{'panorama':10} {'format':9} {'CPU-s':>6} {'halves':>6} {'MB':>6} {'of':>6}   "
          f"{'codes':>6} {'PSNR':>6} {'relative':>8}   {'irradiance':>10}")
    for name in sorted(name[:-4] for name in os.listdir(WORLDS) if name.endswith(".exr")):
        with tempfile.TemporaryDirectory() as folder:
            # Without the time that the panorama's own compression takes.
            panorama = f"{folder}/panorama.exr"
            run(tukor, "environment", "convert", f"{WORLDS}/{name}.exr", "-o", panorama, "--format", "half")

            def write(form):
                cube = f"{folder}/{form}.dds"
                seconds = min(run(tukor, "environment", "convert", panorama, "-o", cube, "--size", size,
                                  "--format", form)[1] for _ in range(3))
                run(tukor, "environment", "convert", cube, "-o", f"{folder}/{form}.exr", "--layout", "vstrip")
                run(tukor, "environment", "filter", cube, "-o", f"{folder}/{form}_irradiance.exr", "--kind",
                    "irradiance", "--layout", "vstrip", "--size", "32")
                return seconds, os.path.getsize(cube) / 1e6

            halves, whole = write("half")
            for form in formats:
                seconds, size_mb = write(form)
                codes, relative = compared(tukor, f"{folder}/{form}.exr", f"{folder}/half.exr")
                light = compared(tukor, f"{folder}/{form}_irradiance.exr", f"{folder}/half_irradiance.exr")[1]
                print(f"{name:10} {form:9} {seconds:6.2f} {halves:6.2f} {size_mb:6.1f} {whole:6.1f}   {codes:6.2f} "
                      f"{20 * math.log10(255 / max(codes, 1e-9)):6.1f} {relative:8.4f}   {light:10.1e}", flush=True)


main()
