"""What Blender's users may expect of everything in the interface, kept for all of it at once."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

import bpy
import pytest

from tests.addon.scene import module

WITHOUT_A_CONDITION = {"import_grid", "copy_diagnostics", "recover_take", "touch_preset_add"}
"""Operators that work whatever is open."""


def classes(base: type | None = None) -> list[Any]:
    """Everything that the extension registers."""
    found = module("registration").CLASSES
    return [cls for cls in found if base is None or issubclass(cls, base)]


def operators() -> list[Any]:
    return classes(bpy.types.Operator)


def tooltip(cls: Any) -> str:
    """Give what Blender shows of an operator."""
    text: str = getattr(bpy.ops.haptic_terrain, cls.bl_idname.partition(".")[2]).get_rna_type().description
    return text


def own_properties(cls: Any) -> Iterator[bpy.types.Property]:
    names = module("ui.translations")._annotated(cls)
    for item in cls.bl_rna.properties:
        if item.identifier in names and not item.is_hidden:
            yield item


def test_identifiers_have_blender_s_form() -> None:
    forms = {
        bpy.types.Operator: "OT",
        bpy.types.Panel: "PT",
        bpy.types.Menu: "MT",
        bpy.types.FileHandler: "FH",
    }
    for base, form in forms.items():
        for cls in classes(base):
            assert re.fullmatch(rf"HAPTIC_TERRAIN_{form}_[a-z_]+", cls.__name__), cls
    for cls in operators():
        assert re.fullmatch(r"haptic_terrain\.[a-z_]+", cls.bl_idname)


def test_every_operator_says_what_it_does_without_a_full_stop() -> None:
    for cls in operators():
        text = tooltip(cls)
        assert 10 < len(text) < 130, (cls, text)
        assert not text.endswith("."), (cls, text)
        assert text[0].isupper()


def test_every_operator_has_a_label_to_be_searched_for() -> None:
    labels = [cls.bl_label for cls in operators()]
    assert all(labels)
    assert len(set(labels)) == len(labels), "two would look alike in F3"


@pytest.mark.parametrize("cls", operators(), ids=lambda cls: cls.bl_idname)
def test_every_operator_says_why_its_button_is_grey(cls: Any) -> None:
    name = cls.bl_idname.partition(".")[2]
    if name in WITHOUT_A_CONDITION:
        assert getattr(bpy.ops.haptic_terrain, name).poll()
        return
    told: list[str] = []
    stand_in = type("StandIn", (), {"poll_message_set": told.append})
    bpy.context.preferences.system.use_online_access = False
    try:
        if name == "clear_folder":
            module("touch.live").live.touch = object()
        possible = cls.poll.__func__(stand_in, bpy.context)
    finally:
        bpy.context.preferences.system.use_online_access = True
        module("touch.live").live.touch = None
    assert not possible, "there is no terrain, no touch, no take and no network"
    assert told
    assert told[-1][0].isupper()
    assert not told[-1].endswith("!")


@pytest.mark.parametrize("cls", classes(), ids=lambda cls: cls.__name__)
def test_every_property_has_a_name_and_a_tooltip_that_teaches(cls: Any) -> None:
    for item in own_properties(cls):
        if item.identifier in {"filepath", "directory", "files", "check_existing"} or is_preset(cls):
            continue  # Blender's own, by ImportHelper, ExportHelper and AddPresetBase
        assert item.name, item.identifier
        assert len(item.description) > 3, item.identifier
        assert not item.description.endswith("."), item.identifier
        if isinstance(item, bpy.types.EnumProperty):
            assert all(choice.name for choice in item.enum_items)


def test_what_changes_the_scene_can_be_undone() -> None:
    changing = {"import_grid", "touch_start", "record_stop", "go_to", "show_curvature", "colour_by", "mark"}
    changing |= {"add_profile", "rebuild", "relink"}
    for cls in operators():
        if cls.bl_idname.partition(".")[2] in changing:
            assert "UNDO" in cls.bl_options, cls


def test_panels_lie_in_one_tab_or_in_object_data() -> None:
    for cls in classes(bpy.types.Panel):
        if cls.bl_space_type == "VIEW_3D":
            assert cls.bl_category == "Haptic Terrain"
        else:
            assert (cls.bl_space_type, cls.bl_context) == ("PROPERTIES", "data")


def test_everything_is_scriptable_by_its_name() -> None:
    assert {cls.bl_idname.partition(".")[2] for cls in operators()} <= set(dir(bpy.ops.haptic_terrain))


def test_scenes_and_objects_have_one_property_each() -> None:
    for kind in (bpy.types.Scene, bpy.types.Object):
        own = [name for name in kind.bl_rna.properties.keys() if "haptic" in name]  # noqa: SIM118
        assert own == ["haptic_terrain"]


def test_every_translation_is_of_words_that_are_there() -> None:
    translations = module("ui.translations")
    there = translations.messages(classes())
    for language, words in translations.dictionary().items():
        gone = {message for _context, message in words} - there
        assert not gone, (language, gone)


def test_labels_are_shown_in_the_person_s_language() -> None:
    view = bpy.context.preferences.view
    before = view.language
    try:
        view.language = "de_DE"
    except TypeError:
        pytest.skip("this Blender has no translations")
    try:
        view.use_translate_interface = True
        translate = bpy.app.translations.pgettext_iface
        assert translate("Start Touch", "Operator") == "Tasten beginnen"
        assert translate("Max Force") == "Gr\u00f6\u00dfte Kraft"
    finally:
        view.language = before


def test_every_word_of_classes_reaches_the_translators() -> None:
    messages = module("ui.translations").messages(classes())
    for cls in operators():
        assert {cls.bl_label, tooltip(cls)} <= messages
        for item in own_properties(cls):
            assert {item.name, item.description} - {""} <= messages


def test_languages_have_blender_s_names() -> None:
    translations = module("ui.translations")
    for path in translations.FOLDER.glob("*.json"):
        assert re.fullmatch(r"[a-z]{2}(_[A-Z]{2})?", path.stem)
        assert all(json.loads(path.read_text(encoding="utf-8")).values())


def is_preset(cls: Any) -> bool:
    return any(base.__name__ == "AddPresetBase" for base in cls.__mro__)
