"""How often the proxy graph does what the paper says, judged from outside."""

from __future__ import annotations

from dataclasses import dataclass

from proxygraph import ContactModel

from tests.bench.grounds import Ground
from tests.bench.hand import wander
from tests.bench.oracle import ROUNDING, Vector

SPEEDS = (0.01, 0.3, 1.0, 3.4, 13.4, 50.0)
"""Cells per update; the slowest only because the paper's section 3.4 fails where the hand is slow."""

UPDATES = 60_000


@dataclass
class Quality:
    """Counts over one path. What the model says of itself, and minima, are counted in contact only."""

    updates: int = 0
    in_contact: int = 0
    vertices: int = 0
    collision_tests: int = 0
    with_far_edge: int = 0
    far_edges: int = 0
    far_edge_loops: int = 0
    cycles_ended: int = 0
    unfinished: int = 0
    not_minimal: int = 0
    grew: int = 0
    under_surface: int = 0

    def figures(self) -> dict[str, float]:
        """Shares and means, by name."""
        touched = max(self.in_contact, 1)
        return {
            "in_contact_share": self.in_contact / self.updates,
            "vertices_mean": self.vertices / touched,
            "collision_tests_mean": self.collision_tests / touched,
            "far_edge_updates_share": self.with_far_edge / touched,
            "far_edge_crossings_per_update": self.far_edges / touched,
            "far_edge_loops_per_crossing": self.far_edge_loops / max(self.far_edges, 1),
            "cycles_ended_per_update": self.cycles_ended / touched,
            "unfinished_updates": self.unfinished,
            "not_minimal_share": self.not_minimal / touched,
            "grew_faster_than_goal_share": self.grew / touched,
            "under_surface_updates": self.under_surface,
        }


def measure(ground: Ground, exaggeration: float, speed: float) -> Quality:
    """Wander once and judge every update."""
    cell = ground.grid.layout.cell_width
    row = ground.grid.layout.cell_height
    oracle = ground.oracle(exaggeration)
    model = ContactModel(ground.grid, "proxy_graph", scale=1.0 / cell, exaggeration=exaggeration)
    up = cell / exaggeration
    quality = Quality()
    before: tuple[Vector, float] | None = None
    for goal in wander(ground.field, oracle.height, speed, UPDATES, seed=int(100 * speed)):
        columns, rows, height = goal
        if before is None:
            model.place(columns * cell, -rows * row, (height + 100.0) * up)
        contact = model.update(columns * cell, -rows * row, height * up)
        east, north, proxy_up = contact.proxy
        proxy = (east / cell, -north / row, proxy_up / up)

        quality.updates += 1
        distance = oracle.distance(proxy, goal)
        rounding = ROUNDING * (1.0 + distance)
        quality.under_surface += oracle.depth(proxy) > ROUNDING * (1.0 + oracle.relief(proxy))
        if before is not None:
            moved = oracle.distance(before[0], goal)
            quality.grew += distance > before[1] + moved + rounding
        before = goal, distance
        if not contact.in_contact:
            continue
        quality.in_contact += 1
        quality.vertices += contact.vertices
        quality.collision_tests += contact.collision_tests
        quality.with_far_edge += contact.far_edge_crossings > 0
        quality.far_edges += contact.far_edge_crossings
        quality.far_edge_loops += contact.far_edge_loops
        quality.cycles_ended += contact.cycles_ended
        quality.unfinished += contact.steps_left > 0
        quality.not_minimal += not oracle.is_minimum(proxy, goal)
    return quality
