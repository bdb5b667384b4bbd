"""Blender as a module, with its configuration under ``build/``, and a fresh session for each test.

The add-on is this checkout's; or, where ``HAPTIC_TERRAIN_ZIP`` names the extension's zip, what that installs.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INSTALLED = bool(os.environ.get("HAPTIC_TERRAIN_ZIP"))
RESOURCES = ROOT / "build" / "test-resources" / f"{version('bpy')}{'-installed' if INSTALLED else ''}"

for folder in (ROOT, ROOT / "blender_scripts"):
    if str(folder) not in sys.path:
        sys.path.append(str(folder))

from enable_addon import enable, use_resources  # noqa: E402

RESOURCES.mkdir(parents=True, exist_ok=True)
use_resources(RESOURCES)

import bpy  # noqa: E402
from make_sample_grid import make_sample  # noqa: E402

enable()  # tests are made of what it registers, and an installed zip has the native module that they import

from tests.addon.scene import module  # noqa: E402

REAL = ROOT.parent / "shared" / "data" / "mola" / "megt90n000cb.lbl"


@pytest.fixture(autouse=True)
def session() -> Iterator[None]:
    """Start from factory settings with the add-on enabled, and leave no touch behind."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    enable()
    yield
    module("touch.stop").stop_touch()


@pytest.fixture(scope="session")
def sample() -> Path:
    """Give the label of the synthetic planet."""
    label = ROOT / "build" / "sample" / "sample.lbl"
    return label if label.is_file() else make_sample(label.parent)


@pytest.fixture(scope="session")
def mola() -> Path:
    """Give the label of the real planet."""
    if not REAL.is_file():
        pytest.skip("the real MOLA grid is not beside the checkout")
    return REAL
