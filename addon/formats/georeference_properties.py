"""A georeference as texts and numbers, and back."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, fields
from typing import Any, TypeVar

from .body.ellipsoid import Ellipsoid
from .georeference import Georeference
from .projections import KINDS

Kept = TypeVar("Kept")

KIND = "name"
"""Of the projection, beside its parameters."""


def georeference_properties(georeference: Georeference) -> dict[str, Any]:
    """Write a georeference down."""
    properties = asdict(georeference)
    properties["projection"] = {KIND: georeference.projection.name, **properties["projection"]}
    return properties


def georeference_from(kept: Mapping[str, Any]) -> Georeference:
    """Make the georeference again.

    Raises:
        KeyError, TypeError, ValueError: what was kept was changed.
    """
    projection = dict(kept["projection"])
    return restored(
        Georeference,
        {
            **kept,
            "ellipsoid": restored(Ellipsoid, kept["ellipsoid"]),
            "projection": restored(KINDS[projection.pop(KIND)], projection),
        },
    )


def restored(kind: type[Kept], kept: Mapping[str, Any]) -> Kept:
    """Make a dataclass of numbers and texts again; every number must be finite."""
    names = {field.name: str(field.type).startswith("float") for field in fields(kind)}  # type: ignore[arg-type]
    return kind(
        **{
            name: finite(kept[name]) if is_number and kept[name] is not None else kept[name]
            for name, is_number in names.items()
        }
    )


def finite(value: Any) -> float:
    """Make a finite number."""
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{number} is not a finite number")
    return number
