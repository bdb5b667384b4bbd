"""One road for files from the browser, from a drop and from scripts; several at once."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest

from tests.addon.scene import contents, module
from tests.formats.megdr_pair import MegdrPair, rough


def written(tmp_path: Path, *names: str, **spoilt: MegdrPair) -> list[Path]:
    pair = MegdrPair(rough(9, 13))
    return [replace(spoilt.get(name, pair), name=name).write(tmp_path) for name in names]


def terrains() -> list[bpy.types.Object]:
    return [thing for thing in bpy.data.objects if module("terrain.kept").is_terrain(thing)]


def import_files(folder: Path, *names: str) -> set[Any]:
    files = [{"name": name} for name in names]
    return set(bpy.ops.haptic_terrain.import_grid(directory=str(folder), files=files))


def test_several_files_are_an_object_each(tmp_path: Path) -> None:
    written(tmp_path, "a", "b", "c")
    assert import_files(tmp_path, "a.lbl", "b.img", "c.lbl") == {"FINISHED"}
    assert [terrain.name for terrain in terrains()] == ["Mars a", "Mars b", "Mars c"]
    assert all(terrain.select_get() for terrain in terrains())


def test_they_do_not_lie_in_one_another(tmp_path: Path) -> None:
    written(tmp_path, "a", "b", "c")
    import_files(tmp_path, "a.lbl", "b.lbl", "c.lbl")
    middles = [terrain.location.x for terrain in terrains()]
    assert middles == pytest.approx([0.0, 11.0, 22.0], abs=0.1)


def test_label_and_data_file_of_one_grid_are_one_terrain(tmp_path: Path) -> None:
    written(tmp_path, "a")
    import_files(tmp_path, "a.lbl", "a.img")
    assert len(terrains()) == 1


def test_a_bad_file_among_good_ones_is_told_and_leaves_nothing(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    written(tmp_path, "a", "bad", "c", bad=MegdrPair(rough(9, 13), image={"LINES": 1}))
    assert import_files(tmp_path, "a.lbl", "bad.lbl", "c.lbl") == {"FINISHED"}
    assert [terrain.name for terrain in terrains()] == ["Mars a", "Mars c"]
    assert contents()["meshes"] == contents()["materials"] == 2
    told = capfd.readouterr().out
    assert "Warning: bad.lbl: LINES: found 1" in told


def test_bad_files_alone_are_an_error(tmp_path: Path) -> None:
    bad = MegdrPair(rough(9, 13), image={"LINES": 1})
    written(tmp_path, "bad", "worse", bad=bad, worse=bad)
    before = contents()
    with pytest.raises(RuntimeError, match=r"bad\.lbl(.|\n)*worse\.lbl"):
        import_files(tmp_path, "bad.lbl", "worse.lbl")
    assert contents() == before


def test_several_files_can_be_dropped(tmp_path: Path) -> None:
    written(tmp_path, "a", "b")
    bpy.ops.wm.drop_import_file(directory=str(tmp_path), files=[{"name": "a.lbl"}, {"name": "b.lbl"}])
    assert len(terrains()) == 2


def test_the_file_handler_is_named_for_what_it_reads() -> None:
    operator = module("ui.import_operator")
    assert operator.HAPTIC_TERRAIN_FH_grid.bl_label == "Elevation terrain"
    # Where another handler takes the file too, a window offers the operators by their names.
    assert operator.HAPTIC_TERRAIN_OT_import_grid.bl_label == "Elevation terrain"
    entries: list[str] = []
    layout = SimpleNamespace(operator=lambda _name, text: entries.append(text))
    operator.draw_menu(SimpleNamespace(layout=layout), bpy.context)
    assert entries == ["Elevation terrain"]


def test_files_go_before_a_path(tmp_path: Path) -> None:
    chosen = module("ui.import_operator").chosen_paths
    files = [SimpleNamespace(name="a.lbl"), SimpleNamespace(name="")]
    dropped = SimpleNamespace(filepath="/x.lbl", directory=str(tmp_path), files=files)
    assert chosen(dropped) == [tmp_path / "a.lbl"]
    dropped.files = files[1:]
    assert chosen(dropped) == [Path("/x.lbl")]


def test_what_a_reader_noticed_is_told_to_scripts_too(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "grid.asc"
    path.write_text("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5 6\n")
    bpy.ops.haptic_terrain.import_grid(filepath=str(path))
    assert "Warning: grid: There is no .prj file" in capfd.readouterr().out
