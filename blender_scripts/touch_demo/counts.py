"""Counting what happened in some updates of a session."""

from __future__ import annotations

from dataclasses import dataclass, fields

from proxygraph import Statistics


@dataclass
class Counts:
    """What happened in some updates; each is named as in ``Statistics``."""

    ticks: int = 0
    contact_ticks: int = 0
    goal_cells: float = 0.0
    vertices: int = 0
    faces: int = 0
    collision_tests: int = 0
    far_edge_crossings: int = 0

    @staticmethod
    def of(statistics: Statistics) -> Counts:
        """Count everything since the session was made."""
        return Counts(**{field.name: getattr(statistics, field.name) for field in fields(Counts)})

    def add(self, before: Statistics, after: Statistics) -> None:
        """Count what happened between two looks."""
        for field in fields(self):
            happened = getattr(after, field.name) - getattr(before, field.name)
            setattr(self, field.name, getattr(self, field.name) + happened)

    def per_tick(self, count: float) -> float:
        """A mean; 0 where nothing was counted."""
        return count / self.ticks if self.ticks else 0.0

    def figures(self, prefix: str) -> dict[str, float]:
        """Means and shares, by name."""
        return {
            f"{prefix}cells_per_update_mean": round(self.per_tick(self.goal_cells), 4),
            f"{prefix}in_contact_share": round(self.per_tick(self.contact_ticks), 4),
            f"{prefix}updates_vertices_mean": round(self.per_tick(self.vertices), 4),
            f"{prefix}updates_faces_mean": round(self.per_tick(self.faces), 4),
            f"{prefix}updates_collision_tests_mean": round(self.per_tick(self.collision_tests), 4),
            f"{prefix}updates_far_edges_mean": round(self.per_tick(self.far_edge_crossings), 6),
        }
