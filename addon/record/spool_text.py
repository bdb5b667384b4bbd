"""The text in a take's file that says what the take was felt on; without Blender."""

from __future__ import annotations

import json
from typing import Any

from .about_properties import about_from, about_properties
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
    told: Any = json.loads(text)
    if not isinstance(told, dict):
        raise ValueError("it is no JSON object")
    try:
        return about_from(told), int(told[START_FRAME])
    except KeyError as error:
        raise ValueError(f"{error} is missing") from error
    except (TypeError, OverflowError) as error:
        raise ValueError(str(error)) from error
