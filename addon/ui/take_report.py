"""What an operator tells of a take that it wrote."""

from __future__ import annotations

from typing import Any

from ..record.write_take import Take


def report_take(operator: Any, take: Take) -> None:
    """Tell what was written, and what is missing in it."""
    operator.report(
        {"INFO"}, f"{take.take.name}: {take.seconds:.1f} s, {take.keyframes:,} keys on each curve"
    )
    if take.dropped:
        operator.report(
            {"WARNING"},
            f"{take.dropped:,} ticks were lost while the computer was busy: the take holds still there",
        )
    if take.cut_seconds:
        operator.report(
            {"WARNING"},
            f"The last {take.cut_seconds:.1f} s lie beyond Blender's last frame and have no keys: "
            "start from an earlier frame",
        )
    if take.left_out:
        operator.report(
            {"WARNING"},
            f"Only one of the two takes has {', '.join(take.left_out)}: together they keep no such column",
        )
