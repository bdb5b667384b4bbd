"""The preferences, presets, and the facts for a bug report."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.addon.test_panels import Notes
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def label(tmp_path: Path) -> Path:
    return MegdrPair(rough(40, 60)).write(tmp_path)


@pytest.fixture(autouse=True)
def no_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave the keys out, which Blender draws itself: their own tests are elsewhere."""
    monkeypatch.setattr(module("ui.preferences"), "_draw_keys", lambda _layout, _context: None)
    monkeypatch.setattr(module("ui.mouse_keys"), "draw_keys", lambda _layout, _context: None)


@pytest.fixture
def own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Let the extension's own folders be the test's."""
    for name in ("ui.preferences", "ui.preference_operators"):
        monkeypatch.setattr(module(name), "own_folder", lambda folder: tmp_path / "own" / str(folder))
    return tmp_path / "own"


def preferences() -> Any:
    return bpy.context.preferences.addons[module("package").PACKAGE].preferences


def draw() -> Notes:
    notes = Notes()
    fields = {
        name: getattr(preferences(), name) for name in ("vertex_budget", "mola_address", "cache_gigabytes")
    }
    module("ui.preferences").HapticTerrainPreferences.draw(
        SimpleNamespace(layout=notes, **fields), bpy.context
    )
    return notes


def test_they_show_defaults_folders_and_the_report_button(own: Path) -> None:
    (own / "cache").mkdir(parents=True)
    (own / "cache" / "one.samples").write_bytes(bytes(2_500_000))
    notes = draw()
    assert notes.properties == ["vertex_budget", "mola_address", "cache_gigabytes"]
    assert "Decoded grids: 2.5 MB" in notes.labels
    assert "Downloaded grids: 0 bytes" in notes.labels
    assert notes.operators == ["haptic_terrain.clear_folder"] * 2 + ["haptic_terrain.copy_diagnostics"]


def test_a_folder_is_cleared_and_the_other_one_kept(own: Path) -> None:
    for name in ("cache", "mola"):
        (own / name).mkdir(parents=True)
        (own / name / "file").write_bytes(bytes(10))
    assert bpy.ops.haptic_terrain.clear_folder(folder="cache") == {"FINISHED"}
    assert not (own / "cache").exists()
    assert (own / "mola" / "file").is_file()


def test_nothing_is_cleared_under_a_hand(own: Path, label: Path) -> None:
    import_grid(label)
    bpy.ops.haptic_terrain.touch_start()
    with pytest.raises(RuntimeError, match="stop it first"):
        bpy.ops.haptic_terrain.clear_folder(folder="cache")


def test_the_limit_of_the_cache_holds_at_once() -> None:
    cache = module("formats.cache").cache
    preferences().cache_gigabytes = 3
    assert cache.most_on_disk == 3 << 30
    preferences().cache_gigabytes = 20


def test_an_import_begins_with_the_person_s_own_detail(monkeypatch: pytest.MonkeyPatch) -> None:
    preferences().vertex_budget = 1234
    cls = module("ui.import_operator").HAPTIC_TERRAIN_OT_import_grid
    asked: list[object] = []
    manager = SimpleNamespace(invoke_props_dialog=lambda *_arguments, **_named: asked.append(1))
    context = SimpleNamespace(window_manager=manager, preferences=bpy.context.preferences)
    for given, expected in ((False, 1234), (True, 77)):
        operator = SimpleNamespace(
            answered=False,
            filepath="a",
            files=[],
            vertex_budget=77,
            properties=SimpleNamespace(is_property_set=lambda _name, given=given: given),
        )
        cls.invoke(operator, context, None)
        assert operator.vertex_budget == expected
    assert len(asked) == 2


def presets(subdir: str) -> dict[str, Path]:
    """Find what a preset menu would show of ours."""
    home = Path(module("ui.presets").HOME)
    return {
        path.stem: path
        for folder in bpy.utils.preset_paths(subdir)
        for path in Path(folder).glob("*.py")
        if path.is_relative_to(home)
    }


@pytest.mark.parametrize("name", ["Soft", "Crisp", "Texture"])
def test_touch_presets_are_in_the_menu_and_set_the_scene(name: str) -> None:
    path = presets("haptic_terrain_touch")[name]
    settings = bpy.context.scene.haptic_terrain
    settings.max_force = 5.5
    menu = "HAPTIC_TERRAIN_MT_touch_presets"
    assert bpy.ops.script.execute_preset(filepath=str(path), menu_idname=menu) == {"FINISHED"}
    assert settings.max_force != 5.5
    text = path.read_text(encoding="utf-8")
    for setting in module("ui.presets").TOUCH_SETTINGS:
        assert f"settings.{setting} = " in text, "a preset sets all, or what was before shines through"
        value = getattr(settings, setting)
        assert f"settings.{setting} = {value!r}".replace("'", '"') in text


def test_touch_presets_feel_different() -> None:
    found = set()
    for path in presets("haptic_terrain_touch").values():
        bpy.ops.script.execute_preset(filepath=str(path), menu_idname="HAPTIC_TERRAIN_MT_touch_presets")
        settings = bpy.context.scene.haptic_terrain
        found.add(tuple(getattr(settings, name) for name in module("ui.presets").TOUCH_SETTINGS))
    assert len(found) == 3


def test_import_presets_name_properties_of_the_operator() -> None:
    found = presets("operator/haptic_terrain.import_grid")
    assert set(found) == {"Quick_Look", "Detailed", "True_Heights_in_Kilometres"}
    known = bpy.ops.haptic_terrain.import_grid.get_rna_type().properties
    for path in found.values():
        active = SimpleNamespace()
        text = path.read_text(encoding="utf-8").replace("bpy.context.active_operator", "active")
        exec(text, {"active": active, "__builtins__": {"__import__": __import__}})
        for name, value in vars(active).items():
            assert type(getattr(known[name], "default", None)) is type(value), name


def test_a_person_s_own_preset_is_kept_and_removed() -> None:
    bpy.context.scene.haptic_terrain.max_force = 4.25
    assert bpy.ops.haptic_terrain.touch_preset_add(name="Mine") == {"FINISHED"}
    folder = Path(bpy.utils.user_resource("SCRIPTS", path="presets/haptic_terrain_touch"))
    assert "settings.max_force = 4.25" in (folder / "Mine.py").read_text(encoding="utf-8")
    bpy.ops.haptic_terrain.touch_preset_add(name="Mine", remove_name=True)
    assert not (folder / "Mine.py").exists()


def test_the_bug_report_s_facts_name_versions_terrain_and_timing(label: Path) -> None:
    import_grid(label)
    facts = module("ui.diagnostics").diagnostics
    assert "Touch is not running" in facts()
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    touch.session.step(500)
    text = facts()
    for words in (
        bpy.app.version_string,
        "proxygraph 0.",
        "hidapi ",
        "pyusb ",
        "MOLA (PDS3), 60 x 40 i16",
        "2400 vertices",
        "ticks: 500",
        "late_us",
        "update_us",
        "99.9%",
        "Devices of known makers",
    ):
        assert words in text, words


def test_the_bug_report_s_facts_name_no_file_and_no_person(
    label: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    terrain = import_grid(label)
    terrain.name = "My secret project"
    diagnostics = module("ui.diagnostics")
    trouble = [f"hidapi: ImportError: {tmp_path}/lib/libusb.so is missing"]
    monkeypatch.setattr(diagnostics, "problems", lambda: trouble)
    text = diagnostics.diagnostics()
    for words in (str(tmp_path), label.name, "secret", str(Path.home())):
        assert words not in text
    assert "~/lib/libusb.so" in text


def test_copying_reaches_the_clipboard_or_the_console(capsys: pytest.CaptureFixture[str]) -> None:
    assert bpy.ops.haptic_terrain.copy_diagnostics() == {"FINISHED"}
    assert "Haptic Terrain" in capsys.readouterr().out


def test_libraries_for_devices_are_there() -> None:
    attached = module("devices.attached")
    assert attached._hid_module().enumerate() is not None
    assert isinstance(attached.attached(), list)
    assert not [line for line in attached.problems() if "No module" in line]
