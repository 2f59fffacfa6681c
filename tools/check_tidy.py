#!/usr/bin/env python3
"""Runs clang-tidy on the project's own sources, tests excepted, that changed since they last passed.

usage: check_tidy.py BUILD_DIR [--full] [--all] [FILE...]    a built Ninja build

--full runs every check of .clang-tidy instead of the quick ones; --all forgets what passed.

What passed is remembered in BUILD_DIR/tidy by a hash of the file, the project's headers it includes, its command and
.clang-tidy.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CHECKED = ("src/tukor/", "apps/", "examples/")
# A third of the time of all checks, which is spent in system headers; the rest find little in this project.
QUICK = ("-*,performance-*,-performance-enum-size,-performance-no-int-to-ptr,misc-unused-*,misc-redundant-expression,"
         "modernize-use-override,modernize-use-nullptr,bugprone-use-after-move,bugprone-branch-clone,"
         "bugprone-dangling-handle,bugprone-integer-division,bugprone-macro-parentheses,bugprone-sizeof-expression")


def dependencies(build):
    """Object file -> files that the compiler read for it, by Ninja's log."""
    log = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    found, current = {}, None
    for line in log.splitlines():
        if line.startswith("    "):
            found[current].append((build / line.strip()).resolve())
        elif ":" in line:
            current = line.split(":")[0]
            found[current] = []
    return found


def stamp(entry, files, checks):
    digest = hashlib.sha256((entry["command"] + checks).encode())
    digest.update((ROOT / ".clang-tidy").read_bytes())
    for file in sorted(set(files)):
        if ROOT in file.parents and file.is_file():
            digest.update(str(file.relative_to(ROOT)).encode() + file.read_bytes())
    return digest.hexdigest()


def commands(build):
    """The compile commands without g++'s precompiled headers: clang reads none, and sources must do without."""
    entries = json.loads((build / "compile_commands.json").read_text())
    for entry in entries:
        entry["command"] = re.sub(r" -Winvalid-pch| -include \S*/cmake_pch\.hxx", "", entry["command"])
    return entries


def tidy(folder, checks, file):
    run = subprocess.run(["clang-tidy", "-p", folder, "--quiet", *checks, file], capture_output=True, text=True)
    # Errors only: the count of warnings suppressed in system headers is noise.
    return run.returncode == 0, run.stdout + "".join(l + "\n" for l in run.stderr.splitlines() if "error" in l)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("files", nargs="*", type=Path)
    options = parser.parse_args()
    build = options.build.resolve()
    passed = build / "tidy"
    passed.mkdir(exist_ok=True)
    checks = [] if options.full else [f"--checks={QUICK}"]
    only = {file.resolve() for file in options.files}

    deps = dependencies(build)
    todo = {}
    entries = commands(build)
    (passed / "compile_commands.json").write_text(json.dumps(entries))
    for entry in entries:
        file = (Path(entry["directory"]) / entry["file"]).resolve()
        if ROOT not in file.parents or build in file.parents or file.name.endswith("_test.cpp"):
            continue
        if not file.relative_to(ROOT).as_posix().startswith(CHECKED) or (only and file not in only):
            continue
        output = re.search(r" -o (\S+)", entry["command"])[1]
        mark = passed / stamp(entry, deps.get(output, []) + [file], "".join(checks))
        if options.all or not mark.exists():
            todo[file] = mark

    failures = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = pool.map(lambda file: tidy(passed, checks, file), todo)
        for mark, (good, output) in zip(todo.values(), results):
            if good:
                mark.touch()
            else:
                failures += 1
                print(output)
    print(f"{len(todo)} files checked, {failures} with findings")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
