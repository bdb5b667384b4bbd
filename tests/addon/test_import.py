"""From a grid file to a terrain object."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import chain
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from tests.addon.scene import contents, import_grid, module, positions, triangles
from tests.formats.megdr_pair import MegdrPair, planet, rough


@pytest.fixture
def pair() -> MegdrPair:
    return MegdrPair(rough(9, 13))


def described(path: Path, vertex_budget: int) -> list[str]:
    """What the dialog says of a file."""
    options = module("terrain.options").ImportOptions(vertex_budget=vertex_budget)
    lines: list[str] = module("ui.import_description").described(path, options)
    return lines


def test_every_vertex_of_a_small_grid_is_a_sample(pair: MegdrPair, tmp_path: Path) -> None:
    terrain = import_grid(pair.write(tmp_path))
    kept = module("terrain.kept").recall(terrain)
    frame, layout = kept.frame, kept.grid.layout
    expected = [
        frame.to_object(column * layout.cell_width, -row * layout.cell_height, pair.heights[row][column])
        for row in range(9)
        for column in range(13)
    ]
    assert np.array_equal(positions(terrain.data), np.array(expected).astype(np.float32))


def test_elevations_are_kept_in_metres(pair: MegdrPair, tmp_path: Path) -> None:
    mesh = import_grid(pair.write(tmp_path)).data
    assert [value.value for value in mesh.attributes["elevation"].data] == list(chain(*pair.heights))


def test_cells_are_split_from_north_west_to_south_east(tmp_path: Path) -> None:
    mesh = import_grid(MegdrPair([[0, 0], [0, 10]]).write(tmp_path)).data
    assert {frozenset(face) for face in triangles(mesh).tolist()} == {
        frozenset({0, 2, 3}),
        frozenset({0, 3, 1}),
    }


def test_faces_look_up(pair: MegdrPair, tmp_path: Path) -> None:
    mesh = import_grid(pair.write(tmp_path)).data
    assert all(face.normal.z > 0.0 for face in mesh.polygons)
    assert not mesh.validate()


@pytest.mark.parametrize("budget", [4, 20, 60, 116, 117])
def test_the_preview_keeps_its_budget_and_shows_samples_only(
    pair: MegdrPair, tmp_path: Path, budget: int
) -> None:
    terrain = import_grid(pair.write(tmp_path), vertex_budget=budget)
    kept = module("terrain.kept").recall(terrain)
    cells = module("terrain.preview").preview_cells(kept.grid.layout, budget)
    assert len(terrain.data.vertices) == cells.vertices <= budget
    assert (cells.columns[0], cells.columns[-1], cells.rows[0], cells.rows[-1]) == (0, 12, 0, 8)
    shown = [value.value for value in terrain.data.attributes["elevation"].data]
    assert shown == [pair.heights[row][column] for row in cells.rows for column in cells.columns]


def test_the_count_shown_before_import_is_the_count_after(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    lines = described(label, 60)
    terrain = import_grid(label, vertex_budget=60)
    assert any(line.startswith(f"{len(terrain.data.vertices):,} vertices") for line in lines)


def test_the_dialog_says_what_is_wrong_with_a_file(pair: MegdrPair, tmp_path: Path) -> None:
    lines = described(replace(pair, image={"LINES": 1}).write(tmp_path), 60)
    assert "LINES" in lines[0]


@pytest.mark.parametrize("name", ['"../G.IMG"', '"."', f'"{"G" * 300}"', '("G.IMG", 1e400 <BYTES>)'])
def test_the_dialog_explains_hostile_names(pair: MegdrPair, tmp_path: Path, name: str) -> None:
    label = replace(pair, header={"^IMAGE": name}).write(tmp_path)
    assert "^IMAGE" in " ".join(described(label, 60))


def test_the_dialog_stands_a_name_that_no_system_takes(tmp_path: Path) -> None:
    assert "Choose" in described(tmp_path / f"{'g' * 300}.lbl", 60)[0]


def test_the_dialog_reads_a_refused_label_once_and_again_when_it_is_mended(
    pair: MegdrPair, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    header, reads = module("terrain.prepare"), []

    def noted(path: Path, *_arguments: object) -> object:
        reads.append(path)
        return module("formats").read_grid(path)

    monkeypatch.setattr(header, "read_grid", noted)
    label = replace(pair, image={"LINES": 1}).write(tmp_path)
    for _ in range(3):
        assert "LINES" in " ".join(described(label.with_suffix(".img"), 60))
    assert len(reads) == 1
    label.unlink()
    pair.write(tmp_path)
    assert "Mars grid" in described(label.with_suffix(".img"), 60)


def test_a_planet_closes(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path), vertex_budget=10_000)
    cells = module("terrain.preview").preview_cells(
        module("terrain.kept").recall(terrain).grid.layout, 10_000
    )
    grid = positions(terrain.data).reshape(len(cells.rows), len(cells.columns), 3)
    assert np.array_equal(grid[:, 0, 2], grid[:, -1, 2])
    assert grid[0, -1, 0] - grid[0, 0, 0] == pytest.approx(10.0)


def test_triangles_at_a_void_are_absent(tmp_path: Path) -> None:
    heights = rough(5, 5)
    heights[2][2] = -32768
    mesh = import_grid(MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path)).data
    assert len(mesh.vertices) == 24
    assert len(mesh.polygons) == 32 - 6
    assert positions(mesh)[:, 2].min() > -20.0
    assert not mesh.validate()


def checkered(rows: int, columns: int, *, void: int = -32768) -> list[list[int]]:
    """Every second sample is void: no triangle is whole."""
    heights = rough(rows, columns)
    return [
        [void if (row + column) % 2 else height for column, height in enumerate(line)]
        for row, line in enumerate(heights)
    ]


def test_a_grid_without_a_whole_triangle_has_a_preview_of_points(tmp_path: Path) -> None:
    pair = MegdrPair(checkered(6, 6), image={"MISSING_CONSTANT": -32768})
    mesh = import_grid(pair.write(tmp_path)).data
    assert (len(mesh.vertices), len(mesh.polygons)) == (18, 0)
    assert positions(mesh)[:, 0].max() > 0.0


def test_a_grid_whose_shown_samples_are_all_void_can_be_touched(tmp_path: Path) -> None:
    heights = rough(40, 40)
    label = MegdrPair(heights).write(tmp_path)
    layout = module("formats").read_grid(label).layout
    cells = module("terrain.preview").preview_cells(layout, 16)
    for row in cells.rows:
        for column in cells.columns:
            heights[row][column] = -32768
    pair = MegdrPair(heights, image={"MISSING_CONSTANT": -32768})
    mesh = import_grid(pair.write(tmp_path), vertex_budget=16).data
    assert (len(mesh.vertices), len(mesh.polygons)) == (0, 0)
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}


@pytest.mark.parametrize(
    "step",
    ["terrain.mesh.shown_positions", "terrain.add_terrain.terrain_material", "terrain.add_terrain.keep"],
)
def test_an_import_that_fails_half_way_leaves_nothing(
    pair: MegdrPair, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    def fail(*_arguments: object, **_named: object) -> None:
        raise MemoryError

    place, _, name = step.rpartition(".")
    monkeypatch.setattr(module(place), name, fail)
    before = contents()
    with pytest.raises(RuntimeError, match="MemoryError"):
        import_grid(pair.write(tmp_path))
    assert contents() == before


def test_an_import_into_an_excluded_collection_is_not_selected(pair: MegdrPair, tmp_path: Path) -> None:
    layer = bpy.context.view_layer
    collection = bpy.data.collections.new("Away")
    bpy.context.scene.collection.children.link(collection)
    layer.active_layer_collection = layer.layer_collection.children["Away"]
    layer.layer_collection.children["Away"].exclude = True
    context = SimpleNamespace(
        window_manager=bpy.context.window_manager,
        collection=collection,
        view_layer=layer,
        selected_objects=[],
    )
    importing = module("terrain.import_terrain")
    terrain = importing.import_terrain(context, pair.write(tmp_path), importing.ImportOptions())
    assert terrain.name in collection.objects


@pytest.mark.parametrize("spoilt", [False, True])
def test_an_import_shows_how_far_it_has_come(pair: MegdrPair, tmp_path: Path, spoilt: bool) -> None:
    told: list[float] = []
    ends: list[bool] = []
    manager = SimpleNamespace(
        progress_begin=lambda *_span: told.clear(),
        progress_update=told.append,
        progress_end=lambda: ends.append(True),
    )
    context = SimpleNamespace(
        window_manager=manager,
        collection=bpy.context.collection,
        view_layer=bpy.context.view_layer,
        selected_objects=[],
    )
    importing = module("terrain.import_terrain")
    label = replace(pair, image={"LINES": 1} if spoilt else {}).write(tmp_path)
    try:
        importing.import_terrain(context, label, importing.ImportOptions())
    except module("formats").FormatError:
        assert spoilt
    else:
        assert len(told) >= 3
        assert told == sorted(set(told))
    assert ends == [True]


@pytest.mark.parametrize("height", [21134, 0, -8068])
def test_a_flat_grid_has_a_range_of_colours(tmp_path: Path, height: int) -> None:
    terrain = import_grid(MegdrPair([[height] * 3] * 3).write(tmp_path))
    nodes = terrain.data.materials[0].node_tree.nodes
    share = next(node for node in nodes if node.type == "MAP_RANGE")
    assert share.inputs["From Max"].default_value > share.inputs["From Min"].default_value == height


def test_the_longest_side_is_ten_units(pair: MegdrPair, tmp_path: Path) -> None:
    assert max(import_grid(pair.write(tmp_path)).dimensions[:]) == pytest.approx(10.0)


@pytest.mark.parametrize(("scale", "units"), [("METRE", 1.0), ("KILOMETRE", 0.001)])
def test_one_unit_may_be_a_metre_or_a_kilometre(
    pair: MegdrPair, tmp_path: Path, scale: str, units: float
) -> None:
    terrain = import_grid(pair.write(tmp_path), scale=scale)
    layout = module("terrain.kept").recall(terrain).grid.layout
    assert terrain.dimensions.x == pytest.approx(12 * layout.cell_width * units)


def test_a_chosen_exaggeration_is_used(pair: MegdrPair, tmp_path: Path) -> None:
    terrain = import_grid(pair.write(tmp_path), scale="METRE", exaggeration=3.0)
    relief = max(map(max, pair.heights)) - min(map(min, pair.heights))
    assert terrain.dimensions.z == pytest.approx(3.0 * relief)


@pytest.mark.parametrize(
    ("relief", "expected"),
    [(29_200, 50.0), (100_000, 10.0), (2_000_000, 1.0), (0, 1.0), (530_000, 2.0), (3, 500_000.0)],
)
def test_exaggeration_is_round(relief: float, expected: float) -> None:
    frame, layout = module("terrain.frame"), _wide_layout()
    assert frame.rounded_exaggeration(layout, 0.0, relief) == expected


def _wide_layout() -> object:
    """Make a map as wide as Mars."""
    from proxygraph import GridLayout

    return GridLayout(720, 1440, cell_width=14_818.0, cell_height=14_818.0, wraps=True)


def test_georeference_is_kept_as_doubles_and_survives_a_file(pair: MegdrPair, tmp_path: Path) -> None:
    terrain = import_grid(replace(pair, west=226.123456789).write(tmp_path))
    name, before = terrain.name, module("terrain.kept").recall(terrain)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "kept.blend"))
    after = module("terrain.kept").recall(bpy.data.objects[name])
    assert after.grid.georeference == before.grid.georeference
    assert after.grid.georeference.x(-0.5) == pytest.approx(226.123456789, rel=1e-15)
    assert after.frame == before.frame
    assert after.grid.data_path == before.grid.data_path
    for field in (
        "rows",
        "columns",
        "offset",
        "row_stride",
        "scale",
        "value_offset",
        "void",
        "wraps",
        "sample",
    ):
        assert getattr(after.grid.layout, field) == getattr(before.grid.layout, field)


def test_a_grid_named_from_the_working_folder_is_found_again_from_elsewhere(
    pair: MegdrPair, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pair.write(tmp_path)
    monkeypatch.chdir(tmp_path)
    terrain = import_grid(Path("grid.lbl"))
    monkeypatch.chdir("/")
    assert module("terrain.kept").recall(terrain).grid.open().elevation(0, 0) == pair.heights[0][0]


def moved_together(pair: MegdrPair, tmp_path: Path) -> tuple[Path, Path]:
    """Save a scene beside its grid, and give its place and its next one."""
    old, new = tmp_path / "old", tmp_path / "new" / "deeper"
    (old / "grids").mkdir(parents=True)
    import_grid(pair.write(old / "grids"))
    bpy.ops.wm.save_as_mainfile(filepath=str(old / "scene.blend"))
    return old, new


def terrain_of(blend: Path) -> bpy.types.Object:
    bpy.ops.wm.open_mainfile(filepath=str(blend))
    return next(thing for thing in bpy.data.objects if module("terrain.kept").is_terrain(thing))


def test_a_scene_that_moved_with_its_grid_finds_it(pair: MegdrPair, tmp_path: Path) -> None:
    old, new = moved_together(pair, tmp_path)
    new.parent.mkdir()
    old.rename(new)
    kept = module("terrain.kept").recall(terrain_of(new / "scene.blend"))
    assert kept.grid.open().elevation(0, 0) == pair.heights[0][0]
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "elsewhere.blend"))
    # Only what was saved as the whole path leads back from here.
    (tmp_path / "elsewhere.blend").rename(new / "alone.blend")
    kept = module("terrain.kept").recall(terrain_of(new / "alone.blend"))
    assert kept.grid.data_path == (new / "grids" / "grid.img").resolve()


def test_a_scene_that_moved_without_its_grid_finds_it(pair: MegdrPair, tmp_path: Path) -> None:
    old, new = moved_together(pair, tmp_path)
    new.mkdir(parents=True)
    (old / "scene.blend").rename(new / "scene.blend")
    kept = module("terrain.kept").recall(terrain_of(new / "scene.blend"))
    assert kept.grid.open().elevation(0, 0) == pair.heights[0][0]


def test_the_terrain_is_named_synthetic_where_it_is(sample: Path) -> None:
    terrain = import_grid(sample)
    assert "synthetic" in terrain.name.lower()
    assert len(terrain.data.vertices) <= 250_000


def test_the_real_planet(mola: Path) -> None:
    terrain = import_grid(mola.with_suffix(".img"))
    kept = module("terrain.kept").recall(terrain)
    assert (kept.maximum, kept.minimum) == (21134.0, -8068.0)
    assert kept.frame.exaggeration == 50.0
    assert 150_000 < len(terrain.data.vertices) <= 250_000
    cells = module("terrain.preview").preview_cells(kept.grid.layout)
    raw = np.fromfile(mola.with_suffix(".img"), dtype=">i2").reshape(720, 1440)
    shown = np.empty(len(terrain.data.vertices), dtype=np.float32)
    terrain.data.attributes["elevation"].data.foreach_get("value", shown)
    assert np.array_equal(shown, raw[np.ix_(cells.rows, np.array(cells.columns) % 1440)].ravel())


def spoil_label(label: Path) -> None:
    label.unlink()


def spoil_data(label: Path) -> None:
    label.with_suffix(".img").unlink()


def shorten_data(label: Path) -> None:
    data = label.with_suffix(".img")
    data.write_bytes(data.read_bytes()[:-2])


def rename_image(label: Path) -> None:
    label.write_text(label.read_text().replace("= IMAGE\n", "= TABLE\n"))


def scramble(label: Path) -> None:
    label.write_bytes(bytes(range(256)))


def void_all(label: Path) -> None:
    label.write_text(label.read_text().replace("SAMPLE_BITS", "MISSING_CONSTANT = 7\nSAMPLE_BITS"))
    label.with_suffix(".img").write_bytes(b"\0\7" * 117)


def strange_type(label: Path) -> None:
    label.write_text(label.read_text().replace("MSB_INTEGER", "IEEE_REAL"))


def single_line(label: Path) -> None:
    label.write_text(label.read_text().replace("LINES = 9", "LINES = 1"))


def strange_number(label: Path) -> None:
    label.write_text(label.read_text().replace("LINE_SAMPLES = 13", "LINE_SAMPLES = wide"))


@pytest.mark.parametrize(
    ("spoil", "word"),
    [
        (spoil_label, "grid.lbl"),
        (spoil_data, "GRID.IMG"),
        (shorten_data, "234 bytes"),
        (rename_image, "IMAGE"),
        (scramble, "PDS3"),
        (void_all, "MISSING_CONSTANT"),
        (strange_type, "IEEE_REAL"),
        (single_line, "at least 2"),
        (strange_number, "wide"),
    ],
)
def test_bad_input_is_explained_and_leaves_nothing(
    pair: MegdrPair, tmp_path: Path, spoil: Callable[[Path], None], word: str
) -> None:
    label = pair.write(tmp_path)
    spoil(label)
    before = contents()
    with pytest.raises(RuntimeError, match=word):
        bpy.ops.haptic_terrain.import_grid(filepath=str(label))
    assert contents() == before


def test_a_dropped_file_is_imported(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    handlers = [cls for cls in bpy.types.FileHandler.__subclasses__() if cls.__name__.startswith("HAPTIC")]
    assert handlers[-1].bl_file_extensions == ";".join(module("formats").SUFFIXES)
    assert handlers[-1].bl_import_operator == "haptic_terrain.import_grid"
    bpy.ops.wm.drop_import_file(directory=str(label.parent), files=[{"name": label.name}])
    assert any(module("terrain.kept").is_terrain(thing) for thing in bpy.data.objects)
