"""What the status bar shows."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any


def said(draw: Any) -> str:
    """Draw what ``WorkSpace.status_text_set`` was given, and read it."""
    drawn: list[str] = []
    layout = SimpleNamespace(
        label=lambda *, text: drawn.append(text),
        separator_spacer=lambda: None,
        template_reports_banner=lambda: None,
        template_running_jobs=lambda: None,
    )
    draw(SimpleNamespace(layout=layout), None)
    return " | ".join(drawn)
