#!/usr/bin/env python3
"""What comes back of environments that `tukor environment convert` takes to another layout or size and back: RMSE in
codes of 8-bit sRGB of the whole picture, and of what lies within 60 degrees of the horizon. The 8 bits alone cost 0.29.

usage: there_and_back.py BUILD [NAME...]     needs: blender-data, openimageio-tools
"""
import re
import subprocess
import sys
import tempfile

WORLDS = "/usr/share/blender/datafiles/studiolights/world"
PANORAMA = ["--layout", "equirect", "--size", 1024]
STRIP = ["--layout", "hstrip", "--size", 128]
DETOURS = [(f"panorama of 1024 by {what} of {size}", PANORAMA, ["--layout", layout, "--size", size])
           for what, layout, sizes in [("one", "equirect", (1500, 1536, 2048, 3000)), ("faces", "hstrip", (512, 1024, 2048)),
                                       ("an octahedral picture", "octahedral", (1024, 2048, 4096)), ("a mirror ball", "ball", (1024, 2048))]
           for size in sizes]
DETOURS += [(f"faces of 128 by a panorama of {size}", STRIP, ["--layout", "equirect", "--size", size]) for size in (512, 1024, 2048)]


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    tukor = f"{sys.argv[1]}/apps/tukor/tukor"
    names = sys.argv[2:] or ["forest", "interior", "city", "night"]

    with tempfile.TemporaryDirectory() as folder:
        def file(name):
            return f"{folder}/{name}.exr"

        def convert(source, out, target, layout=None):
            run(tukor, "environment", "convert", source, "-o", file(out), *target, *(["--in-layout", layout] if layout else []))

        def apart(crop=None):
            pictures = ["there", "back"]
            for name in pictures if crop else []:
                run("oiiotool", file(name), "--cut", crop, "-o", file(name + "-part"))
            one, other = (file(name + ("-part" if crop else "")) for name in pictures)
            return float(re.search(r"RMSE ([0-9.e+-]+)", run(tukor, "compare", one, other)).group(1))

        print("| there and back | " + " | ".join(names) + " |\n|---|" + "---|" * len(names))
        for what, home, away in DETOURS:
            cells = []
            for name in names:
                convert(f"{WORLDS}/{name}.exr", "there", home)
                convert(file("there"), "away", away)
                convert(file("away"), "back", home, away[1] if away[1] in ("octahedral", "ball") else None)
                band = f", {apart('1024x342+0+85'):.3f}" if home is PANORAMA else ""
                cells.append(f"{apart():.3f}{band}")
            print(f"| {what} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
