#!/usr/bin/env python3
"""CPU time at equal error: trace beside Cycles, POV-Ray and bare Embree, one thread each, in one run.

Writes docs/offline.md and docs/offline.svg. References and peers' pictures stay in build/offline; delete it to begin anew.

after: cmake --preset release -DTUKOR_BENCH=ON && cmake --build --preset release
needs: tools/install_packages.sh bench
"""
import argparse
import os
import sys

import scenes
from curves import cpu_at, figure, svg

ERRORS, SAMPLES = "6,3,1.5,0.75,0.5", "4,16,64"
# Samples a pixel of a scene's rows of throughput. The gold knot's few rays take less time at 16 than the file does.
THROUGHPUT = {"all": (16,), "knot": (16, 256), "sphere": (16,), "mesh": (16,)}


def measure(scene, map_name, args):
    """Curves of all renderers on one scene, and the row of the table."""
    references = scenes.reference(scene, map_name, args.reference)
    peers = [("Cycles", scenes.cached(scenes.cycles, scene, map_name, q, args.peers_again)) for q in ((256, 1), (256, 2), (64, 1))]
    if args.povray:
        peers += [("POV-Ray", scenes.cached(scenes.povray, scene, map_name, (q,), args.peers_again)) for q in (2, 4, 8)]
    ours = [("tukor", scenes.tukor(scene, map_name, ["--error", e])) for e in args.errors.split(",")]
    ours += [("tukor --samples", scenes.tukor(scene, map_name, ["--samples", n])) for n in args.samples.split(",")]
    noise, *errors, common = scenes.errors(references, [picture for _, (_, picture) in peers + ours])
    curves = {}
    for (name, (cpu, _)), error in zip(peers + ours, errors):
        curves.setdefault(name, []).append((cpu, *error))
    by_error = [(cpu, picture) for _, (cpu, picture) in ours[:len(args.errors.split(","))]]
    promised = [(said(picture), without(error, noise)) for (_, picture), error in zip(by_error, errors[len(peers):])]
    own = [(cpu, 0, 0, said(picture, "noise")) for cpu, picture in by_error]
    cycles = [sum(column) / 2 for column in zip(*curves["Cycles"][:2])]  # two seeds at 256 samples
    curves["Cycles"][:2] = [tuple(cycles)]
    whole = sum(scenes.cycles_whole(picture) for _, (_, picture) in peers[:2]) / 2
    return curves, noise, common, promised, own, cycles, whole


def row(scene, map_name, curves, noise, common, own, cycles, whole):
    start = scenes.start(scene, map_name)
    cells = [scene, map_name, f"{figure(cycles[0])}, {figure(whole)}", figure(cycles[1]), figure(cycles[2]), figure(cycles[3]), figure(start, 2)]

    def compared(ours, error, column):
        """At an error: CPU seconds of the whole process, and how much less that is, without what comes before rendering and with it."""
        time = cpu_at(ours["tukor"], error, column) or cpu_at(ours["tukor --samples"], error, column)
        return "-" if time is None else f"{figure(time, 2)} ({figure(cycles[0] / (time - start), 2)}x, {figure(whole / time, 2)}x)"

    cells += [compared(curves, cycles[column], column) for column in (1, 2, 3)]
    # What two renders of Cycles have in common is not its noise.
    own = {"tukor": own, "tukor --samples": [(1e9, 0, 0, 1e9)]}
    alone = max(cycles[3] ** 2 - max(common[2], 0.0) ** 2, 1e-6) ** 0.5
    cells.append(f"{figure(alone)}: {compared(own, alone, 3)}")
    pov = cpu_at(curves.get("POV-Ray", [(1.0, 1e9, 1e9, 1e9)]), cycles[3], 3)
    cells += [figure(pov), figure(noise[2]), figure(common[2])]
    return "| " + " | ".join(cells) + " |"


def promise(scene, map_name, args):
    """A row of the table of what --error promises, on all cores."""
    references = scenes.reference(scene, map_name, args.reference)
    pictures = [scenes.tukor(scene, map_name, ["--error", e], threads=os.cpu_count())[1] for e in args.errors.split(",")]
    noise, *errors = scenes.errors(references, pictures)
    return promise_row(scene, map_name, [(said(picture), without(error, noise)) for picture, error in zip(pictures, errors)])


def said(picture, what="rmse"):
    return float(scenes.header_text(picture, f"expected-{what}") or "nan")


def without(error, noise):
    """RMSE in 8-bit sRGB from the truth that the reference is near."""
    return max(error[2] ** 2 - noise[2] ** 2, 0.0) ** 0.5


def promise_row(scene, map_name, promised):
    return f"| {scene} | {map_name} | " + " | ".join(f"{said:.2f} / {true:.2f}" for said, true in promised) + " |"


def throughput(scene, samples):
    """A row of the table: million rays a CPU second, of Embree alone and of trace, the best of three each, in turn."""
    turns = [(scenes.traversal(scene, samples, triangles=True), scenes.traversal(scene, samples), scenes.tukor(scene, "forest", ["--samples", samples]),
              scenes.start(scene, "forest")) for _ in range(3)]
    rays = turns[0][0][0]
    triangles, closed = (min(turn[i][1] for turn in turns) for i in (0, 1))
    building = min(turn[0][2] for turn in turns)
    start = min(turn[3] for turn in turns)
    ours = min(turn[2][0] for turn in turns) - start
    cast = int(scenes.header_text(turns[0][2][1], "rays")) / 1e6 / rays
    return (f"| {scene} | {samples} | {rays / triangles:.2f} | {rays / closed:.2f} | {rays / ours:.2f} | {triangles / ours:.0%} | {closed / ours:.0%} "
            f"| {1 - cast:.0%} | {start:.2f} | {building:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default=",".join(scenes.SCENES))
    parser.add_argument("--maps", default=",".join(scenes.MAPS))
    parser.add_argument("--errors", default=ERRORS, help="points of the curve of --error")
    parser.add_argument("--samples", default=SAMPLES, help="points of the curve of --samples")
    parser.add_argument("--reference", type=int, default=1024, help="least samples a pixel of each of the two pictures that make a reference")
    parser.add_argument("--peers-again", action="store_true", help="render the peers' pictures again, not only tukor's")
    parser.add_argument("--povray", action="store_true", help="measure POV-Ray, too; it takes long")
    parser.add_argument("--throughput", action="store_true", help="print the table of throughput and nothing else")
    parser.add_argument("--promises", action="store_true", help="print the table of what --error promises and nothing else")
    parser.add_argument("--no-write", action="store_true", help="print only")
    args = parser.parse_args()
    scenes.prepare()
    if args.throughput:
        for scene in args.scenes.split(","):
            for samples in THROUGHPUT[scene]:
                print(throughput(scene, samples), flush=True)
        return
    if args.promises:
        for scene in args.scenes.split(","):
            for map_name in args.maps.split(","):
                print(promise(scene, map_name, args), flush=True)
        return
    panels, rows, promises, limits = {}, [], [], []
    for scene in args.scenes.split(","):
        for samples in THROUGHPUT[scene]:
            limits.append(throughput(scene, samples))
            print(limits[-1], flush=True)
        for map_name in args.maps.split(","):
            curves, noise, common, promised, own, cycles, whole = measure(scene, map_name, args)
            rows.append(row(scene, map_name, curves, noise, common, own, cycles, whole))
            print(rows[-1], flush=True)
            promises.append(promise_row(scene, map_name, promised))
            print(promises[-1], flush=True)
            for name, points in curves.items():
                for point in points:
                    print("    ", name, *(f"{value:.4g}" for value in point), flush=True)
            panels[f"{scene}, {map_name}"] = curves
    text = TEXT.format(rows="\n".join(rows), promises="\n".join(promises), limits="\n".join(limits),
                       arguments=" ".join(sys.argv[1:]), asked=args.errors.replace(",", " | "), bars="---|" * len(args.errors.split(",")), reference=args.reference)
    if not args.no_write:
        for name, content in (("offline.md", text), ("offline.svg", svg(panels))):
            (scenes.ROOT / "docs" / name).write_text(content)


TEXT = """# CPU time at equal error

Written by `bench/offline/offline.py {arguments}`. A torus knot of gold (70,000 triangles), a sphere of glass (84,500) and a torus knot of glass (70,000), together and each
alone, 480x270, one thread each, under `forest` (a photograph), `city` (a photograph with the sun), both 1024x512 from blender-data, and `detailed`
(generated, 4096x2048, detail down to single pixels and a sun of half a degree). CPU seconds are user and system: of the whole process for tukor
and POV-Ray, of the render and of the whole process for Cycles (Debian's Blender 3.4). Gold is a tint of 1, 0.77, 0.34, which all renderers have.

RMSE is that of radiance; relative MSE the mean of (a - b)^2 / (b^2 + 0.01); sRGB the RMSE in codes of 8-bit sRGB. The reference is the mean of two
pictures of trace at {reference} samples a pixel or more, with seeds of their own; its noise is half their distance. *Common* is the root of the mean product of the errors of two renders
of Cycles with different seeds: what Cycles' limit and the reference do not share, with the reference's noise in it. Where it is near Cycles' error, most of
that is no noise, and comparing at equal error flatters tukor; so the last column but three compares the noise alone: that of Cycles, and that which trace reports.
tukor's times are of `--error`, or of `--samples` where that curve does not reach the error: CPU seconds, and in brackets how many times those of Cycles are, without
what comes before rendering (*start*: one sample of 16x9 pixels) and of the whole processes.

| scene | environment | Cycles at 256: CPU s, render, whole | RMSE | relative MSE | sRGB | tukor: start | at that RMSE | at that relative MSE | at that sRGB | noise of Cycles alone, sRGB: tukor at that | POV-Ray at that sRGB | noise, sRGB | common, sRGB |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|
{rows}

![error over CPU time](offline.svg)

## What `--error` promises
Reported / true RMSE in 8-bit sRGB; true is the distance from the reference, the square of its noise taken off that of the distance. What is reported is noise and, under suns, doubt:
lamps that wide look-ups saw, rightly or not ([notes/adaptive-sampling.md](notes/adaptive-sampling.md)). Where doubt leaves too little room the picture ends above what was asked, and says so.

| scene | environment | {asked} |
|---|---|{bars}
{promises}

## Throughput
At 16 samples a pixel the gold knot's few rays take less time than its file and the estimate of its error; at 256, those of Cycles above, they count.
Million rays a second of CPU: Embree alone casting the very packets of a trace that casts all rays of so many samples a pixel, and trace with these samples under `forest`, less the
start (the same process with one sample of 16x9 pixels: loading, tree, environment). *Triangles*: those of the files, all that Embree knows of; *closed form*:
what is left to it once trace has found that a mesh is a sphere and meets it by formula. *Not cast*: rays that trace knows to meet nothing, as no triangle's outline touches
their pixel; those count in all columns.

| scene | samples | Embree alone, triangles | closed form | trace | share of triangles | of closed form | not cast | start, CPU s | of it Embree's tree |
|---|---|---|---|---|---|---|---|---|---|
{limits}
"""

if __name__ == "__main__":
    main()
