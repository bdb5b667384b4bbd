"""Materials that colour by a number on the vertices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np

Colour = tuple[float, float, float]

HYPSOMETRIC: tuple[tuple[float, Colour], ...] = (
    (0.0, (0.050, 0.024, 0.020)),
    (0.25, (0.19, 0.055, 0.026)),
    (0.5, (0.47, 0.155, 0.060)),
    (0.75, (0.72, 0.34, 0.14)),
    (0.92, (0.87, 0.60, 0.35)),
    (1.0, (0.96, 0.86, 0.72)),
)
"""(share of the range, linear colour): basalt, rust, dust and pale heights."""


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
    material = bpy.data.materials.new(name)
    if material.node_tree is None:  # older than 5.0
        material.use_nodes = True
    material.diffuse_color = (*ramp.colours[len(ramp.colours) // 2][1], 1.0)  # type: ignore[assignment]
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    attribute = nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = ramp.attribute
    share = nodes.new("ShaderNodeMapRange")
    share.inputs["From Min"].default_value = ramp.low
    share.inputs["From Max"].default_value = _above(ramp.low, ramp.high)
    colours = nodes.new("ShaderNodeValToRGB")
    _set_colours(colours.color_ramp, ramp.colours)
    surface = nodes.new("ShaderNodeBsdfPrincipled")
    surface.inputs["Roughness"].default_value = 0.9
    surface.inputs["Emission Strength"].default_value = ramp.glow
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(attribute.outputs["Fac"], share.inputs["Value"])
    links.new(share.outputs["Result"], colours.inputs["Fac"])
    links.new(colours.outputs["Color"], surface.inputs["Base Color"])
    if ramp.glow > 0.0:
        links.new(colours.outputs["Color"], surface.inputs["Emission Color"])
    links.new(surface.outputs["BSDF"], output.inputs["Surface"])
    for number, node in enumerate((attribute, share, colours, surface, output)):
        node.location = (number * 260.0, 0.0)
    return material


def _above(low: float, high: float) -> float:
    """Give ``high``, or on a flat grid the next number above ``low`` that Blender's 32 bits tell apart."""
    return max(high, float(np.nextafter(np.float32(low), np.float32(np.inf))))


def _set_colours(ramp: bpy.types.ColorRamp, colours: Sequence[tuple[float, Colour]]) -> None:
    while len(ramp.elements) < len(colours):
        ramp.elements.new(1.0)
    for element, (share, colour) in zip(ramp.elements, colours, strict=True):
        element.position = share
        element.color = (*colour, 1.0)  # type: ignore[assignment]
