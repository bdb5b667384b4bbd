"""The material of a terrain: colours by elevation or by slope, and a colour for what was filled."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import bpy

from .material import Ramp, add_ramp, add_surface, colours_name, new_material, range_name
from .mesh import ELEVATION, FILLED, SLOPE
from .palettes import FILLED as FILLED_COLOUR

BY_SLOPE, FILLED_NODE = "by slope", "filled colour"
"""Names of the nodes that choose between elevation and slope, and that show what was filled."""


class ColourBy(StrEnum):
    """What the colours tell."""

    ELEVATION = "ELEVATION"
    SLOPE = "SLOPE"


@dataclass(frozen=True)
class Swatch:
    """A line of the legend."""

    element: bpy.types.ColorRampElement
    value: float
    """Metres or degrees at which the terrain has exactly this colour."""


def terrain_material(name: str, heights: Ramp, slopes: Ramp, *, filled: bool) -> bpy.types.Material:
    """Make the material, coloured by elevation.

    Args:
        filled: whether the mesh has heights that were filled in.
    """
    material, tree = new_material(name, heights)
    by_elevation = add_ramp(tree, heights)
    by_slope = add_ramp(tree, slopes, row=1)
    colour = _mixed(tree, BY_SLOPE, by_elevation, column=3)
    tree.links.new(by_slope, _input(tree.nodes[BY_SLOPE], "B_Color"))
    if filled:
        colour = _mixed(tree, FILLED_NODE, colour, column=4)
        mix = tree.nodes[FILLED_NODE]
        _input(mix, "B_Color").default_value = (*FILLED_COLOUR, 1.0)
        attribute = tree.nodes.new("ShaderNodeAttribute")
        attribute.attribute_name = FILLED
        attribute.location = (3 * 260.0, -480.0)
        tree.links.new(attribute.outputs["Fac"], _input(mix, "Factor_Float"))
    add_surface(tree, colour)
    return material


def material_of(terrain: bpy.types.Object) -> bpy.types.Material | None:
    """Find the material that was made for a terrain; a person may have put another in its place."""
    for material in terrain.data.materials:
        if material is not None and material.node_tree is not None and BY_SLOPE in material.node_tree.nodes:
            return material
    return None


def colour_by(material: bpy.types.Material) -> ColourBy:
    """What the colours tell now."""
    share = _input(material.node_tree.nodes[BY_SLOPE], "Factor_Float").default_value
    return ColourBy.SLOPE if share > 0.5 else ColourBy.ELEVATION


def set_colour_by(material: bpy.types.Material, what: ColourBy) -> None:
    """Let the colours tell something else."""
    share = 1.0 if what is ColourBy.SLOPE else 0.0
    _input(material.node_tree.nodes[BY_SLOPE], "Factor_Float").default_value = share


def legend(material: bpy.types.Material) -> list[Swatch]:
    """The colours that show now and what they stand for, from high to low; empty where nodes were removed."""
    return swatches(material, colour_by(material))


def swatches(material: bpy.types.Material, what: ColourBy) -> list[Swatch]:
    """The colours of elevations or slopes and what they stand for, shown or not; as ``legend``."""
    attribute = SLOPE if what is ColourBy.SLOPE else ELEVATION
    nodes = material.node_tree.nodes
    span, colours = nodes.get(range_name(attribute)), nodes.get(colours_name(attribute))
    if span is None or colours is None:
        return []
    low, high = (span.inputs[end].default_value for end in ("From Min", "From Max"))
    elements = list(colours.color_ramp.elements)
    return [Swatch(element, low + element.position * (high - low)) for element in reversed(elements)]


def filled_colour(material: bpy.types.Material) -> bpy.types.NodeSocket | None:
    """The socket that has the colour of what was filled; ``None`` where nothing was."""
    node = material.node_tree.nodes.get(FILLED_NODE)
    return None if node is None else _input(node, "B_Color")


def _mixed(
    tree: bpy.types.NodeTree, name: str, first: bpy.types.NodeSocket, *, column: int
) -> bpy.types.NodeSocket:
    """Add a node that mixes a colour with a second one, of which it takes nothing at first."""
    mix = tree.nodes.new("ShaderNodeMix")
    mix.name = mix.label = name
    mix.data_type = "RGBA"
    mix.location = (column * 260.0, 0.0)
    _input(mix, "Factor_Float").default_value = 0.0
    tree.links.new(first, _input(mix, "A_Color"))
    return next(socket for socket in mix.outputs if socket.identifier == "Result_Color")


def _input(node: bpy.types.Node, identifier: str) -> bpy.types.NodeSocket:
    """The Mix node has several sockets of one name; their identifiers differ."""
    return next(socket for socket in node.inputs if socket.identifier == identifier)
