#!/usr/bin/env python3
"""From process start to a finished picture: `tukor render` beside f3d, same OBJ, same HDRI, 1280x720. Writes docs/bench-startup.md.

usage: bench/startup.py [--runs N]     after: cmake --preset release -DTUKOR_BENCH=ON && cmake --build --preset release
needs: tools/install_packages.sh bench demo test     (f3d renders only with a display: it runs under Xvfb)
"""
import argparse
import os
import pathlib
import platform
import resource
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/release"
HDRI = pathlib.Path("/usr/share/blender/datafiles/studiolights/world/courtyard.exr")


def measure(command, runs):
    """CPU seconds (user + system) of `command` and its children: median of `runs` after one warm-up."""
    times = []
    for run in range(runs + 1):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if run:
            times.append(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return statistics.median(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    runs = parser.parse_args().runs
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        subprocess.run([BUILD / "bench/export_shape", "torus-knot", folder / "knot.obj"], check=True)
        tukor = BUILD / "apps/tukor/tukor"
        # f3d 1.3 opens no .exr environments, and goes on without one.
        hdri = folder / "environment.hdr"
        subprocess.run([tukor, "environment", "convert", HDRI, "--layout", "equirect", "-o", hdri], check=True)
        common = [tukor, "render", "--size", "1280x720", "-o", folder / "a.png"]
        rows = [("tukor render torus-knot", common + ["torus-knot"]),
                ("tukor render torus-knot --renderer gl --fidelity single",
                 common + ["torus-knot", "--renderer", "gl", "--fidelity", "single"])]
        for renderer, fidelity in (("gl", "single"), ("gl", "exact"), ("trace", "exact")):
            rows.append((f"tukor render knot.obj --renderer {renderer} --fidelity {fidelity}",
                         common + [folder / "knot.obj", "--environment", hdri, "--renderer", renderer, "--fidelity", fidelity]))
        # Xvfb stays up over all runs, so that its start is not counted against f3d.
        display = ":97"
        server = subprocess.Popen(["Xvfb", display, "-screen", "0", "1280x720x24"], stderr=subprocess.DEVNULL)
        os.environ["DISPLAY"] = display
        rows.append(("f3d knot.obj", ["f3d", folder / "knot.obj", f"--hdri={hdri}", "--resolution=1280,720",
                                      f"--output={folder / 'f3d.png'}", "--no-background=0"]))
        try:
            table = [(name, measure([str(word) for word in command], runs)) for name, command in rows]
        finally:
            server.terminate()
            server.wait()
    peer = table[-1][1]
    lines = ["# From process start to a picture", "",
             f"`bench/startup.py --runs {runs}`: CPU seconds, user and system, median; {platform.machine()}, {os.cpu_count()} cores, no GPU (llvmpipe).", "",
             "| command | CPU s | of f3d's |", "|---|---|---|"]
    lines += [f"| `{name}` | {cpu:.2f} | {cpu / peer:.2f} |" for name, cpu in table]
    text = "\n".join(lines) + "\n"
    print(text)
    partial = ROOT / "docs/.bench-startup.partial"
    partial.write_text(text)
    partial.rename(ROOT / "docs/bench-startup.md")


main()
