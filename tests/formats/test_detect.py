"""What a file is, by its content."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import SUFFIXES, read_grid
from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.raw_grids import EhdrPair, EnviPair, GridFloatPair, Pds4Pair
from tests.formats.reading import SHARED, complaint, needs

A_RECORD = (
    b"TEST DEM".ljust(144)
    + b"     1     1     1    10"
    + b"  0.0".ljust(360)
    + b"     2     2     4"
    + b" 0.5D+01" * 40
)

THINGS = [
    (b"<!DOCTYPE html>\n<html>", "an HTML page"),
    (b"\n\n<HTML><HEAD>", "an HTML page"),
    (b"\xef\xbb\xbf<html lang='en'>", "an HTML page"),
    (b"\x89PNG\r\n\x1a\n\0\0", "a PNG picture"),
    (b"\xff\xd8\xff\xe0\0\x10JFIF", "a JPEG picture"),
    (b"GIF89a", "a GIF picture"),
    (b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "a Radiance picture"),
    (b"PK\x03\x04", "unpack"),
    (b"\x1f\x8b\x08", "unpack"),
    (b"BZh9", "unpack"),
    (b"7z\xbc\xaf\x27\x1c", "unpack"),
    (b"%PDF-1.7", "a PDF document"),
    (b"BLENDER-v402", "a Blender file"),
    (b"<?xml version='1.0'?><gpx/>", "an XML file"),
    (b"", "no bytes"),
]


@pytest.mark.parametrize(("content", "word"), THINGS)
@pytest.mark.parametrize(
    "name", ["grid.img", "grid.hdr", "grid.dem", "grid.lbl", "grid.xml", "N10E020.hgt", "grid"]
)
def test_what_is_no_grid_is_named_whatever_it_is_called(
    tmp_path: Path, content: bytes, word: str, name: str
) -> None:
    (tmp_path / name).write_bytes(content)
    text = complaint(tmp_path / name)
    assert text.startswith(f"{name}: ")
    assert word.lower() in text.lower()


@pytest.mark.parametrize(
    ("content", "word"),
    [
        (b"II*\0\x08\0\0\0", "TIFF"),
        (b"MM\0*\0\0\0\x08", "TIFF"),
        (b"II+\0\x08\0\0\0", "TIFF"),
        (A_RECORD, "USGS DEM"),
    ],
)
@pytest.mark.parametrize("name", ["grid.dem", "grid.txt", "grid.img", "grid.tif"])
def test_formats_are_known_whatever_they_are_called(
    tmp_path: Path, content: bytes, word: str, name: str
) -> None:
    (tmp_path / name).write_bytes(content)
    assert word in complaint(tmp_path / name)


@pytest.mark.parametrize("name", ["grid.dem", "grid.txt", "grid.img", "grid.hdr"])
def test_text_of_heights_is_no_header(tmp_path: Path, name: str) -> None:
    """Esri ASCII begins as GridFloat's header does."""
    text = "ncols 4\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 4\n5 6 7 8\n"
    (tmp_path / name).write_text(text)
    assert read_grid(tmp_path / name).format == "Esri ASCII"


def test_a_header_tells_its_kind_by_its_content(tmp_path: Path) -> None:
    """Four formats end in .hdr."""
    writers = {"GTOPO30": EhdrPair().write, "GridFloat": GridFloatPair().write, "ENVI": EnviPair().write}
    for expected, write in writers.items():
        folder = tmp_path / expected
        folder.mkdir()
        assert read_grid(write(folder)).format == expected
    (tmp_path / "picture.hdr").write_bytes(b"#?RADIANCE\n")
    assert "Radiance" in complaint(tmp_path / "picture.hdr")


def test_a_header_with_another_ending_is_still_one(tmp_path: Path) -> None:
    header = GridFloatPair().write(tmp_path)
    assert read_grid(header.rename(tmp_path / "grid.txt")).format == "GridFloat"


def test_the_label_is_preferred_to_other_headers(tmp_path: Path) -> None:
    """MOLA's archive has headers for ENVI beside its labels."""
    MegdrPair(rough(2, 3)).write(tmp_path)
    EnviPair(names=("grid.hdr", "unused.dat")).write(tmp_path)
    assert read_grid(tmp_path / "grid.img").format == "MOLA (PDS3)"


@pytest.mark.parametrize("name", ["a b.lbl", "Höhen 高さ.lbl", f"{'g' * 200}.lbl"])
def test_names_with_spaces_and_of_any_script(tmp_path: Path, name: str) -> None:
    folder = tmp_path / "with space" / "ü" / ("d" * 100)
    folder.mkdir(parents=True)
    label = MegdrPair(rough(2, 3)).write(folder)
    label.with_suffix(".img").rename((folder / name).with_suffix(".img"))
    assert read_grid(label.rename(folder / name)).samples == 6


@pytest.mark.parametrize(
    "pair", [EhdrPair(), GridFloatPair(), EnviPair(), Pds4Pair(), MegdrPair(rough(2, 3))]
)
def test_a_file_that_may_not_be_read(tmp_path: Path, pair: EhdrPair, monkeypatch: pytest.MonkeyPatch) -> None:
    header = pair.write(tmp_path)

    def denied(*_arguments: object, **_options: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", denied)
    text = complaint(header)
    assert "Permission denied" in text
    assert "permissions" in text


def test_a_folder(tmp_path: Path) -> None:
    assert "found a folder" in complaint(tmp_path)


def test_bytes_without_a_header_say_what_is_missing(tmp_path: Path) -> None:
    (tmp_path / "grid.img").write_bytes(bytes(range(1, 100)) * 3)
    text = complaint(tmp_path / "grid.img")
    for word in ("grid.lbl", "grid.xml", "grid.hdr", "297 bytes", "rasterio"):
        assert word in text


def test_a_label_without_its_data(tmp_path: Path) -> None:
    label = Pds4Pair().write(tmp_path)
    label.with_suffix(".img").unlink()
    assert "no file grid.img beside the label" in complaint(label)


def test_file_browsers_show_every_format() -> None:
    assert {".lbl", ".img", ".xml", ".hdr", ".dem", ".bil", ".flt", ".hgt", ".tif", ".asc"} <= set(SUFFIXES)


@needs("usgs_dem/SainteHelens.dem")
def test_a_real_usgs_dem_is_known() -> None:
    grid = read_grid(SHARED / "usgs_dem" / "SainteHelens.dem")
    found = grid.open().range()
    assert found is not None
    assert (found.minimum, found.maximum) == (682.0, 2543.0)
