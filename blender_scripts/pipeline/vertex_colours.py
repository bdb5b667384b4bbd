"""Colours of materials on the vertices: Workbench, which is quick, shows those and no nodes."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

NAME = "shown"
"""Of the colour attribute."""

STEPS = 1024
"""In which a ramp is read."""


def show_ramps(things: Any) -> None:
    """Put the colours of materials with a ramp over a vertex attribute onto meshes; others get their own.

    Args:
        things: objects.
    """
    for thing in things:
        if thing.type != "MESH" or not thing.data.materials or thing.data.materials[0] is None:
            continue
        mesh, material = thing.data, thing.data.materials[0]
        colours = _ramp_colours(mesh, material)
        if colours is None:
            colours = np.tile(np.array(material.diffuse_color[:]), (len(mesh.vertices), 1))
        old = mesh.color_attributes.get(NAME)
        shown = old or mesh.color_attributes.new(NAME, "FLOAT_COLOR", "POINT")
        shown.data.foreach_set("color", colours.astype(np.float32).ravel())
        mesh.color_attributes.active_color = shown


def _ramp_colours(mesh: bpy.types.Mesh, material: bpy.types.Material) -> Any:
    """A colour for each vertex, n x 4; ``None`` where no attribute of the mesh is coloured."""
    for ramp in material.node_tree.nodes if material.node_tree is not None else ():
        share = _before(ramp, 0, "MAP_RANGE") if ramp.type == "VALTORGB" else None
        source = _before(share, 0, "ATTRIBUTE") if share is not None else None
        attribute = mesh.attributes.get(source.attribute_name) if source is not None else None
        if attribute is None or attribute.domain != "POINT" or attribute.data_type != "FLOAT":
            continue
        values = np.empty(len(mesh.vertices), np.float32)
        attribute.data.foreach_get("value", values)
        low, high = (share.inputs[name].default_value for name in ("From Min", "From Max"))
        table = np.array([ramp.color_ramp.evaluate(step / (STEPS - 1))[:] for step in range(STEPS)])
        shares = np.clip((np.nan_to_num(values) - low) / (high - low), 0.0, 1.0)
        return table[np.rint(shares * (STEPS - 1)).astype(int)]
    return None


def _before(node: Any, number: int, wanted: str) -> Any:
    """The node that feeds an input, where it is of the wanted kind."""
    links = node.inputs[number].links
    return links[0].from_node if links and links[0].from_node.type == wanted else None
