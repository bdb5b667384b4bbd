"""Hints in the status bar of every workspace, beside reports and running jobs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def status_bar(*hints: str) -> Callable[[Any, Any], None]:
    """What ``WorkSpace.status_text_set`` takes; a text would stay in the one workspace that has it."""

    def draw(header: Any, _context: Any) -> None:
        layout = header.layout
        for hint in hints:
            layout.label(text=hint)
        layout.separator_spacer()
        layout.template_reports_banner()
        layout.template_running_jobs()

    return draw
