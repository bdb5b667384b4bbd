"""What a bug report needs to know of this machine and session, in words that name no person and no file."""

from __future__ import annotations

import platform
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import bpy
import numpy as np
import proxygraph

from ..devices.attached import attached, problems
from ..restart import own_version
from ..terrain.byte_size import in_bytes
from ..terrain.kept import KeptError, is_terrain, recall
from ..touch.live import Touch, live

QUANTILES = (0.5, 0.9, 0.99, 0.999, 1.0)
"""Of the servo's histograms."""

BUNDLED = ("hidapi", "pyusb", "libusb-package", "pvl")


def diagnostics() -> str:
    """Everything, line by line."""
    text = "\n".join([*_versions(), "", *_devices(), "", *_terrains(), "", *_servo()])
    return text.replace(str(Path.home()), "~")  # what a library says of itself may have a path in it


def _versions() -> Iterator[str]:
    build = bpy.app.build_hash.decode(errors="replace")
    yield f"Haptic Terrain {own_version()}, proxygraph {proxygraph.__version__}"
    yield f"Blender {bpy.app.version_string} ({build}){', in the background' if bpy.app.background else ''}"
    yield f"Python {platform.python_version()}, numpy {np.__version__}"
    yield f"{platform.system()} {platform.release()}, {platform.machine()}"
    yield ", ".join(f"{name} {_version(name)}" for name in BUNDLED)


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "missing"


def _devices() -> Iterator[str]:
    found = [*map(str, attached()), *problems()]
    yield "Devices of known makers:"
    yield from (f"  {line}" for line in found or ["none"])


def _terrains() -> Iterator[str]:
    yield "Terrains:"
    for terrain in filter(is_terrain, bpy.data.objects):
        try:
            kept = recall(terrain)
        except KeptError as error:
            yield f"  unreadable ({type(error.__cause__).__name__})"
            continue
        layout = kept.grid.layout
        shown = len(terrain.data.vertices) if isinstance(terrain.data, bpy.types.Mesh) else 0
        yield (
            f"  {kept.grid.format}, {layout.columns} x {layout.rows} {layout.sample}, "
            f"{in_bytes(layout.byte_length)}, {shown} vertices shown"
            f"{'' if kept.grid.decoding is None else ', decoded'}{', filled' if kept.filled else ''}"
        )


def _servo() -> Iterator[str]:
    if live.touch is None:
        yield "Touch is not running: start it before, so that its timing is in the report."
        return
    yield from _session(live.touch)


def _session(touch: Touch) -> Iterator[str]:
    session, statistics = touch.session, touch.session.statistics()
    hand = "simulated" if touch.is_simulated else "another"
    yield f"Touch: {session.model}, {hand} hand, {session.priority}"
    for name in ("ticks", "missed_ticks", "device_errors", "speed_cuts", "host_cuts", "late_cuts", "dropped"):
        yield f"  {name}: {getattr(statistics, name)}"
    yield f"  {'share of ticks up to':24}" + "".join(f"{share:>10.1%}" for share in QUANTILES)
    for name, at, unit in (
        ("late_us", statistics.late_us, 1.0),
        ("update_us", statistics.update_us, 1.0),
        ("load_percent", statistics.load, 100.0),
    ):
        yield f"  {name:24}" + "".join(f"{at(share) * unit:>10.1f}" for share in QUANTILES)
    yield from (f"  {warning}" for warning in session.warnings())
