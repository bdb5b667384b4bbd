"""What the panels and the import dialog say, drawn into a layout that only takes notes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough


class Notes:
    """Stands in for a layout, its rows, columns and boxes."""

    def __init__(self) -> None:
        self.labels: list[str] = []
        self.operators: list[str] = []
        self.properties: list[str] = []

    def label(self, *, text: str, icon: str = "NONE") -> None:
        """Note a text."""
        self.labels.append(text)

    def operator(self, name: str, *, icon: str = "NONE", text: str = "") -> SimpleNamespace:
        """Note a button."""
        self.operators.append(name)
        return SimpleNamespace()

    def prop(self, owner: Any, name: str, *, text: str = "") -> None:
        """Note a property, which must exist."""
        assert hasattr(owner, name)
        self.properties.append(name)

    def column(self, *, align: bool = False) -> Notes:
        """Go on with the same notes."""
        return self

    def split(self, *, factor: float) -> Notes:
        """Go on with the same notes."""
        return self

    def box(self) -> Notes:
        """Go on with the same notes."""
        return self


def drawn(panel: str) -> Notes:
    """Draw one panel."""
    notes = Notes()
    getattr(module("ui.panel"), panel).draw(SimpleNamespace(layout=notes), bpy.context)
    return notes


@pytest.fixture
def label(tmp_path: Path) -> Path:
    return MegdrPair(rough(40, 60)).write(tmp_path)


def dialog_of(notes: Notes, *paths: Path, **choices: Any) -> SimpleNamespace:
    """Stand in for the import operator."""
    defaults = {"vertex_budget": 250_000, "scale": "FIT", "exaggeration": 0.0, "region": "WHOLE"}
    defaults |= {"fill_voids": False, "placed": False}
    files = [SimpleNamespace(name=path.name) for path in paths]
    where = {"filepath": str(paths[0]), "directory": str(paths[0].parent), "files": files}
    return SimpleNamespace(layout=notes, **where, **(defaults | choices))


def test_without_terrain_the_panel_offers_to_import() -> None:
    assert drawn("HAPTIC_TERRAIN_PT_terrain").operators == ["haptic_terrain.import_grid"]
    assert drawn("HAPTIC_TERRAIN_PT_touch").operators == ["haptic_terrain.touch_start"]


def test_the_panel_describes_the_terrain(label: Path) -> None:
    import_grid(label)
    text = " ".join(drawn("HAPTIC_TERRAIN_PT_terrain").labels)
    for word in ("Mars grid", "60 x 40 samples", "2,400 vertices", "-2,000 to 2,000 m", "heights x50"):
        assert word in text


def test_the_panel_shows_the_newest_tick(label: Path) -> None:
    import_grid(label)
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    touch.session.step(1000)
    module("touch.tick").tick()
    notes = drawn("HAPTIC_TERRAIN_PT_touch")
    assert notes.operators == ["haptic_terrain.touch_stop"]
    for word in ("Normal", "Touching", "Longitude", "Latitude", "Elevation", "Force", "Missed ticks"):
        assert word in notes.labels


def test_the_panel_says_what_holds_the_force_back(label: Path) -> None:
    import_grid(label)
    panel = module("ui.panel").HAPTIC_TERRAIN_PT_safety
    assert not panel.poll(bpy.context)
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    assert panel.poll(bpy.context)
    assert drawn("HAPTIC_TERRAIN_PT_safety").labels[0].startswith("Nothing held")
    assert "Held back" not in drawn("HAPTIC_TERRAIN_PT_touch").labels
    told = "The force was taken away 3 times because the computer was too busy to keep time."
    touch.readout = replace(touch.readout, held="late", warnings=(told,))
    assert " ".join(drawn("HAPTIC_TERRAIN_PT_safety").labels) == told
    labels = drawn("HAPTIC_TERRAIN_PT_touch").labels
    assert labels[labels.index("Held back") + 1] == "Ticks were missed"


def test_every_reason_has_words(label: Path) -> None:
    assert set(module("ui.panel").HELD) == {"host", "late", "speed", "device", "not_finite"}


def test_the_panel_says_why_touch_ended(label: Path) -> None:
    terrain = import_grid(label)
    bpy.ops.haptic_terrain.touch_start()
    bpy.data.objects.remove(terrain)
    module("touch.tick").tick()
    assert "terrain is gone" in " ".join(drawn("HAPTIC_TERRAIN_PT_touch").labels)


def test_the_panel_misses_a_deleted_target(label: Path) -> None:
    import_grid(label)
    bpy.ops.haptic_terrain.touch_start()
    bpy.data.objects.remove(bpy.data.objects["Touch Target"])
    assert "Touch Target is gone" in " ".join(drawn("HAPTIC_TERRAIN_PT_touch").labels)


def test_the_panel_starts_and_stops_takes(label: Path) -> None:
    import_grid(label)
    assert drawn("HAPTIC_TERRAIN_PT_record").operators == ["haptic_terrain.record_start"]
    bpy.ops.haptic_terrain.touch_start()
    bpy.ops.haptic_terrain.record_start()
    assert drawn("HAPTIC_TERRAIN_PT_record").operators == ["haptic_terrain.record_stop"]


def test_the_import_dialog_counts_before_anything_is_imported(label: Path) -> None:
    notes = Notes()
    dialog = dialog_of(notes, label)
    module("ui.import_operator").HAPTIC_TERRAIN_OT_import_grid.draw(dialog, bpy.context)
    assert notes.properties == ["vertex_budget", "scale", "exaggeration", "region"]
    assert "2,400 vertices to see" in notes.labels
    assert len(bpy.data.objects) == 0
