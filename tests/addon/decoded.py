"""Grids that must be decoded, made of such as could be mapped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from proxygraph import Grid

from tests.addon.scene import module

Decoder = Callable[..., Grid]


def copying(path: Path, layout: Any, _decoding: Any, progress: Any) -> Grid:
    """Decode by copying the file."""
    if progress is not None:
        progress.step(1, 1)
    return Grid.from_buffer(path.read_bytes()[: layout.byte_length], layout)


def decode_everything(monkeypatch: pytest.MonkeyPatch, decoder: Decoder = copying) -> list[Path]:
    """Let every grid that is imported need a decoder; gives the files that it was called for."""
    decoding, calls = module("formats.decoding"), []

    def noted(path: Path, *arguments: Any) -> Grid:
        calls.append(path)
        return decoder(path, *arguments)

    def read(path: Path, *_arguments: object) -> Any:
        return replace(module("formats").read_grid(path), decoding=decoding.Decoding("test"))

    monkeypatch.setitem(module("formats.decoders").DECODERS, "test", noted)
    monkeypatch.setattr(module("terrain.prepare"), "read_grid", read)
    return calls
