"""The words of the interface in other languages, through Blender's own system.

Blender looks up every label and tooltip of a class or a property itself. ``messages`` gathers them, so that
a translator has the list, and a test sees to it that no translation is of words that are gone.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from inspect import get_annotations
from pathlib import Path

import bpy

from ..package import PACKAGE

FOLDER = Path(__file__).parents[1] / "translations"
"""A file for each language, named as Blender names it: ``de.json`` maps words of the code to German ones."""

CONTEXTS = ("*", "Operator")
"""Blender's contexts of labels: buttons look in the second one."""

Dictionary = dict[str, dict[tuple[str, str], str]]


def dictionary() -> Dictionary:
    """Everything that is translated, as Blender takes it."""
    return {path.stem: _of_language(path) for path in sorted(FOLDER.glob("*.json"))}


def messages(classes: Iterable[type]) -> set[str]:
    """Every label and tooltip of classes and of their properties."""
    return {text for cls in classes for text in _messages(cls) if text}


def register() -> None:
    """Hand the dictionary to Blender."""
    bpy.app.translations.register(PACKAGE, dictionary())


def unregister() -> None:
    """Take it back."""
    bpy.app.translations.unregister(PACKAGE)


def _of_language(path: Path) -> dict[tuple[str, str], str]:
    words: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return {(context, message): translated for message, translated in words.items() for context in CONTEXTS}


def _messages(cls: type) -> Iterator[str]:
    structure = getattr(cls, "bl_rna", None)
    if structure is None:
        return
    yield from (structure.name, structure.description)
    # Of an operator with several base classes Blender knows the tooltip, and its class does not.
    yield from (getattr(cls, "bl_label", ""), cls.__doc__ or "")
    for item in structure.properties:
        if item.identifier in _annotated(cls):
            yield from (item.name, item.description)
            if isinstance(item, bpy.types.EnumProperty):
                for choice in item.enum_items:
                    yield from (choice.name, choice.description)


def _annotated(cls: type) -> set[str]:
    """Names of its own properties, also those that come from a base class that is no class of Blender's."""
    named = {name for base in cls.__mro__ for name in get_annotations(base)}
    return {name for name in named if not name.startswith("bl_")}  # those are the class's own
