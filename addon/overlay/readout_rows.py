"""What the overlay says about the newest tick; without drawing."""

from __future__ import annotations

from dataclasses import dataclass

from ..touch.live import Readout, Touch
from ..touch.place_words import place_lines
from ..touch.state_words import HELD, MODES


@dataclass(frozen=True)
class Row:
    """A name and a value."""

    name: str
    value: str
    is_warning: bool = False


def title(readout: Readout) -> str:
    """What the hand's motion does."""
    if readout.mode == "normal":
        return "Normal: touching" if readout.in_contact else "Normal: free"
    return MODES[readout.mode]


def readout_rows(touch: Touch, readout: Readout) -> list[Row]:
    """Where the hand is, what it feels, and how device and servo are."""
    in_degrees = touch.georeference.projection.in_degrees
    beside = [("Place", "Beside the map")]
    place = (
        place_lines(readout, readout.window.exaggeration, in_degrees=in_degrees) if readout.on_map else beside
    )
    return [
        *(Row(name, value) for name, value in place),
        Row("Force", f"{readout.force:.2f} N"),
        Row("Servo", f"{readout.load:.1%} of each ms"),
        Row("Device", "Simulated hand" if touch.is_simulated else "Scripted hand"),
        *([Row("Held back", HELD[readout.held], is_warning=True)] if readout.held is not None else []),
    ]
