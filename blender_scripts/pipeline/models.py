"""Contact models by name."""

from __future__ import annotations

from proxygraph import MODELS

from pipeline.command import RefusedError


def known_model(name: str) -> str:
    """Give a model's name.

    Raises:
        RefusedError: there is none of that name.
    """
    if name not in MODELS:
        raise RefusedError(f"There is no contact model {name}; expected one of {', '.join(MODELS)}.")
    return name
