"""The contact model that a person chose in a scene, brought to the hand."""

from __future__ import annotations

from dataclasses import asdict

import bpy
from proxygraph import SessionError

from .live import ModelChoice, Touch, live

SUB_STEPS = {"OFF": None, "CELL": 1.0, "QUARTER": 0.25}
"""Cells that the goal moves at a time, by the setting's items."""

WALK, SPHERE = "surface_walk", "virtual_proxy"
"""The models that have a knob: sub-steps, and a radius."""


def chosen_model(scene: bpy.types.Scene) -> ModelChoice:
    """Read the scene's settings; a knob that the model does not have is left out."""
    settings = scene.haptic_terrain
    return ModelChoice(
        model=settings.contact_model,
        sub_step=SUB_STEPS[settings.sub_step] if settings.contact_model == WALK else None,
        radius=settings.radius / 1000.0 if settings.contact_model == SPHERE else None,  # it has millimetres
    )


def keep_model(touch: Touch, scene: bpy.types.Scene) -> None:
    """Switch to the model that is chosen now; where that fails, the panel says why."""
    chosen = chosen_model(scene)
    if chosen == touch.model:
        return
    try:
        touch.session.set_model(**asdict(chosen))
    except (ValueError, SessionError) as error:
        live.message = f"The contact model cannot be changed: {error}"
        return
    touch.model = chosen
    live.message = ""
