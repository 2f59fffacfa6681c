#!/usr/bin/env python3
"""The layer check finds what it is there to find."""
import tempfile
import unittest
from pathlib import Path

import check_layers


class CheckLayers(unittest.TestCase):
    def violations(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            for path, text in files.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text, encoding="utf-8")
            return check_layers.check(root)

    def test_accepts_includes_up_the_list(self):
        self.assertEqual(self.violations({
            "src/tukor/base/error.h": "#include <string>\n",
            "src/tukor/image/image.h": '#include <glm/glm.hpp>\n\n#include "tukor/base/error.h"\n',
            "src/tukor/image/image_test.cpp": "#include <gtest/gtest.h>\n",
            "apps/tukor/main.cpp": '#include "tukor/image/image.h"\n#include "messages.h"\n',
            "apps/tukor/messages.h": "",
        }), [])

    def test_finds_includes_down_the_list(self):
        found = self.violations({
            "src/tukor/base/a.h": '#include "tukor/scene/scene.h"\n',
            "src/tukor/scene/scene.h": "",
        })
        self.assertEqual(found, ['src/tukor/base/a.h: #include "tukor/scene/scene.h": base may not see scene'])

    def test_keeps_the_renderers_apart(self):
        files = {"src/tukor/trace/a.h": "", "src/tukor/gl/b.h": "",
                 "src/tukor/trace/c.cpp": '#  include "tukor/gl/b.h"\n',
                 "src/tukor/gl/shaders/d.frag": '#include "tukor/trace/a.h"\n'}
        self.assertEqual(len(self.violations(files)), 2)

    def test_keeps_libraries_where_they_belong(self):
        for path, header in [("src/tukor/gl/a.cpp", "embree3/rtcore.h"), ("src/tukor/app/a.cpp", "GLFW/glfw3.h"),
                             ("src/tukor/scene/a.cpp", "imgui.h"), ("src/tukor/image/a.cpp", "gtest/gtest.h"),
                             ("src/tukor/optics/a.h", "boost/any.hpp")]:
            self.assertEqual(len(self.violations({path: f"#include <{header}>\n"})), 1, header)

    def test_lets_one_file_include_embree(self):
        one = {"src/tukor/trace/a.cpp": "#include <embree3/rtcore.h>\n#include <embree3/rtcore_ray.h>\n"}
        self.assertEqual(self.violations(one), [])
        self.assertEqual(len(self.violations({**one, "src/tukor/trace/b.cpp": "#include <embree3/rtcore.h>\n"})), 1)

    def test_finds_missing_files_and_relative_paths(self):
        self.assertEqual(len(self.violations({"src/tukor/base/a.h": '#include "tukor/base/gone.h"\n'})), 1)
        self.assertEqual(len(self.violations({"src/tukor/base/a.h": '#include "b.h"\n', "src/tukor/base/b.h": ""})), 1)
        self.assertEqual(len(self.violations({"apps/tukor/main.cpp": '#include "gone.h"\n'})), 1)

    def test_knows_every_module(self):
        self.assertEqual(len(self.violations({"src/tukor/util/a.h": ""})), 1)


if __name__ == "__main__":
    unittest.main()
