"""What the figures were measured on."""

from __future__ import annotations

import os
import platform
from pathlib import Path


def processor() -> str:
    """The processor's own name."""
    described = Path("/proc/cpuinfo")
    if described.is_file():
        for line in described.read_text(encoding="utf-8").splitlines():
            field, _colon, name = line.partition(":")
            if field.strip() == "model name":
                return name.strip()
    return platform.machine()


def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 0


def machine_line() -> str:
    """In one line."""
    return f"{processor()}, {cores()} cores, {platform.system().lower()}"


def machine_figures() -> dict[str, str | int]:
    """For a file of figures."""
    return {"cpu": processor(), "cores": cores()}
