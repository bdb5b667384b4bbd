"""The error that people see when touch cannot start."""

from __future__ import annotations


class TouchError(RuntimeError):
    """Touch cannot start; the text says what to do."""
