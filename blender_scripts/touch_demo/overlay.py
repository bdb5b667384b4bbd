"""Words and a colour scale in the picture, fixed before the camera."""

from __future__ import annotations

import bpy

BEFORE_CAMERA = 0.2
"""Of the distance to what the picture shows: nearer than any terrain."""

TEXT = (1.0, 0.96, 0.90)


def add_caption(scene: bpy.types.Scene, camera: bpy.types.Object, text: str) -> None:
    """Write along the lower left edge."""
    _write(scene, camera, "Caption", text, -0.475, -0.258)


def add_legend(
    scene: bpy.types.Scene, camera: bpy.types.Object, trail: bpy.types.Object, strongest: float
) -> None:
    """Show which colour of the trail is which force, at the lower right edge.

    Args:
        trail: its material colours by the vertex attribute "force".
        strongest: newtons at the scale's upper end.
    """
    left, right, bottom, top = 0.29, 0.42, -0.2565, -0.2465
    corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
    scale = _scale(camera)
    mesh = bpy.data.meshes.new("Force scale")
    mesh.from_pydata([(x * scale, y * scale, 0.0) for x, y in corners], [], [(0, 1, 2, 3)])
    force = mesh.attributes.new("force", "FLOAT", "POINT")
    force.data.foreach_set("value", [0.0, strongest, strongest, 0.0])
    mesh.materials.append(trail.data.materials[0])
    _before(scene, camera, bpy.data.objects.new("Force scale", mesh), 0.0, 0.0)
    _write(scene, camera, "Force least", "0", 0.272, -0.258)
    _write(scene, camera, "Force most", f"{strongest:.1f} N", 0.428, -0.258)


def _write(
    scene: bpy.types.Scene, camera: bpy.types.Object, name: str, text: str, x: float, y: float
) -> None:
    words = bpy.data.curves.new(name, "FONT")
    words.body = text
    words.size = 0.02 * _scale(camera)
    words.materials.append(_glowing(name))
    _before(scene, camera, bpy.data.objects.new(name, words), x, y)


def _scale(camera: bpy.types.Object) -> float:
    """The picture's width there, Blender units: positions are shares of it."""
    return _distance(camera) * float(camera.data.sensor_width / camera.data.lens)


def _distance(camera: bpy.types.Object) -> float:
    """Blender units from the camera."""
    return BEFORE_CAMERA * float(camera.data.dof.focus_distance)


def _before(
    scene: bpy.types.Scene, camera: bpy.types.Object, thing: bpy.types.Object, x: float, y: float
) -> None:
    """Fix an object before the camera, out of the light's way."""
    scale = _scale(camera)
    thing.parent = camera
    thing.location = (x * scale, y * scale, -_distance(camera))
    thing.visible_shadow = thing.visible_diffuse = thing.visible_glossy = False
    thing.hide_select = True
    scene.collection.objects.link(thing)


def _glowing(name: str) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    if material.node_tree is None:  # older than 5.0
        material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    light = nodes.new("ShaderNodeEmission")
    light.inputs["Color"].default_value = (*TEXT, 1.0)
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(light.outputs["Emission"], output.inputs["Surface"])
    return material
