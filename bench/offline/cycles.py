# Run inside Blender by scenes.py: renders OBJs of smooth gold and glass, or glTF, with Cycles under an equirectangular map, one thread.
#
# blender -b --factory-startup --python cycles.py -- JSON
import json
import math
import sys
import time

import bpy
import mathutils

job = json.loads(sys.argv[sys.argv.index("--") + 1])
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def smooth_material(kind):
    material = bpy.data.materials.new(kind)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    if kind == "gold":  # a constant tint: Cycles 3.4 has no complex index
        surface = nodes.new("ShaderNodeBsdfGlossy")
        surface.distribution = "SHARP"
        surface.inputs["Color"].default_value = (*job["tint"], 1.0)
    else:
        surface = nodes.new("ShaderNodeBsdfGlass")
        surface.distribution = "SHARP"
        surface.inputs["IOR"].default_value = job["ior"]
    links.new(surface.outputs[0], output.inputs["Surface"])
    return material


def import_gltf(path):
    import numpy
    numpy.bool = bool  # Blender 3.4's importer asks for it; Debian's numpy has it no more
    bpy.ops.import_scene.gltf(filepath=path, convert_lighting_mode="COMPAT")
    scene.frame_set(1000)  # after all animations
    for material in bpy.data.materials:
        for node in material.node_tree.nodes if material.use_nodes else ():
            if node.type == "BSDF_PRINCIPLED":
                node.distribution = "MULTI_GGX"  # keeps energy, as we do


for path, kind in job["models"]:
    if path.endswith(".glb"):
        import_gltf(path)
        continue
    bpy.ops.wm.obj_import(filepath=path, forward_axis="NEGATIVE_Z", up_axis="Y")
    for item in bpy.context.selected_objects:
        item.data.materials.clear()
        item.data.materials.append(smooth_material(kind))
        item.data.use_auto_smooth = False  # the file's normals are those that Blender computes
        for polygon in item.data.polygons:
            polygon.use_smooth = True

world = bpy.data.worlds.new("world")
scene.world = world
world.use_nodes = True
nodes, links = world.node_tree.nodes, world.node_tree.links
image = nodes.new("ShaderNodeTexEnvironment")
image.image = bpy.data.images.load(job["environment"])
mapping, coordinates = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeTexCoord")
mapping.inputs["Rotation"].default_value = (0.0, 0.0, -math.pi / 2)  # Blender's centre is +X; ours -Z, Blender's +Y
links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
links.new(mapping.outputs["Vector"], image.inputs["Vector"])
links.new(image.outputs["Color"], nodes["Background"].inputs["Color"])
nodes["Background"].inputs["Strength"].default_value = job.get("intensity", 1.0)

camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
scene.camera = camera
eye, target = (mathutils.Vector((p[0], -p[2], p[1])) for p in (job["eye"], job["target"]))  # our +Y is Blender's +Z
camera.location = eye
camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
camera.data.sensor_fit = "VERTICAL"
camera.data.angle = math.radians(job["fov"])

scene.render.engine = "CYCLES"
scene.render.resolution_x, scene.render.resolution_y = job["size"]
scene.render.resolution_percentage = 100
scene.render.threads_mode, scene.render.threads = "FIXED", 1
cycles = scene.cycles
cycles.device = "CPU"
cycles.samples = job["samples"]
cycles.seed = job["seed"]
cycles.use_adaptive_sampling = cycles.use_denoising = False
cycles.pixel_filter_type = "BOX"
cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 32
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
cycles.blur_glossy = 0.0
cycles.caustics_reflective = cycles.caustics_refractive = True
picture = job["out"].endswith(".jpg")
scene.view_settings.view_transform = "Standard" if picture else "Raw"
scene.render.image_settings.file_format = "JPEG" if picture else "OPEN_EXR"
if not picture:
    scene.render.image_settings.color_depth = "32"
scene.render.filepath = job["out"]

begin = time.process_time()
bpy.ops.render.render(write_still=True)
print(f"CYCLES_CPU {time.process_time() - begin:.3f}")
