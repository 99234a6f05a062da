"""Renders the made groom in Cycles, and writes a groom for the same picture by `lancret preview`:

    blender -b --factory-startup --python python/blender/cycles_picture.py -- out/cycles
    build/release/tools/lancret preview out/cycles/ours.toml -o out/cycles/ours.png
    blender -b --factory-startup --python python/blender/cycles_picture.py -- out/cycles join

The last command joins both into out/cycles/cycles.png, with Cycles at the left.
"""

import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Vector

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import lancret_blender  # noqa: E402

SIZE, SAMPLES, STRANDS = 480, 64, 30000
EYE, TARGET, FIELD = (28, 0, 86), (0, -9, -1), 30  # cm, y up; degrees
SUN, IRRADIANCE, RADIUS = (0.6, 0.7, 0.8), 4.0, 2.0  # direction to it; radius in degrees
SKY, BACKGROUND = 0.4, 0.18
SKIN = (0.35, 0.22, 0.16)
EUMELANIN, PHEOMELANIN, ROUGHNESS, AZIMUTHAL = 0.8, 0.2, 0.3, 0.35
# Absorption of each pigment, in 1/radius, the same as Lancret's [d'Eon et al. 2011].
OF_EUMELANIN, OF_PHEOMELANIN = (0.419, 0.697, 1.37), (0.187, 0.4, 1.05)
HEAD = (7.5, 11, 9.5)  # half axes of the made groom's head, cm

OURS = f"""
[material]
eumelanin = {EUMELANIN}
pheomelanin = {PHEOMELANIN}
roughness = {ROUGHNESS}
azimuthal_roughness = {AZIMUTHAL}
scalp_colour = {list(SKIN)}
[camera]
position = {list(EYE)}
target = {list(TARGET)}
field_of_view_degrees = {FIELD}
[light]
sky = {[SKY] * 3}
[[light.distant]]
direction = {list(SUN)}
irradiance = {[IRRADIANCE] * 3}
radius_degrees = {RADIUS}
[render]
width = {SIZE}
height = {SIZE}
samples = {SAMPLES}
regularisation = 0
lobes = "near"
background = {[BACKGROUND] * 3}
"""


def metres(point):
    """A place in the groom, in Blender's units and axes."""
    x, y, z = point
    return Vector((x, -z, y)) / 100


def shown(groom):
    """The text of an example groom with the look of this picture."""
    replaced = ("material", "camera", "light", "render", "dynamics", "motion")
    text, kept = (HERE.parent.parent / "examples" / groom).read_text(), True
    lines = []
    for line in text.splitlines():
        if line.startswith("["):
            kept = line.split("]")[0].strip("[") not in replaced
        if kept:
            lines.append(line)
    text = "\n".join(lines)
    return text.replace("count = 50000", f"count = {STRANDS}") + OURS


def nodes_of(owner, kind, output):
    if bpy.app.version < (5, 0):
        owner.use_nodes = True
    nodes = owner.node_tree.nodes
    nodes.clear()
    shader, end = nodes.new(kind), nodes.new(output)
    owner.node_tree.links.new(shader.outputs[0], end.inputs["Surface"])
    return shader


def hair_material(material):
    hair = nodes_of(material, "ShaderNodeBsdfHairPrincipled", "ShaderNodeOutputMaterial")
    hair.parametrization = "ABSORPTION"
    pigments = zip(OF_EUMELANIN, OF_PHEOMELANIN)
    hair.inputs["Absorption Coefficient"].default_value = [
        EUMELANIN * e + PHEOMELANIN * p for e, p in pigments
    ]
    hair.inputs["Roughness"].default_value = ROUGHNESS
    hair.inputs["Radial Roughness"].default_value = AZIMUTHAL
    hair.inputs["Coat"].default_value = 0
    hair.inputs["Random Roughness"].default_value = 0


def light(scene):
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = IRRADIANCE, np.radians(2 * RADIUS)
    sun.rotation_euler = metres(SUN).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("sky")
    nodes_of(scene.world, "ShaderNodeBackground", "ShaderNodeOutputWorld")
    tree = scene.world.node_tree
    sky = tree.nodes["Background"]
    sky.inputs["Color"].default_value = (1, 1, 1, 1)
    rays = tree.nodes.new("ShaderNodeLightPath")
    mixed = tree.nodes.new("ShaderNodeMapRange")  # the camera sees the background
    mixed.inputs["To Min"].default_value = SKY
    mixed.inputs["To Max"].default_value = BACKGROUND
    tree.links.new(rays.outputs["Is Camera Ray"], mixed.inputs["Value"])
    tree.links.new(mixed.outputs[0], sky.inputs["Strength"])


def head(scene):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=72, ring_count=40, radius=0.01)
    obj = bpy.context.object
    x, y, z = HEAD
    obj.data.transform(Matrix.Diagonal((x, z, y, 1)))
    skin = bpy.data.materials.new("skin")
    diffuse = nodes_of(skin, "ShaderNodeBsdfDiffuse", "ShaderNodeOutputMaterial")
    diffuse.inputs["Color"].default_value = (*SKIN, 1)
    obj.data.materials.append(skin)
    for polygon in obj.data.polygons:
        polygon.use_smooth = True


def camera(scene):
    eye = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    eye.data.angle = np.radians(FIELD)
    eye.location = metres(EYE)
    towards = metres(EYE) - metres(TARGET)
    eye.rotation_euler = towards.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(eye)
    scene.camera = eye


def render(folder):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    lancret_blender.register()
    scene = bpy.context.scene
    groom = folder / "ours.toml"
    groom.write_text(shown("made_groom.toml"))
    bpy.ops.object.lancret_add(filepath=str(groom))
    settings = bpy.context.object.lancret
    if settings.error:
        raise SystemExit(settings.error)
    print(
        f"strands {settings.all_strands}, ends within {settings.end_error:.3g} cm",
        flush=True,
    )
    hair_material(settings.material)
    head(scene)
    light(scene)
    camera(scene)
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_adaptive_sampling = SAMPLES, False
    scene.cycles.use_denoising = False
    for bounces in ("max", "diffuse", "glossy", "transmission"):
        setattr(scene.cycles, f"{bounces}_bounces", 64)
    scene.cycles.sample_clamp_indirect = 0
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = str(folder / "by_cycles.png")
    bpy.ops.render.render(write_still=True)


def join(folder):
    pictures = []
    for name in ("by_cycles.png", "ours.png"):
        picture = bpy.data.images.load(str(folder / name))
        pictures.append(np.array(picture.pixels[:]).reshape(SIZE, SIZE, 4))
    both = bpy.data.images.new("both", 2 * SIZE, SIZE)
    both.pixels.foreach_set(np.concatenate(pictures, 1).astype(np.float32).ravel())
    both.filepath_raw, both.file_format = str(folder / "cycles.png"), "PNG"
    both.save()
    for name, picture in zip(("Cycles", "ours"), pictures):
        print(name, "mean of the picture", picture[..., :3].mean(axis=(0, 1)).round(4))


FOLDER = Path(sys.argv[sys.argv.index("--") + 1]).resolve()
FOLDER.mkdir(parents=True, exist_ok=True)
(join if sys.argv[-1] == "join" else render)(FOLDER)
