"""Knowing a file again."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from addon.formats import FormatError, source_stamp
from addon.formats.source_stamp import SourceStamp


def written(tmp_path: Path, data: bytes) -> Path:
    path = tmp_path / "grid.img"
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("size", [0, 1, 4096, 5_000, 400_000])
def test_a_file_is_known_again_by_its_content(tmp_path: Path, size: int) -> None:
    path = written(tmp_path, bytes(range(256)) * (size // 256) + bytes(size % 256))
    stamp = SourceStamp.of(path)
    os.utime(path, ns=(1, 1))  # as a copy has it
    assert stamp.is_of(path)
    stamp.check(path)


@pytest.mark.parametrize("place", [0, 4_999])
def test_another_content_of_the_same_length_is_refused(tmp_path: Path, place: int) -> None:
    data = bytearray(5_000)
    stamp = SourceStamp.of(written(tmp_path, bytes(data)))
    data[place] = 1
    path = written(tmp_path, bytes(data))
    os.utime(path, ns=(1, 1))
    with pytest.raises(FormatError, match=r"5,000 bytes.*import the grid again"):
        stamp.check(path)


def test_a_change_anywhere_in_a_large_file_is_seen(tmp_path: Path) -> None:
    data = bytearray(2_073_600)
    stamp = SourceStamp.of(written(tmp_path, bytes(data)))
    data[40_000:64_000] = bytes(range(1, 241)) * 100
    path = written(tmp_path, bytes(data))
    os.utime(path, ns=(1, 1))
    with pytest.raises(FormatError, match=r"another content.*import the grid again"):
        stamp.check(path)


def test_a_file_too_long_to_compare_is_known_by_its_time_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_stamp, "MOST_HASHED", 99)
    path = written(tmp_path, bytes(100))
    stamp = SourceStamp.of(path)
    stamp.check(path)
    os.utime(path, ns=(1, 1))
    with pytest.raises(FormatError, match=r"another time of change.*too long to compare: import the grid"):
        stamp.check(path)


def test_another_length_is_refused_whatever_the_time_says(tmp_path: Path) -> None:
    path = written(tmp_path, bytes(100))
    stamp, status = SourceStamp.of(path), path.stat()
    path.write_bytes(bytes(101))
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
    with pytest.raises(FormatError, match=r"found .*101 bytes.*expected .*100 bytes"):
        stamp.check(path)


def test_a_file_that_is_gone_is_left_to_whoever_opens_it(tmp_path: Path) -> None:
    path = written(tmp_path, b"1")
    stamp = SourceStamp.of(path)
    path.unlink()
    stamp.check(path)
