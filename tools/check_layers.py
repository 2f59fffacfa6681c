#!/usr/bin/env python3
"""Checks every #include of the project against the table of layers below.

usage: check_layers.py [ROOT]      exit status 1 and one line per violation
"""
import re
import sys
from pathlib import Path

# module: the modules that it may include, besides itself. The order is the order of the layers.
LAYERS = {
    "base": "",
    "optics": "base",
    "transport": "optics",
    "materials": "optics base",
    "image": "optics base",
    "environment": "image optics base",
    "geometry": "optics base",
    "scene": "geometry materials environment image optics base",
    "trace": "scene geometry materials environment image transport optics base",
    "gl": "scene geometry materials environment image transport optics base",
    "app": "gl trace scene geometry materials environment image transport optics base",
}

# What may include a header that is not the project's: folders or files below ROOT; "*" is everyone.
THIRD_PARTY = [
    (r"glm/", "*"),
    (r"fmt/", "*"),
    (r"(gtest|gmock)/", "tests"),
    (r"(oneapi/)?tbb/", "src/tukor/base/parallel.cpp src/tukor/trace"),
    (r"embree\d*/", "src/tukor/trace src/tukor/geometry/bvh_embree_test.cpp"),
    (r"(OpenEXR|Imath)/", "src/tukor/image src/tukor/environment/orientation_test.cpp"),
    (r"(png|spng|jpeglib|jerror|turbojpeg|libdeflate|zlib|zstd)\.h$", "src/tukor/image"),
    (r"draco/", "src/tukor/scene bench/packed_shapes.cpp"),
    (r"meshoptimizer\.h$", "src/tukor/scene bench/packed_shapes.cpp"),
    (r"assimp/", "src/tukor/scene"),
    (r"nlohmann/", "src/tukor/app apps src/tukor/environment src/tukor/image bench"),
    (r"EGL/", "src/tukor/gl/context.cpp apps/tukor/view"),
    (r"GLES[23]/", "src/tukor/gl apps/tukor/view apps/web tests"),
    (r"GLFW/", "apps/tukor"),
    (r"unwind\.h$", "apps/web/unwind.cpp"),
    (r"imgui", "apps/tukor"),
    (r"CLI/", "apps/tukor"),
    (r"emscripten[./]", "apps/web src/tukor/base/number_text.cpp"),
    (r"pthread\.h$", "apps/web/threads.cpp"),
    (r"benchmark/", "bench"),
    (r"malloc\.h$", "apps/tukor/large_pages.cpp"),
    (r"(unistd|fcntl|dlfcn|poll|signal|csignal)\.h$|sys/", "src/tukor/base src/tukor/image apps src/tukor/app bench fuzz tests"),
]

# Headers that exactly one file may include, so that the library behind can be exchanged there.
ONE_FILE_EACH = [r"embree\d*/", r"EGL/egl\.h$"]

SUFFIXES = {".h", ".cpp", ".vert", ".frag", ".glsl"}
FOLDERS = ["src", "apps", "examples", "tests", "bench", "fuzz"]
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD = re.compile(r"[a-z_0-9]+$")


def is_test(path):
    return path.startswith("tests/") or path.endswith("_test.cpp") or "_test/" in path


def allowed_module(path, module):
    parts = path.split("/")
    if parts[0] != "src":
        return True
    own = parts[2]
    return module == own or module in LAYERS.get(own, "").split()


def allowed_third_party(path, header):
    for pattern, places in THIRD_PARTY:
        if re.match(pattern, header):
            if places == "*":
                return True
            if places == "tests":
                return is_test(path)
            return any(path == place or path.startswith(place + "/") for place in places.split())
    return False


def check(root):
    violations = []
    users = {pattern: [] for pattern in ONE_FILE_EACH}
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in SUFFIXES or not file.is_file():
                continue
            path = file.relative_to(root).as_posix()
            if path.startswith("src/tukor/") and path.split("/")[2] not in LAYERS:
                violations.append(f"{path}: not in a module of the table in tools/check_layers.py")
                continue
            for match in INCLUDE.finditer(file.read_text(encoding="utf-8")):
                quoted, header = match[1] == '"', match[2]
                where = f"{path}: {match[0].strip()}"
                for pattern in ONE_FILE_EACH:
                    if re.match(pattern, header) and not is_test(path):
                        users[pattern].append(path)
                if header.startswith("tukor/"):
                    module = header.split("/")[1]
                    if not (root / "src" / header).is_file():
                        violations.append(f"{where}: no such file below src")
                    elif not allowed_module(path, module):
                        violations.append(f"{where}: {path.split('/')[2]} may not see {module}")
                elif quoted:
                    if path.startswith("src/"):
                        violations.append(f"{where}: write the path from src, tukor/...")
                    elif not any((top / header).is_file() for top in (root, root / "tests")) and not any((base / header).is_file() for base in file.parents if root in base.parents):
                        violations.append(f"{where}: no such file beside or above it")
                elif not STANDARD.match(header) and not allowed_third_party(path, header):
                    violations.append(f"{where}: not allowed here; see THIRD_PARTY in tools/check_layers.py")
    for pattern, paths in users.items():
        if len(set(paths)) > 1:
            violations.append(f"{' and '.join(sorted(set(paths)))}: only one file may include {pattern}")
    return violations


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    violations = check(root)
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
