"""The extension's own name and folders: it writes nowhere else."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path

import bpy

PACKAGE = str(__package__)
"""As Blender knows the extension: of preferences and translations too."""


class OwnFolder(StrEnum):
    """What is kept on the disk, by the name of its folder."""

    CACHE = "cache"
    """Decoded grids: they are made again when they are missing."""
    MOLA = "mola"
    """What was downloaded."""
    TAKES = "takes"
    """Takes that are being recorded, or that a crash left."""


def own_folder(name: OwnFolder) -> Path:
    """Where it is, or will be."""
    return Path(bpy.utils.extension_path_user(PACKAGE, path=str(name)))
