"""The text in a take's file that says what the take was felt on; without Blender."""

from __future__ import annotations

import json

from .about_properties import about_properties, read_about
from .take_data import TakeAbout

START_FRAME = "start_frame"


def spool_text(about: TakeAbout, start_frame: int) -> str:
    """Write down what a take will need when it is read back.

    Args:
        start_frame: of the scene when recording was asked for.
    """
    return json.dumps({**about_properties(about), START_FRAME: start_frame})


def from_spool_text(text: str) -> tuple[TakeAbout, int]:
    """Read it again: about the take, and the frame at which recording was asked for.

    Raises:
        ValueError: it is no such text.
    """
    about, told = read_about(text)
    frame = told.get(START_FRAME)
    if not isinstance(frame, int):
        raise ValueError(f"{START_FRAME} is {frame!r}, expected a whole number")
    return about, frame
