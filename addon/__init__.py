"""Haptic Terrain: touch planetary terrain in Blender.

Blender's parts are imported only when Blender registers the extension, so that ``formats`` and the
arithmetic of ``terrain`` and ``record`` can be used, and tested, without it.
"""

from __future__ import annotations

from types import ModuleType


def register() -> None:
    """Make the extension known to Blender, or say that Blender has to be started again first."""
    _registration().register()


def unregister() -> None:
    """Take everything back, in reverse order."""
    _registration().unregister()


def _registration() -> ModuleType:
    # What is loaded cannot change before Blender ends, so both calls come to the same answer.
    from . import restart

    if restart.is_needed():
        return restart
    from . import registration

    return registration
