#!/usr/bin/env python3
"""Runs the `tukor` program as people do and reads what it says.

usage: cli_test.py PROGRAM [NAME...]    NAME: only the tests whose names contain it
"""
import json
import os
import struct
import subprocess
import sys
import tempfile
import zlib

PROGRAM = os.path.abspath(sys.argv[1])


def run(*arguments, status=0, folder=None):
    """Standard output and error; the exit status must be as expected."""
    result = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120, cwd=folder,
                            errors="replace")
    said = f"{' '.join(arguments)}: status {result.returncode}, expected {status}\n{result.stdout}{result.stderr}"
    assert result.returncode == status, said[-3000:]
    return result.stdout, result.stderr


def fails(*arguments, says, status=1, folder=None):
    """One line of error that begins with the program's name and contains `says`."""
    out, err = run(*arguments, status=status, folder=folder)
    line = err.splitlines()[0]
    assert line.startswith("tukor: ") and says in line, f"{arguments}: expected {says!r} in {err!r}"
    assert out == "", out
    if status == 2:
        assert err.splitlines()[1].startswith("Try `tukor"), err
    else:
        assert len(err.splitlines()) == 1, err


def write_png(path, width, height, pixel):
    """An 8-bit RGB PNG whose pixels are pixel(column, row)."""
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def test_help_teaches(folder):
    out, _ = run("--help")
    for word in ("Usage: tukor COMMAND", "materials", "compare", "Examples", "--version"):
        assert word in out, word
    out, _ = run("compare", "--help")
    assert "Usage: tukor compare A B [options]" in out and "--heat-map OUT" in out, out
    assert "\n\n\n" not in out
    assert max(len(line) for line in out.splitlines()) <= 100


def test_version(folder):
    out, _ = run("--version")
    assert out.startswith("tukor ") and out[6].isdigit(), out


def test_no_command_shows_help(folder):
    _, err = run(status=2)
    assert "Usage: tukor COMMAND" in err, err


def test_misspelt_words(folder):
    fails("compar", says="'compar' is unknown; did you mean compare?", status=2)
    fails("compare", "a", "b", "--heat-mop", "c", says="unknown option --heat-mop; did you mean --heat-map?", status=2)
    fails("compare", "a", "b", "c", says="unexpected argument 'c'", status=2)
    fails("compare", "a", says="B is required", status=2)
    fails("materials", "--xml", says="unknown option --xml", status=2)


def test_materials(folder):
    out, _ = run("materials")
    assert "metal:0.21,0.485,1.29/3.13,2.23,1.76" in out and "ior:1.333" in out, out
    materials = {row["name"]: row for row in json.loads(run("materials", "--json")[0])}
    assert materials["gold"]["eta"] == [0.21, 0.485, 1.29] and materials["gold"]["k"] == [3.13, 2.23, 1.76]
    assert materials["silver"]["eta"] == [0.15, 0.14, 0.13] and materials["silver"]["k"] == [3.7, 3.11, 2.47]
    assert materials["glass"]["eta"][0] == 1.46 and materials["water"]["eta"][0] == 1.333
    assert all(row["source"] for row in materials.values())


def test_compare(folder):
    a, b, small = (os.path.join(folder, name) for name in ("a.png", "b.png", "small.png"))
    write_png(a, 8, 4, lambda x, y: (100, 100, 100))
    write_png(b, 8, 4, lambda x, y: (103, 103, 103))
    write_png(small, 4, 4, lambda x, y: (0, 0, 0))
    assert "3.0" in run("compare", a, b)[0]
    run("compare", a, b, "--max-rmse", "3.01")
    run("compare", a, b, "--max-rmse", "2.99", status=1)
    heat = os.path.join(folder, "heat.png")
    run("compare", a, b, "--heat-map", heat)
    assert os.path.getsize(heat) > 0
    fails("compare", a, small, says="8 x 4")
    fails("compare", a, os.path.join(folder, "none.png"), says="none.png")
    fails("compare", a, b, "--heat-map", "heat.bmp", says="heat.bmp")
    fails("compare", a, b, "--max-rmse", "many", says="--max-rmse: 'many' is not a number", status=2)


def test_options_page(folder):
    """docs/options.md is what the program writes."""
    page = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "options.md")
    written = run("--markdown-options")[0]
    with open(page, encoding="utf-8") as file:
        assert file.read() == written, "docs/options.md is old: tukor --markdown-options > docs/options.md"


def main():
    tests = {name: test for name, test in globals().items() if name.startswith("test_")}
    wanted = sys.argv[2:]
    failed = 0
    for name, test in tests.items():
        if wanted and not any(word in name for word in wanted):
            continue
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(folder)
                print(f"ok      {name}")
            except AssertionError as error:
                failed += 1
                print(f"FAILED  {name}: {error}")
    sys.exit(1 if failed else 0)


main()
