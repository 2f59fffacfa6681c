"""Scenes, environments and programs of offline.py: what is rendered, and how each renderer is told."""
import json
import math
import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build/release"
TUKOR = BUILD / "apps/tukor/tukor"
FOLDER = ROOT / "build/offline"  # models, environments, pictures; references stay for the next run
PHOTOGRAPHS = pathlib.Path("/usr/share/blender/datafiles/studiolights/world")
TINT, IOR, EYE_Z, FOV, SIZE = (1.0, 0.77, 0.34), 1.5, 9.0, 25.0, (480, 270)
ROUGH = ["rough", "group"]  # of tools/feature_scenes.py
EYE, TARGET, ROUGH_SIZE = (0.0, 2.0, 8.0), (0.0, -0.1, 0.0), (320, 180)  # of these
MODELS = {"knot": ("torus-knot", -2.4, "gold"), "sphere": ("sphere", 0.0, "glass"), "mesh": ("torus-knot", 2.4, "glass")}
SCENES = {"all": ["knot", "sphere", "mesh"], "knot": ["knot"], "sphere": ["sphere"], "mesh": ["mesh"]}
MATERIALS = {"gold": "mirror:" + ",".join(map(str, TINT)), "glass": f"ior:{IOR}"}
MAPS = {"forest": "a photograph", "city": "a photograph with the sun", "detailed": "generated, 4096x2048, small sun"}


def run(command):
    """(CPU seconds, user and system; standard output). Ends the program when the command fails."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=FOLDER)
    if result.returncode:
        sys.exit(f"{command[0]} failed:\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, result.stdout


def prepare():
    FOLDER.mkdir(parents=True, exist_ok=True)
    new = [name for name in MODELS if not (FOLDER / f"{name}.obj").exists()]
    for name in new:
        shape, x, _ = MODELS[name]
        run([BUILD / "bench/export_shape", shape, FOLDER / f"{name}.obj", x, 0, 0])
    if new:
        run(["blender", "-b", "--factory-startup", "--python", ROOT / "bench/offline/normals.py", "--", *(f"{name}.obj" for name in new)])
    for name in MAPS:
        out = environment(name)
        if out.exists():
            continue
        if name == "detailed":
            run([BUILD / "bench/detailed_map", out])
        else:  # in Rec. 709: city.exr has primaries of its own, which the peers ignore
            run([TUKOR, "environment", "convert", PHOTOGRAPHS / out.name, "-o", out])


def environment(name):
    return FOLDER / f"{name}.exr"


def header_text(path, key):
    """A string attribute of an OpenEXR header."""
    data = path.read_bytes()[:65536]
    at = data.find(key.encode() + b"\0string\0")
    if at < 0:
        return ""
    at += len(key) + 8
    return data[at + 4:at + 4 + int.from_bytes(data[at:at + 4], "little")].decode()


def rough_model(scene):
    out = FOLDER / f"{scene}.glb"
    if not out.exists():
        run([sys.executable, ROOT / "tools/feature_scenes.py", FOLDER, scene])
    return out


def view(scene):
    """(eye, target, size)"""
    return (EYE, TARGET, ROUGH_SIZE) if scene in ROUGH else ((0.0, 0.0, EYE_Z), (0.0, 0.0, 0.0), SIZE)


def models_for_tukor(scene):
    if scene in ROUGH:
        return [rough_model(scene)]
    words = []
    for name in SCENES[scene]:
        words += [f"{name}.obj", "--material", f"{name}={MATERIALS[MODELS[name][2]]}"]
    return words


def tukor(scene, map_name, quality, seed=0, out=None, threads=1, size=None):
    """`quality`: words such as --samples 16. (CPU seconds of the whole process, picture)"""
    eye, target, usual = view(scene)
    eye, target = (",".join(map(str, point)) for point in (eye, target))
    out = out or FOLDER / f"tukor-{scene}-{map_name}{''.join(map(str, quality))}-{seed}.exr"
    cpu, _ = run([TUKOR, "render", "--quiet", "--renderer", "trace", "--threads", threads, "--environment", environment(map_name),
                  "--eye", eye, "--target", target, "--fov", FOV, "--size", "%dx%d" % (size or usual), "--seed", seed, *quality,
                  "-o", out, *models_for_tukor(scene)])
    return cpu, out


def reference(scene, map_name, samples):
    """Two pictures of at least that many samples a pixel, with seeds of their own; made once."""
    pictures = []
    there = [int(path.name.split("-")[3]) for path in FOLDER.glob(f"reference-{scene}-{map_name}-*-1002.exr")]
    samples = max([samples, *there])
    for seed in (1001, 1002):
        out = FOLDER / f"reference-{scene}-{map_name}-{samples}-{seed}.exr"
        if not out.exists():
            partial = out.with_suffix(".partial.exr")
            tukor(scene, map_name, ["--samples", samples], seed, partial)
            partial.rename(out)
        pictures.append(out)
    return pictures


def cycles(scene, map_name, samples, seed=1):
    """(CPU seconds of the render alone, without Blender's start and import, picture)"""
    out = FOLDER / f"cycles-{scene}-{map_name}-{samples}-{seed}.exr"
    models = [[str(rough_model(scene)), ""]] if scene in ROUGH else [[str(FOLDER / f"{name}.obj"), MODELS[name][2]] for name in SCENES[scene]]
    eye, target, size = view(scene)
    job = {"models": models, "tint": TINT, "ior": IOR, "environment": str(environment(map_name)), "eye": eye, "target": target,
           "fov": FOV, "size": size, "samples": samples, "seed": seed, "out": str(out)}
    whole, text = run(["blender", "-b", "--factory-startup", "--python", ROOT / "bench/offline/cycles.py", "--", json.dumps(job)])
    out.with_suffix(".whole").write_text(str(whole))
    return float(re.search(r"CYCLES_CPU ([\d.]+)", text)[1]), out


def cycles_whole(picture):
    """CPU seconds of the whole process that made one of Cycles' pictures."""
    return float(pathlib.Path(picture).with_suffix(".whole").read_text())


def start(scene, map_name):
    """CPU seconds of tukor before it traces: those of one sample of 16x9 pixels; the least of three."""
    return min(tukor(scene, map_name, ["--samples", 1], size=(16, 9), out=FOLDER / "start.exr")[0] for _ in range(3))


def cached(renderer, scene, map_name, quality, again):
    """(CPU seconds, picture) of a peer; its time is kept beside the picture."""
    note = FOLDER / f"{renderer.__name__}-{scene}-{map_name}-{'-'.join(map(str, quality))}.json"
    if note.exists() and not again:
        cpu, picture = json.loads(note.read_text())
    else:
        cpu, picture = renderer(scene, map_name, *quality)
        note.write_text(json.dumps([cpu, str(picture)]))
    return cpu, picture


def pov_mesh(name):
    """The OBJ as a mesh2 include file, read once per scene by POV-Ray."""
    out = FOLDER / f"{name}.inc"
    if not out.exists():
        rows = {"v": [], "vn": [], "f": []}
        for line in (FOLDER / f"{name}.obj").read_text().splitlines():
            head, *rest = line.split()
            if head in rows:
                rows[head].append("<" + ",".join(str(int(r.split("/")[0]) - 1) if head == "f" else r for r in rest) + ">")
        out.write_text("mesh2 {\n" + "\n".join(
            f"{key} {{ {len(rows[head])}, {', '.join(rows[head])} }}"
            for key, head in (("vertex_vectors", "v"), ("normal_vectors", "vn"), ("face_indices", "f"))))
    return out


def povray(scene, map_name, across):
    """`across` x `across` samples a pixel. (CPU seconds of the whole process, picture)"""
    out = FOLDER / f"povray-{scene}-{map_name}-{across}.exr"
    surface = {"gold": "pigment { rgb <%g,%g,%g> } finish { ambient 0 diffuse 0 reflection { 1 metallic } }" % TINT,
               "glass": "pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }"}
    wide = 2 * math.degrees(math.atan(math.tan(math.radians(FOV) / 2) * SIZE[0] / SIZE[1]))
    text = ["#version 3.7; global_settings { assumed_gamma 1 max_trace_level 32 adc_bailout 1/512 }",
            f"camera {{ location <0,0,{EYE_Z}> right -x*{SIZE[0]}/{SIZE[1]} angle {wide} look_at 0 }}",
            f'sky_sphere {{ pigment {{ image_map {{ exr "{environment(map_name)}" gamma 1 map_type 1 interpolate 2 }} rotate y*270 }} }}']
    for name in SCENES[scene]:
        kind = MODELS[name][2]
        text.append(f'#include "{pov_mesh(name)}"\ntexture {{ {surface[kind]} }} interior {{ ior {IOR} }} }}')
    source = FOLDER / f"{scene}-{map_name}.pov"
    source.write_text("\n".join(text) + "\n")
    cpu, _ = run(["povray", f"+I{source}", f"+O{out}", "+FE", "-D", "+WT1", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "File_Gamma=1", "+AM1",
                  "+A0.00001", f"+R{across}", "-J"])
    return cpu, out


def errors(references, pictures):
    """[(RMSE, relative MSE, RMSE in 8-bit sRGB)]: the references' own noise, then of each picture, then what two have in common."""
    _, text = run([BUILD / "bench/picture_error", *references, *pictures])
    return [tuple(map(float, line.split())) for line in text.splitlines()]


def traversal(scene, samples, triangles=False):
    """(million rays, CPU seconds of Embree alone for them, CPU seconds of building).

    `triangles`: spheres are cast as the triangles that the file has, not in closed form as trace does.
    """
    words = [BUILD / "bench/traversal", "%dx%d" % SIZE, samples, EYE_Z, FOV, *models_for_tukor(scene), *(["--triangles"] if triangles else [])]
    rays, building, casting = map(float, run(words)[1].split())
    return rays / 1e6, casting, building
