#!/usr/bin/env python3
"""Tests of compact_glsl.py."""
import unittest

from compact_glsl import compacted

SHADER = """#version 300 es
precision highp float;
#ifdef __cplusplus
#define TUKOR_FN inline
#else
#define TUKOR_FN
#define TUKOR_OUT(type) out type
#endif
#line 3 1
uniform highp usampler2D nodeTexture;  // kept
uniform vec4 media[32];
in vec3 fromEye;
layout(location = 0) out vec4 colour;
struct Found { float distance; int triangle; vec2 uv; };
/* a comment
   of two lines */
TUKOR_FN Found nearest(vec3 step, TUKOR_OUT(float) other) {
    Found found;
    found.distance = 0.50f - -step.x;
#if MODE == 1
    found.triangle = int(0x1Fu);
#endif
    other = 1.0 + 2.5e-3;
    return found;
}
void main() { float value; Found f = nearest(fromEye, value); colour = media[0] * f.distance * step(0.0, value); }
"""


class CompactGlsl(unittest.TestCase):
    def setUp(self):
        self.text = compacted(SHADER)

    def test_keeps_what_the_outside_knows(self):
        for name in ("nodeTexture", "media", "fromEye", "colour", "main", "MODE"):
            self.assertRegex(self.text, rf"\b{name}\b")

    def test_shortens_what_the_text_declares(self):
        for name in ("Found", "nearest", "found", "other", "triangle", "value", "TUKOR", "cplusplus", "line", "comment"):
            self.assertNotIn(name, self.text)

    def test_keeps_built_in_functions_whose_names_are_variables_too(self):
        self.assertIn("step(0.,", self.text)
        self.assertIn(".x", self.text)

    def test_names_alike_what_shaders_share(self):
        other = SHADER.replace("value", "figure").replace("nearest(fromEye", "nearest(2.0 * fromEye")
        first, second = (compacted(text, beside=[SHADER, other]) for text in (SHADER, other))
        self.assertEqual(first[first.index("struct"):first.index("void main")], second[second.index("struct"):second.index("void main")])

    def test_leaves_out_what_is_never_defined(self):
        text = "#version 300 es\n#ifdef FINISHES\nint more;\n#endif\nint other;\n"
        self.assertNotIn("FINISHES", compacted(text, never=["FINISHES"]))
        self.assertIn("FINISHES", compacted(text))

    def test_keeps_numbers_and_signs(self):
        self.assertIn(".5- -step.x", self.text)
        self.assertIn("1.+2.5e-3", self.text)
        self.assertIn("0x1Fu", self.text)

    def test_keeps_preprocessor_lines_on_lines_of_their_own(self):
        lines = self.text.splitlines()
        self.assertEqual(lines[0], "#version 300 es")
        self.assertIn("#if MODE == 1", lines)
        self.assertIn("#endif", lines)


unittest.main()
