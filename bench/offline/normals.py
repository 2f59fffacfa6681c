# Run inside Blender by scenes.py: gives OBJs the vertex normals that Blender computes, so that all renderers shade with the same ones.
# (Blender keeps the normals of a file to 16 bits, 1e-4 radians, which shows in glass.)
#
# blender -b --factory-startup --python normals.py -- FILE.obj...
import sys

import bpy

for path in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.obj_import(filepath=path, forward_axis="NEGATIVE_Z", up_axis="Y")
    vertices = bpy.context.selected_objects[0].data.vertices
    lines = open(path).read().splitlines()
    number = 0
    for i, line in enumerate(lines):
        if line.startswith("vn "):
            lines[i] = "vn %.9g %.9g %.9g" % tuple(vertices[number].normal)
            number += 1
    assert number == len(vertices)
    open(path, "w").write("\n".join(lines) + "\n")
