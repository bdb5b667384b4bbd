"""Contact models by name."""

from __future__ import annotations

from proxygraph import MODELS

from pipeline.command import RefusedError


def known_models(names: str | None) -> tuple[str, ...]:
    """Read names with commas between them; all models where there are none.

    Raises:
        RefusedError: a name is not known, or there twice.
    """
    if names is None:
        return MODELS
    chosen = tuple(known_model(name.strip()) for name in names.split(","))
    if len(set(chosen)) < len(chosen):
        raise RefusedError(f"{names}: name each contact model once.")
    return chosen


def known_model(name: str) -> str:
    """Give a model's name.

    Raises:
        RefusedError: there is none of that name.
    """
    if name not in MODELS:
        raise RefusedError(f"There is no contact model {name}; expected one of {', '.join(MODELS)}.")
    return name
