"""Terrains in .blend files: opened elsewhere, linked, appended, rendered, and without their grid."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import bpy
import pytest

from tests.addon.scene import import_grid, module
from tests.addon.test_panels import drawn
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """Save a terrain in a .blend file, with its grid in a folder beside; gives the folder of both."""
    folder = tmp_path / "project"
    (folder / "grids").mkdir(parents=True)
    import_grid(MegdrPair(rough(40, 60)).write(folder / "grids"))
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "scene.blend"))
    return folder


def terrain() -> bpy.types.Object:
    return bpy.data.objects["Mars grid"]


def data_path() -> Path:
    path: Path = module("terrain.kept").recall(terrain()).grid.data_path
    return path


def new_file() -> None:
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)


def bring(blend: Path, *, link: bool) -> bpy.types.Object:
    """Link or append the terrain into the open file, and put it into the scene."""
    with bpy.data.libraries.load(str(blend), link=link) as (_there, wanted):
        wanted.objects = ["Mars grid"]
    found: bpy.types.Object = wanted.objects[0]
    bpy.context.collection.objects.link(found)
    bpy.context.view_layer.objects.active = found
    return found


def test_a_moved_project_opens_with_its_own_grid(project: Path, tmp_path: Path) -> None:
    elsewhere = tmp_path / "on another machine"
    new_file()
    shutil.move(project, elsewhere)
    bpy.ops.wm.open_mainfile(filepath=str(elsewhere / "scene.blend"))
    assert data_path() == elsewhere / "grids" / "grid.img"
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}
    module("touch.stop").stop_touch()
    assert bpy.ops.haptic_terrain.rebuild(vertex_budget=100) == {"FINISHED"}, "the label has moved too"


def test_a_file_that_is_saved_elsewhere_still_finds_its_grid(project: Path, tmp_path: Path) -> None:
    (tmp_path / "deep" / "er").mkdir(parents=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "deep" / "er" / "copy.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "deep" / "er" / "copy.blend"))
    assert data_path() == project / "grids" / "grid.img"


@pytest.mark.parametrize("link", [True, False], ids=["linked", "appended"])
def test_a_terrain_of_another_file_can_be_touched(project: Path, link: bool) -> None:
    new_file()
    bring(project / "scene.blend", link=link)
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}
    touch = module("touch.live").live.touch
    touch.session.stop()
    touch.session.step(10)
    module("touch.tick").tick()
    assert module("touch.live").live.touch is touch


@pytest.mark.parametrize("link", [True, False], ids=["linked", "appended"])
def test_a_terrain_of_another_file_finds_its_moved_grid(project: Path, tmp_path: Path, link: bool) -> None:
    new_file()
    elsewhere = tmp_path / "elsewhere"
    shutil.move(project, elsewhere)
    if not link and not hasattr(bpy.app.handlers, "blend_import_post"):
        pytest.skip("this Blender does not say what it appended: Relink helps")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "other.blend"))
    act = bpy.ops.wm.link if link else bpy.ops.wm.append
    act(directory=f"{elsewhere / 'scene.blend'}/Object/", filename="Mars grid")
    assert (terrain().library is not None) == link
    assert data_path() == elsewhere / "grids" / "grid.img"


def test_a_linked_terrain_is_changed_where_it_is_from(project: Path) -> None:
    new_file()
    linked = bring(project / "scene.blend", link=True)
    before = linked.haptic_terrain.exaggeration
    with pytest.raises(RuntimeError, match="linked from another file"):
        bpy.ops.haptic_terrain.rebuild(vertex_budget=100)
    with suppress(AttributeError, RuntimeError):  # some versions of Blender refuse it themselves
        linked.haptic_terrain.exaggeration = 3.0
    assert linked.haptic_terrain.exaggeration == before


@pytest.mark.parametrize(
    "act",
    [
        lambda: bpy.ops.haptic_terrain.touch_start(),
        lambda: bpy.ops.haptic_terrain.rebuild(),
        lambda: bpy.ops.haptic_terrain.show_curvature(curved=True),
    ],
    ids=["touch", "rebuild", "curvature"],
)
def test_a_missing_grid_is_told_once_by_who_needs_it(project: Path, act: Callable[[], object]) -> None:
    shutil.rmtree(project / "grids")
    bpy.ops.wm.open_mainfile(filepath=str(project / "scene.blend"))
    before = len(terrain().data.vertices)
    with pytest.raises(RuntimeError, match=r"grid\.") as error:
        act()
    assert str(error.value).count("grid.") <= 2
    assert "Traceback" not in str(error.value)
    assert len(terrain().data.vertices) == before


def test_without_its_grid_a_file_opens_quietly_and_shows_its_preview(
    project: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    shutil.rmtree(project / "grids")
    capfd.readouterr()
    bpy.ops.wm.open_mainfile(filepath=str(project / "scene.blend"))
    for panel in ("HAPTIC_TERRAIN_PT_terrain", "HAPTIC_TERRAIN_PT_touch", "HAPTIC_TERRAIN_PT_record"):
        drawn(panel)
    assert "use Relink" in " ".join(drawn("HAPTIC_TERRAIN_PT_terrain").labels)
    assert len(terrain().data.vertices) == 2400
    out, err = capfd.readouterr()
    assert "Traceback" not in out + err
    assert "rror" not in err


def test_nothing_is_touched_by_opening_or_rendering(project: Path, tmp_path: Path) -> None:
    bpy.ops.haptic_terrain.touch_start()
    bpy.ops.haptic_terrain.record_start()
    bpy.ops.wm.save_mainfile()
    bpy.ops.wm.open_mainfile(filepath=str(project / "scene.blend"))
    live, timer = module("touch.live").live, module("touch.timer")
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(scene.camera)
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.render.resolution_x = scene.render.resolution_y = 8
    scene.render.filepath = str(tmp_path / "frame.png")
    bpy.ops.render.render(write_still=True)
    assert (tmp_path / "frame.png").is_file()
    assert live.touch is None
    assert live.recording is None
    assert timer._run() is None, "Blender's timer ends with the touch"
    assert not live.rendering
