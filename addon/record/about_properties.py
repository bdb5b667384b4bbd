"""What a take was felt on, as texts and numbers, and back; and whether two takes were felt on the same."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from ..formats.georeference_properties import finite, georeference_from, georeference_properties
from .take_data import TakeAbout


class OtherTerrainError(ValueError):
    """A take was felt on another terrain than the one it is wanted on; the text names both."""


def about_properties(about: TakeAbout) -> dict[str, Any]:
    """Write down what JSON can keep."""
    return {
        **asdict(about),
        "models": list(about.models),
        "georeference": georeference_properties(about.georeference),
    }


def read_about(text: str) -> tuple[TakeAbout, dict[str, Any]]:
    """Make it again from JSON, with whatever else the text tells.

    Raises:
        ValueError: the text was changed, or is something else; it says what is wrong.
    """
    try:
        told = json.loads(text)
        if not isinstance(told, dict):
            raise TypeError("it is no object")
        return _about(told), told
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError) as error:
        raise ValueError(f"{type(error).__name__}: {error}") from error


def _about(kept: Mapping[str, Any]) -> TakeAbout:
    rows, columns = _count(kept["rows"], 2), _count(kept["columns"], 2)
    return TakeAbout(
        terrain=_text(kept["terrain"]),
        source=_text(kept["source"]),
        rows=rows,
        columns=columns,
        cell_width=_above_zero(kept["cell_width"]),
        cell_height=_above_zero(kept["cell_height"]),
        wraps=bool(kept["wraps"]),
        georeference=georeference_from(kept["georeference"]),
        workspace_width=_above_zero(kept["workspace_width"]),
        models=tuple(map(_text, kept["models"])),
        rate=_above_zero(kept["rate"]),
        lost_ticks=_count(kept["lost_ticks"], 0),
        digest=_text(kept["digest"]),
    )


def check_same_terrain(about: TakeAbout, terrain: TakeAbout) -> None:
    """Refuse a take of another grid: another size, another place on its body, or other samples.

    Raises:
        OtherTerrainError: naming both.
    """
    same_samples = not (about.digest and terrain.digest) or about.digest == terrain.digest
    same_grid = (about.rows, about.columns, about.wraps) == (terrain.rows, terrain.columns, terrain.wraps)
    same_cells = all(
        math.isclose(one, other, rel_tol=1e-9)
        for one, other in (
            (about.cell_width, terrain.cell_width),
            (about.cell_height, terrain.cell_height),
        )
    )
    if same_samples and same_grid and same_cells and about.georeference == terrain.georeference:
        return
    raise OtherTerrainError(
        f"The take was felt on another terrain: on {_described(about)}, not on {_described(terrain)}. "
        "Import the grid that it was felt on, and select it."
    )


def _described(about: TakeAbout) -> str:
    body = f" of {about.georeference.body}" if about.georeference.body else ""
    return f"{about.terrain} ({about.source}, {about.columns:,} x {about.rows:,} samples{body})"


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{value!r} is not a text")
    return value


def _count(value: Any, least: int) -> int:
    number = int(value)
    if number != value or number < least:
        raise ValueError(f"{value!r} is not a whole number from {least} on")
    return number


def _above_zero(value: Any) -> float:
    number = finite(value)
    if number <= 0.0:
        raise ValueError(f"{number} is not above 0")
    return number
