"""What a hand does, and what keeps it from it, in words."""

from __future__ import annotations

HELD = {
    "host": "Blender was busy",
    "late": "Ticks were missed",
    "speed": "Hand was too fast",
    "device": "Device failed",
    "not_finite": "Not a number",
    "finished": "Playback has ended",
    "below": "Hand is under the ground",
}
"""Why the force is away, short enough for a line; the panel *Safety* has the sentences."""

MODES = {"normal": "Normal", "pan": "Pan: ground held", "zoom": "Zoom: air held"}
"""What the hand's motion does."""
