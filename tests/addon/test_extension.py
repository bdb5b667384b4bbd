"""The extension as Blender's platform wants it."""

from __future__ import annotations

import ast
import atexit
import tomllib
from pathlib import Path

import bpy
import pytest

ADDON = Path(__file__).resolve().parents[2] / "addon"
SOURCES = sorted(ADDON.rglob("*.py"))


def test_the_manifest() -> None:
    manifest = tomllib.loads((ADDON / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert manifest["schema_version"] == "1.0.0"
    assert manifest["id"] == "haptic_terrain"
    assert manifest["blender_version_min"] == "4.2.0"
    assert manifest["license"] == ["SPDX:GPL-3.0-or-later"]
    assert len(manifest["tagline"]) <= 64
    assert not manifest["tagline"].endswith(".")
    assert all(reason and not reason.endswith(".") for reason in manifest["permissions"].values())


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: str(path.relative_to(ADDON)))
def test_own_modules_are_imported_relatively(source: Path) -> None:
    for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        if isinstance(node, ast.ImportFrom) and node.level == 0:
            names.append(node.module or "")
        assert not any(name.split(".")[0] in {"addon", "bl_ext", "haptic_terrain"} for name in names)


@pytest.mark.parametrize("source", sorted((ADDON / "formats").rglob("*.py")), ids=lambda path: path.name)
def test_formats_know_no_blender(source: Path) -> None:
    assert "import bpy" not in source.read_text(encoding="utf-8")


def test_everything_is_taken_back_in_reverse_order() -> None:
    import addon_utils
    from enable_addon import MODULE

    def registered() -> list[str]:
        return [name for name in dir(bpy.types) if name.startswith("HAPTIC")]

    handlers = {
        name: len(getattr(bpy.app.handlers, name)) for name in ("load_pre", "render_init", "render_cancel")
    }
    assert registered()
    addon_utils.disable(MODULE)
    assert registered() == []
    assert not hasattr(bpy.types.Scene, "haptic_terrain")
    after = {name: len(getattr(bpy.app.handlers, name)) for name in handlers}
    assert after == {name: count - 1 for name, count in handlers.items()}


def test_touch_also_ends_when_python_does(monkeypatch: pytest.MonkeyPatch) -> None:
    import addon_utils
    from enable_addon import MODULE, enable

    from tests.addon.scene import module

    timer = module("touch.timer")
    registered: list[object] = []
    addon_utils.disable(MODULE)
    # Some versions of Blender quit without disabling extensions, and then hang or crash on a timer.
    monkeypatch.setattr(atexit, "register", registered.append)
    monkeypatch.setattr(atexit, "unregister", registered.remove)
    enable()
    assert module("touch.timer")._quit in registered
    addon_utils.disable(MODULE)
    assert timer._quit not in registered


def test_over_native_code_of_another_version_only_a_message_is_registered(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import addon_utils
    import proxygraph
    from enable_addon import MODULE, enable

    def registered() -> list[str]:
        return [name for name in dir(bpy.types) if name.startswith("HAPTIC")]

    addon_utils.disable(MODULE)
    with monkeypatch.context() as patch:
        patch.setattr(proxygraph, "__version__", "0.0.1")
        enable()
        assert registered() == ["HAPTIC_TERRAIN_PT_restart"]
        assert "version 0.0.1 is still loaded: restart Blender" in capsys.readouterr().out
        addon_utils.disable(MODULE)
    assert registered() == []
    enable()
    assert "HAPTIC_TERRAIN_OT_import_grid" in registered()
