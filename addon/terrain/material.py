"""Materials that colour by a number on the vertices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import bpy
import numpy as np

from .palettes import Colour


@dataclass(frozen=True)
class Ramp:
    """How a vertex attribute becomes a colour."""

    attribute: str
    low: float
    high: float
    """Values of the attribute at both ends of the ramp."""
    colours: Sequence[tuple[float, Colour]]
    glow: float = 0.0
    """Emission strength; 0 for things that only reflect."""


def ramp_material(name: str, ramp: Ramp) -> bpy.types.Material:
    """Make a material whose colours a person can change in its ramp."""
    material, tree = new_material(name, ramp)
    add_surface(tree, add_ramp(tree, ramp), glow=ramp.glow)
    return material


def new_material(name: str, ramp: Ramp) -> tuple[bpy.types.Material, bpy.types.NodeTree]:
    """Make a material without nodes; where nodes are not shown, it has the middle colour of the ramp."""
    material = bpy.data.materials.new(name)
    if material.node_tree is None:  # older than 5.0
        material.use_nodes = True
    material.diffuse_color = (*ramp.colours[len(ramp.colours) // 2][1], 1.0)  # type: ignore[assignment]
    tree = cast("bpy.types.NodeTree", material.node_tree)
    tree.nodes.clear()
    return material, tree


def add_ramp(tree: bpy.types.NodeTree, ramp: Ramp, *, row: int = 0) -> bpy.types.NodeSocket:
    """Add the nodes from a vertex attribute to a colour; their labels begin with the attribute's name.

    Args:
        row: how many such chains are above it in the editor.
    """
    nodes, links = tree.nodes, tree.links
    attribute = nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = ramp.attribute
    share = nodes.new("ShaderNodeMapRange")
    share.name = range_name(ramp.attribute)
    share.inputs["From Min"].default_value = ramp.low
    share.inputs["From Max"].default_value = _above(ramp.low, ramp.high)
    colours = nodes.new("ShaderNodeValToRGB")
    colours.name = colours_name(ramp.attribute)
    _set_colours(colours.color_ramp, ramp.colours)
    links.new(attribute.outputs["Fac"], share.inputs["Value"])
    links.new(share.outputs["Result"], colours.inputs["Fac"])
    for number, node in enumerate((attribute, share, colours)):
        node.location = (number * 260.0, row * -320.0)
    return colours.outputs["Color"]


def add_surface(tree: bpy.types.NodeTree, colour: bpy.types.NodeSocket, *, glow: float = 0.0) -> None:
    """Add a rough surface of a colour.

    Args:
        glow: emission strength.
    """
    nodes, links = tree.nodes, tree.links
    surface = nodes.new("ShaderNodeBsdfPrincipled")
    surface.inputs["Roughness"].default_value = 0.9
    surface.inputs["Emission Strength"].default_value = glow
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(colour, surface.inputs["Base Color"])
    if glow > 0.0:
        links.new(colour, surface.inputs["Emission Color"])
    links.new(surface.outputs["BSDF"], output.inputs["Surface"])
    for number, node in enumerate((surface, output)):
        node.location = ((number + 5) * 260.0, 0.0)


def range_name(attribute: str) -> str:
    """Of the node that has the values at both ends of an attribute's colours."""
    return f"{attribute} range"


def colours_name(attribute: str) -> str:
    """Of the node that has an attribute's colours."""
    return f"{attribute} colours"


def _above(low: float, high: float) -> float:
    """Give ``high``, or on a flat grid the next number above ``low`` that Blender's 32 bits tell apart."""
    return max(high, float(np.nextafter(np.float32(low), np.float32(np.inf))))


def _set_colours(ramp: bpy.types.ColorRamp, colours: Sequence[tuple[float, Colour]]) -> None:
    while len(ramp.elements) < len(colours):
        ramp.elements.new(1.0)
    for element, (share, colour) in zip(ramp.elements, colours, strict=True):
        element.position = share
        element.color = (*colour, 1.0)  # type: ignore[assignment]
