"""Haptic Terrain: touch planetary terrain in Blender.

Blender's parts are imported only when Blender registers the extension, so that ``formats`` and the
arithmetic of ``terrain`` and ``record`` can be used, and tested, without it.
"""


def register() -> None:
    """Make the extension known to Blender."""
    from . import registration

    registration.register()


def unregister() -> None:
    """Take everything back, in reverse order."""
    from . import registration

    registration.unregister()
