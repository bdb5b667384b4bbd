"""Figures beside what they should be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

Figures = dict[str, float | int | str]


@dataclass(frozen=True)
class Goal:
    """A figure that counts."""

    key: str
    bound: float | None = None
    """``None``: told only."""
    at_least: bool = False
    """Whether the figure must not be smaller than the bound; else it must not be larger."""

    def is_met(self, figure: float) -> bool:
        """Whether a figure keeps to the bound."""
        if self.bound is None:
            return True
        return figure >= self.bound if self.at_least else figure <= self.bound

    def row(self, figures: Figures) -> str:
        """A line of the table."""
        figure = float(figures[self.key])
        if self.bound is None:
            return f"{self.key:42} {figure:12.4g}"
        sign = ">=" if self.at_least else "<="
        met = "met" if self.is_met(figure) else "NOT MET"
        return f"{self.key:42} {figure:12.4g}   {sign} {self.bound:<10.6g} {met}"


def print_goals(title: str, goals: Sequence[Goal], figures: Figures) -> None:
    """Print a table of figures and bounds.

    Raises:
        KeyError: a figure was not measured.
    """
    print(title)
    for goal in goals:
        print(goal.row(figures))
