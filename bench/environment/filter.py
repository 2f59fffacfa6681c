#!/usr/bin/env python3
"""Compares `tukor environment filter` with Filament's cmgen: CPU time of the whole process, and error against exact
quadrature, on the same input and output sizes, in one run.

usage: filter.py BUILD [PANORAMA...]     BUILD: a folder built with -DTUKOR_BENCH=ON
needs: libfilament-tools (cmgen), blender-data where no panorama is given
"""
import os
import resource
import subprocess
import sys
import tempfile

WORLDS = "/usr/share/blender/datafiles/studiolights/world"
LEVELS = 5


def cpu_seconds(command, repeats=3):
    """The least user and system time of some runs."""
    best = float("inf")
    for _ in range(repeats):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return best


def errors(build, panorama, pattern, *more):
    """Relative root mean square error and worst of each level."""
    out = subprocess.run([f"{build}/bench/chain_error", panorama, pattern, str(LEVELS), *more], check=True,
                         capture_output=True, text=True).stdout
    return [(float(line.split()[2]), float(line.split()[3])) for line in out.splitlines()]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = sys.argv[1]
    tukor = f"{build}/apps/tukor/tukor"
    # The two skies are the built-in one at 4096 x 2048: as it is, with a sun of radiance 53,000, and with one of 1e5.
    panoramas = sys.argv[2:] or [f"{WORLDS}/{name}" for name in sorted(os.listdir(WORLDS)) if name.endswith(".exr")] + \
        ["sky", "bright sky"]
    print(f"{'panorama':20} {'tukor s':>8} {'cmgen s':>8} {'ratio':>6}   "
          f"{'tukor error':>11} {'worst':>8}   {'cmgen error':>11} {'worst':>8} {'ratio':>6}")
    for source in panoramas:
        with tempfile.TemporaryDirectory() as folder:
            # cmgen cannot read the DWA compression of most free panoramas: both get a plain file.
            panorama = f"{folder}/input.exr"
            if source == "bright sky":
                subprocess.run([f"{build}/bench/bright_sky", "4096", panorama], check=True, stdout=subprocess.DEVNULL)
            else:
                subprocess.run([tukor, "environment", "convert", source, "-o", panorama, "--exr-pixels", "half"] +
                               (["--size", "4096"] if source == "sky" else []), check=True, stderr=subprocess.DEVNULL)
            ours = f"{folder}/chain_{{}}.exr"
            command = [tukor, "environment", "filter", panorama, "-o", ours, "--size", "256",
                       "--levels", str(LEVELS), "--exr-pixels", "half"]  # as cmgen's
            our_time = cpu_seconds(command)
            # --no-mirror: the same handedness; its other options are its defaults
            their_time = cpu_seconds(["cmgen", "-q", "--no-mirror", "--format=exr", "--size=256",
                                      f"--ibl-ld={folder}", panorama], repeats=1)
            name = os.path.splitext(os.path.basename(source))[0]
            our_errors = errors(build, panorama, f"{folder}/chain_{{level}}_{{face}}.exr")
            their_errors = errors(build, panorama, f"{folder}/input/m{{level}}_{{face}}.exr", "filament")
            worst = [max(level[i] for level in each) for each in (our_errors, their_errors) for i in (0, 1)]
            print(f"{name:20} {our_time:8.3f} {their_time:8.3f} {their_time / our_time:6.1f}   "
                  f"{worst[0]:11.1e} {worst[1]:8.1e}   {worst[2]:11.1e} {worst[3]:8.1e} {worst[2] / worst[0]:6.0f}",
                  flush=True)


main()
