"""What the panels and the import dialog say, drawn into a layout that only takes notes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest

from tests.addon.decoded import decode_everything
from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough


class Notes:
    """Stands in for a layout, its rows, columns and boxes."""

    def __init__(self) -> None:
        self.labels: list[str] = []
        self.operators: list[str] = []
        self.properties: list[str] = []
        self.buttons: list[SimpleNamespace] = []
        self.menus: list[str] = []

    def label(self, *, text: str, icon: str = "NONE") -> None:
        """Note a text."""
        self.labels.append(text)

    def operator(
        self, name: str, *, icon: str = "NONE", text: str = "", depress: bool = False
    ) -> SimpleNamespace:
        """Note a button."""
        self.operators.append(name)
        button = SimpleNamespace(idname=name, pressed=depress)
        self.buttons.append(button)
        return button

    def menu(self, name: str, *, text: str = "") -> None:
        """Note a menu, which must exist."""
        assert hasattr(bpy.types, name)
        self.menus.append(name)

    def row(self, *, align: bool = False) -> Notes:
        """Go on with the same notes."""
        return self

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


def drawn(panel: str, place: str = "ui.panel") -> Notes:
    """Draw one panel."""
    notes = Notes()
    getattr(module(place), panel).draw(SimpleNamespace(layout=notes), bpy.context)
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
    offered = drawn("HAPTIC_TERRAIN_PT_terrain").operators
    assert offered == ["haptic_terrain.import_grid", "haptic_terrain.download_mola"]
    starts = ["haptic_terrain.touch_start", "haptic_terrain.mouse_touch"]
    assert drawn("HAPTIC_TERRAIN_PT_touch").operators[-2:] == starts


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
    reasons = {"host", "late", "speed", "device", "not_finite", "finished", "below"}
    assert set(module("touch.state_words").HELD) == reasons


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
    assert drawn("HAPTIC_TERRAIN_PT_record").operators == [
        "haptic_terrain.record_start",
        "haptic_terrain.recover_take",
    ]
    bpy.ops.haptic_terrain.touch_start()
    bpy.ops.haptic_terrain.record_start()
    assert drawn("HAPTIC_TERRAIN_PT_record").operators == ["haptic_terrain.record_stop"]


def test_the_import_dialog_counts_before_anything_is_imported(label: Path) -> None:
    notes = Notes()
    dialog = dialog_of(notes, label)
    module("ui.import_operator").HAPTIC_TERRAIN_OT_import_grid.draw(dialog, bpy.context)
    assert notes.properties[:4] == ["vertex_budget", "scale", "exaggeration", "region"]
    assert "2,400 vertices to see" in notes.labels
    assert len(bpy.data.objects) == 0


def of_chosen(label: Path, *others: Path, **choices: Any) -> Notes:
    """Draw the import dialog for files."""
    notes = Notes()
    dialog = dialog_of(notes, label, *others, **choices)
    module("ui.import_operator").HAPTIC_TERRAIN_OT_import_grid.draw(dialog, bpy.context)
    return notes


def test_the_import_dialog_says_what_the_file_is(label: Path) -> None:
    text = " | ".join(of_chosen(label).labels)
    for words in (
        "Mars grid",
        "MOLA (PDS3)",
        "60 x 40 = 2,400 samples",
        "m | -2,000 to 2,000 m, no voids",
        "Memory: in place, nothing copied",
    ):
        assert words in text
    cell = module("formats").read_grid(label).layout.cell_width
    assert f"Cells of {cell:,.0f} x " in text


def test_the_import_dialog_says_what_filling_needs(label: Path) -> None:
    assert not any(line.startswith("Filling") for line in of_chosen(label).labels)
    filling = "Filling: a copy of 4.8 kB, 28.8 kB meanwhile"  # 2,400 samples of 2 bytes, and 12 bytes each
    assert filling in of_chosen(label, fill_voids=True).labels


def test_the_import_dialog_counts_voids_and_the_chosen_region(tmp_path: Path) -> None:
    heights = rough(40, 60)
    heights[1][1] = heights[30][30] = -32768
    label = MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path)
    assert any("2 voids" in line for line in of_chosen(label).labels)
    assert "2,400 vertices to see at the most" in of_chosen(label).labels
    assert "2,400 vertices to see" in of_chosen(label, fill_voids=True).labels
    choice = {"first_column": 0, "first_row": 0, "columns": 10, "rows": 8}
    notes = of_chosen(label, region="SAMPLES", **choice)
    assert "10 x 8 = 80 samples to touch" in notes.labels
    assert any("1 void" in line for line in notes.labels)
    assert notes.properties[4:8] == ["first_column", "first_row", "columns", "rows"]


def test_the_import_dialog_explains_a_region_that_is_not_there(label: Path) -> None:
    choice = {"west": 100.0, "east": 110.0, "south": 0.0, "north": 5.0}
    assert "region: found 100 to 110 E" in " ".join(of_chosen(label, region="DEGREES", **choice).labels)


def test_the_import_dialog_reads_a_file_once_for_all_regions(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    header, description, calls = module("terrain.prepare"), module("ui.import_description"), []
    read_grid = header.read_grid

    def read(*arguments: Any) -> Any:
        calls.append(arguments)
        return read_grid(*arguments)

    monkeypatch.setattr(header, "read_grid", read)
    description._cached_grid.cache_clear()
    for rows in range(2, 9):
        choice = {"first_column": 0, "first_row": 0, "columns": 10, "rows": rows}
        labels = of_chosen(label, region="SAMPLES", **choice).labels
        assert f"10 x {rows} = {10 * rows} samples to touch" in labels
    assert len(calls) == 1


def test_the_import_dialog_says_how_many_files_there_are(label: Path) -> None:
    assert "2 files; the first is" in of_chosen(label, label.with_suffix(".img")).labels


def test_the_import_dialog_says_what_decoding_needs(label: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    description, caching = module("ui.import_description"), module("formats.cache").cache
    decode_everything(monkeypatch)
    description._cached_grid.cache_clear()
    assert "Memory: 4.8 kB decoded" in of_chosen(label).labels
    assert "Range and voids: known when it is read" in of_chosen(label).labels
    monkeypatch.setattr(caching, "most_in_memory", 100)
    assert "Memory: 4.8 kB in a cache file" in of_chosen(label).labels
    description._cached_grid.cache_clear()


def test_the_import_dialog_knows_the_heights_of_a_grid_of_text(tmp_path: Path) -> None:
    header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n"
    some, none = tmp_path / "some.asc", tmp_path / "none.asc"
    some.write_text(f"{header}1 2 -9999 3400\n")
    none.write_text(header + "-9999 " * 4)
    assert "1 to 3,400 m, 1 void" in of_chosen(some).labels
    assert "No data in any sample" in of_chosen(none).labels
    choice = {"first_column": 0, "first_row": 0, "columns": 2, "rows": 2}
    assert "1 to 3,400 m, 1 void" in of_chosen(some, region="SAMPLES", **choice).labels


def test_the_import_dialog_shows_what_the_reader_noticed(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    description, header = module("ui.import_description"), module("terrain.prepare")
    grid = replace(module("formats").read_grid(label), notes=("The last profile is missing.",))
    monkeypatch.setattr(header, "read_grid", lambda *_arguments: grid)
    description._cached_grid.cache_clear()
    assert "The last profile is missing." in of_chosen(label).labels
    import_grid(label)
    notes = drawn("HAPTIC_TERRAIN_PT_georeference", "ui.panels.georeference")
    assert "The last profile is missing." in notes.labels
    description._cached_grid.cache_clear()


def test_the_georeference_is_stated(label: Path) -> None:
    import_grid(label)
    notes = drawn("HAPTIC_TERRAIN_PT_georeference", "ui.panels.georeference")
    for words in ("Mars", "sphere, 3,396,000 m", "longitude and latitude", "planetocentric", "areoid"):
        assert words in notes.labels
    assert notes.operators == ["haptic_terrain.go_to", "haptic_terrain.show_curvature"]
    assert notes.buttons[1].curved
    bpy.ops.haptic_terrain.show_curvature()
    button = drawn("HAPTIC_TERRAIN_PT_georeference", "ui.panels.georeference").buttons[1]
    assert (button.curved, button.pressed) == (False, True)


def test_the_colours_have_a_legend(label: Path) -> None:
    terrain = import_grid(label)
    assert module("ui.panels.colours").HAPTIC_TERRAIN_PT_colours.poll(bpy.context)
    notes = drawn("HAPTIC_TERRAIN_PT_colours", "ui.panels.colours")
    assert notes.properties == ["color"] * len(module("terrain.palettes").MARS)
    assert [line for line in notes.labels if not line.endswith(" m")] == []
    assert [button.pressed for button in notes.buttons] == [True, False]
    bpy.ops.haptic_terrain.colour_by(what="SLOPE")
    labels = drawn("HAPTIC_TERRAIN_PT_colours", "ui.panels.colours").labels
    assert labels[-1] == "0.0\N{DEGREE SIGN}"
    terrain.data.materials.clear()
    assert not module("ui.panels.colours").HAPTIC_TERRAIN_PT_colours.poll(bpy.context)


def test_the_profile_panel_shows_what_lies_between(label: Path) -> None:
    import_grid(label)
    place = "HAPTIC_TERRAIN_PT_profile", "ui.panels.profile"
    assert drawn(*place).operators == ["haptic_terrain.mark"] * 2
    for mark, longitude in (("A", 25.5), ("B", 40.5)):
        bpy.ops.haptic_terrain.go_to(longitude=longitude, latitude=5.5)
        bpy.ops.haptic_terrain.mark(which=mark)
    notes = drawn(*place)
    for words in ("Distance", "A to B", "Slope", "Up, down", "Steepest"):
        assert words in notes.labels
    assert notes.operators[2:] == ["haptic_terrain.add_profile", "haptic_terrain.export_profile"]


def test_a_projected_map_shows_its_own_metres_beside_longitude_and_latitude(label: Path) -> None:
    import_grid(label)
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    touch.session.step(500)
    module("touch.tick").tick()
    words = module("touch.place_words").place_lines
    readout = replace(touch.readout, own=(500_123.4, -1_234_567.8), coordinates=(12.5, -3.25))
    lines = dict(words(readout, 2.0, in_degrees=False))
    assert (lines["East"], lines["North"]) == ("500,123 m", "-1,234,568 m")
    assert lines["Latitude"] == "3.2500\N{DEGREE SIGN} S"
    assert "East" not in dict(words(readout, 2.0, in_degrees=True))
    assert "Longitude" not in dict(words(replace(readout, coordinates=None), 2.0, in_degrees=False))


def test_the_panel_of_takes_offers_what_there_is_to_choose(label: Path) -> None:
    import_grid(label)
    settings = bpy.context.scene.haptic_terrain
    few = drawn("HAPTIC_TERRAIN_PT_take", "ui.panels.take")
    assert few.operators == ["haptic_terrain.export_take", "haptic_terrain.import_take"]
    assert "take_bound" not in few.properties
    assert "take" not in few.properties
    settings.take_keys, settings.take_onto, settings.trail = "REDUCED", "APPEND", False
    more = drawn("HAPTIC_TERRAIN_PT_take", "ui.panels.take")
    assert {"take_bound", "take"} <= set(more.properties)
    assert "trail_kinds" not in more.properties
    module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    bpy.ops.haptic_terrain.record_start()
    assert "haptic_terrain.record_discard" in drawn("HAPTIC_TERRAIN_PT_take", "ui.panels.take").operators
    bpy.ops.haptic_terrain.record_discard()
