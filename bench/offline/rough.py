#!/usr/bin/env python3
"""CPU time at equal error on rough and textured scenes: trace beside Cycles, one thread each, in one run.

Writes docs/offline-rough.md. References and Cycles' pictures stay in build/offline; delete it to begin anew.

after: cmake --preset release -DTUKOR_BENCH=ON && cmake --build --preset release
needs: tools/install_packages.sh bench
"""
import argparse

import scenes
from curves import cpu_at, figure

CYCLES, SAMPLES, ERRORS = (16, 64), ("4", "16", "64"), ("12", "6", "3")


def measure(scene, map_name, args):
    """Rows of the table. Each renderer is measured against its own limit, so that what they mean differently is no error."""
    ours = scenes.reference(scene, map_name, args.reference)
    samples = max([args.reference, *(int(path.stem.split("-")[3]) for path in scenes.FOLDER.glob(f"cycles-{scene}-{map_name}-*-1002.json"))])
    theirs = [scenes.cached(scenes.cycles, scene, map_name, (samples, seed), False)[1] for seed in (1001, 1002)]
    apart = scenes.errors(ours, theirs)[-1]
    peers = [scenes.cached(scenes.cycles, scene, map_name, (n, 1), args.peers_again) for n in CYCLES]
    noise, *errors, _ = scenes.errors(theirs, [picture for _, picture in peers])
    curves = {}
    for name, words in (("--samples", SAMPLES), ("--error", ERRORS)):
        runs = [scenes.tukor(scene, map_name, [name, word]) for word in words]
        own, *found, _ = scenes.errors(ours, [picture for _, picture in runs])
        curves[name] = [(cpu, *error) for (cpu, _), error in zip(runs, found)]
        for word, point in zip(words, curves[name]):
            print("    ", name, word, *(f"{value:.4g}" for value in point), flush=True)
    rows = []
    for n, (cpu, _), error in zip(CYCLES, peers, errors):
        cells = [scene, map_name, str(n), figure(cpu), *map(figure, error)]
        for column in (1, 2, 3):
            for curve in curves.values():
                time = cpu_at(curve, error[column - 1], column)
                cells.append("-" if time is None else f"{figure(time, 2)} ({figure(cpu / time, 2)}x)")
        cells += [f"{figure(own[2])}, {figure(noise[2])}", figure(apart[2])]
        rows.append("| " + " | ".join(cells) + " |")
        print(rows[-1], flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default=",".join(scenes.ROUGH))
    parser.add_argument("--maps", default="forest,city")
    parser.add_argument("--reference", type=int, default=128, help="least samples a pixel of each of the two pictures that make a reference")
    parser.add_argument("--peers-again", action="store_true", help="render the peer's pictures again, not only tukor's")
    parser.add_argument("--no-write", action="store_true", help="print only")
    args = parser.parse_args()
    scenes.prepare()
    rows = [row for scene in args.scenes.split(",") for map_name in args.maps.split(",") for row in measure(scene, map_name, args)]
    if not args.no_write:
        (scenes.ROOT / "docs/offline-rough.md").write_text(TEXT.format(
            rows="\n".join(rows), size="%dx%d" % scenes.ROUGH_SIZE, reference=args.reference))


TEXT = """# CPU time at equal error, rough and textured

Written by `bench/offline/rough.py`. Two scenes of `tools/feature_scenes.py`: `rough`, spheres of rough gold, clay, with textures of colour and of roughness, and
white, on a tiled floor; `group`, rough gold and clay beside exact glass and gold, on that floor. {size}, one thread each, under `forest` (a photograph) and `city` (a photograph
with the sun). Cycles (Debian's Blender 3.4) reads the same GLB by its own importer, with multiple-scattering GGX. CPU seconds, figures and environments are those of
[offline.md](offline.md).

Each renderer's error is that against its own limit, the mean of two pictures of {reference} samples a pixel or more (whose noise, half their distance in 8-bit sRGB, is the last column but one: of
tukor, of Cycles): what the two mean differently by a material is no noise. *Apart* says how far the limits are from each other, in 8-bit sRGB:
Principled does not take what a dielectric reflects from its matt part, and meets spheres as polygons.
`-`: that curve does not reach it. Caustics in `group` are rare bright pixels: RMSE and relative MSE there are of a few, in either limit, too; 8-bit sRGB is not.

| scene | environment | Cycles, samples | CPU s | RMSE | relative MSE | sRGB | tukor --samples: CPU s at that RMSE | --error | at that relative MSE | --error | at that sRGB | --error | noise | apart |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|
{rows}
"""

if __name__ == "__main__":
    main()
