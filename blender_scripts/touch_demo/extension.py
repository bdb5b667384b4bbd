"""The pieces of the extension that the demo calls, once the extension is installed and enabled."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from types import ModuleType

from enable_addon import enable


@dataclass(frozen=True)
class Extension:
    """Modules of the enabled extension: scripts reach them under its installed name, never as ``addon``."""

    formats: ModuleType
    kept: ModuleType
    live: ModuleType
    recording: ModuleType
    start: ModuleType
    stop: ModuleType
    tick: ModuleType
    timer: ModuleType
    workspace: ModuleType


def enabled_extension() -> Extension:
    """Install and enable the extension of this checkout."""
    package = enable().__name__

    def part(name: str) -> ModuleType:
        return import_module(f"{package}.{name}")

    return Extension(
        formats=part("formats"),
        kept=part("terrain.kept"),
        live=part("touch.live"),
        recording=part("record.recording"),
        start=part("touch.start"),
        stop=part("touch.stop"),
        tick=part("touch.tick"),
        timer=part("touch.timer"),
        workspace=part("touch.workspace"),
    )
