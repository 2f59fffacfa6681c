#!/usr/bin/env python3
"""Inline a shader's #includes and write it as a C++ string constant.

usage: embed_shader.py INCLUDE_ROOT INPUT OUTPUT NAME [--depfile FILE] [--raw] [--compact [--never NAME]]

`#include "tukor/..."` is replaced by that file, once each. `#line` directives carry a number per file; the table of numbers and
paths goes with the constant, so that a driver's `3:17` can be told as `tukor/optics/fresnel.h:17`. --raw writes plain GLSL (for
glslangValidator) instead of C++; --compact makes it small, together with the other shaders of its folder, see compact_glsl.py;
drivers' errors then have no lines to name. Branches of what is --never defined are left out.
"""
import argparse
import pathlib
import re
import sys

from compact_glsl import compacted

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')


def located(root, path):
    """The file below `root`, or else below its parent: shaders of tests include those of src."""
    for folder in (root, root.parent):
        if (folder / path).is_file():
            return folder / path
    sys.exit(f"embed_shader.py: {path}: neither below {root} nor below {root.parent}")


def flatten(root, path, files, out):
    number = len(files)
    files.append(path)
    lines = located(root, path).read_text(encoding="utf-8").splitlines()
    if number > 0:
        out.append(f"#line 1 {number}")
    for row, line in enumerate(lines, start=1):
        match = INCLUDE.match(line)
        if match:
            if match[1] not in files:
                flatten(root, match[1], files, out)
                out.append(f"#line {row + 1} {number}")
            else:
                out.append("")
        elif re.match(r"^\s*#\s*pragma\s+once", line):
            out.append("")
        else:
            out.append(line)
            if line.startswith("#version"):
                # GLSL ES 3.00 has no default precision for floats and some samplers in fragment shaders.
                out += ["precision highp float;", "precision highp int;", "precision highp sampler2D;",
                        "precision highp isampler2D;", "precision highp usampler2D;",
                        "precision highp samplerCube;", f"#line {row + 1} {number}"]


def flattened(root, path):
    """Its text with all that it includes, and their paths."""
    files, out = [], []
    flatten(root, path, files, out)
    # GLSL ES 3.00 source is ASCII outside comments; drivers differ on comments, so make all of it ASCII.
    return "\n".join(out).encode("ascii", "replace").decode() + "\n", files


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("input")
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("name")
    parser.add_argument("--depfile", type=pathlib.Path)
    parser.add_argument("--raw", action="store_true")
    parser.add_argument("--compact", action="store_true")
    parser.add_argument("--never", action="append", default=[])
    args = parser.parse_args()
    text, files = flattened(args.root, args.input)
    included = set(files)
    if args.compact:
        folder = located(args.root, args.input).parent
        beside = [flattened(args.root, str(path.relative_to(args.root))) for path in sorted(folder.iterdir())
                  if path.suffix in (".frag", ".vert") and not path.name.startswith("test_")]
        included.update(*(paths for _, paths in beside))
        text = compacted(text, args.never, [other for other, _ in beside])
        files = files[:1]
    if args.raw:
        args.output.write_text(text)
    else:
        # 64 KiB is the least a compiler must take for one literal.
        pieces = [text[i:i + 16000] for i in range(0, len(text), 16000)]
        body = "\n".join(f'R"~~~({piece})~~~"' for piece in pieces)
        names = ", ".join(f'"{f}"' for f in files)
        args.output.write_text(
            f"// Made by embed_shader.py from {args.input}.\n"
            f'#include "tukor/gl/shader_source.h"\n\nnamespace tukor::gl::shaders {{\n'
            f"static const char* const {args.name}Files[] = {{{names}}};\n"
            f"extern const ShaderSource {args.name};\n"
            f"const ShaderSource {args.name} = {{{body},\n    {args.name}Files}};\n}}\n")
    if args.depfile:
        deps = " ".join(str(located(args.root, f)) for f in sorted(included))
        args.depfile.write_text(f"{args.output}: {deps}\n")


main()
