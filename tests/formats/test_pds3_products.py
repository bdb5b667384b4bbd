"""Kinds of PDS3 images: samples, values, labels inside the data."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from addon.formats import read_grid
from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.reading import complaint, heights, needs_raw_decoder


def attached(pair: MegdrPair, folder: Path, record: int = 8, *, name: str = "grid.img") -> Path:
    """Write label and data as one file: the image begins at a record of 512 bytes, from 1."""
    header = {**pair.header, "RECORD_BYTES": 512, "^IMAGE": record}
    text = replace(pair, header=header).label().encode().ljust(512 * (record - 1))
    path = folder / name
    path.write_bytes(text + pair.data())
    return path


def test_a_label_at_the_head_of_its_data(tmp_path: Path) -> None:
    pair = MegdrPair(rough(4, 6))
    grid = read_grid(attached(pair, tmp_path))
    assert heights(grid) == pair.heights
    assert grid.path == grid.data_path
    assert grid.decoding is None


def test_a_place_in_bytes_in_the_same_file(tmp_path: Path) -> None:
    pair = replace(MegdrPair(rough(4, 6)), header={"^IMAGE": "4097 <BYTES>"})
    path = tmp_path / "GRID.IMG"
    path.write_bytes(pair.label().encode().ljust(4096, b"\0") + pair.data())
    assert heights(read_grid(path)) == pair.heights


def test_data_after_the_label_may_look_like_more_of_it(tmp_path: Path) -> None:
    path = attached(MegdrPair(rough(4, 6)), tmp_path)
    with path.open("ab") as file:
        file.write(b"\r\nLINES = (((((\r\n" * 9000)
    assert read_grid(path).samples == 24


def test_an_image_beyond_the_end_of_the_file(tmp_path: Path) -> None:
    path = attached(MegdrPair(rough(4, 6)), tmp_path)
    path.write_bytes(path.read_bytes().replace(b"^IMAGE = 8", b"^IMAGE = 9"))
    assert "length: found 3,632 bytes, expected 4,144 bytes" in complaint(path)


@pytest.mark.parametrize("length", range(1, 1300, 43))
def test_an_attached_label_cut_anywhere(tmp_path: Path, length: int) -> None:
    path = attached(MegdrPair(rough(4, 6)), tmp_path)
    path.write_bytes(path.read_bytes()[:length])
    assert "grid.img" in complaint(path)


@pytest.mark.parametrize(
    ("sample_type", "bits", "sample"),
    [
        ("IEEE_REAL", 32, ">f"),
        ("FLOAT", 32, ">f"),
        ("PC_REAL", 32, "<f"),
        ("IEEE_REAL", 64, ">d"),
        ("PC_REAL", 64, "<d"),
        ("MSB_INTEGER", 32, ">i"),
        ("VAX_INTEGER", 16, "<h"),
        ("PC_INTEGER", 32, "<i"),
        ("SUN_INTEGER", 16, ">h"),
        ("INTEGER", 16, ">h"),
        ("UNSIGNED INTEGER", 16, ">H"),
    ],
)
def test_sample_types_are_mapped(tmp_path: Path, sample_type: str, bits: int, sample: str) -> None:
    image = {"SAMPLE_TYPE": f'"{sample_type}"', "SAMPLE_BITS": bits}
    grid = read_grid(MegdrPair([[1, 2], [3, 4]], image=image, sample=sample).write(tmp_path))
    assert heights(grid) == [[1, 2], [3, 4]]
    assert grid.decoding is None


@pytest.mark.parametrize(
    ("sample_type", "bits", "sample"),
    [("MSB_INTEGER", 8, "b"), ("UNSIGNED_INTEGER", 8, "B"), ("LSB_UNSIGNED_INTEGER", 32, "<I")],
)
@needs_raw_decoder
def test_other_sample_types_are_decoded(tmp_path: Path, sample_type: str, bits: int, sample: str) -> None:
    image = {"SAMPLE_TYPE": sample_type, "SAMPLE_BITS": bits}
    grid = read_grid(MegdrPair([[1, 2], [3, 4]], image=image, sample=sample).write(tmp_path))
    assert heights(grid) == [[1, 2], [3, 4]]


@pytest.mark.parametrize("storage", ["BAND_SEQUENTIAL", "LINE_INTERLEAVED"])
def test_the_first_of_several_bands_is_mapped(tmp_path: Path, storage: str) -> None:
    first, second = rough(2, 3), rough(4, 3)[2:]
    rows = [first[0], second[0], first[1], second[1]] if storage == "LINE_INTERLEAVED" else [*first, *second]
    label = MegdrPair(first, image={"BANDS": 2, "BAND_STORAGE_TYPE": storage}).write(tmp_path)
    label.with_suffix(".img").write_bytes(MegdrPair(rows).data())
    grid = read_grid(label)
    assert heights(grid) == first
    assert "2 bands" in " ".join(grid.notes)


def lola(**image: object) -> MegdrPair:
    """A LOLA map: DN of half metres; OFFSET is the radius of the Moon's sphere."""
    return MegdrPair(
        [[-100, 101], [3, -4]],
        header={"TARGET_NAME": "MOON", "DATA_SET_ID": '"LRO-L-LOLA-4-GDR-V1.0"', "INSTRUMENT_ID": '"LOLA"'},
        image={
            "NAME": "HEIGHT",
            "SAMPLE_TYPE": "LSB_INTEGER",
            "SCALING_FACTOR": 0.5,
            "OFFSET": "1737400.",
            "UNIT": "METER",
            **image,
        },
        projection={"A_AXIS_RADIUS": "1737.4 <km>"},
        sample="<h",
    )


def test_lola_heights_are_above_the_sphere(tmp_path: Path) -> None:
    """ "HEIGHT = (DN * SCALING_FACTOR)", say its labels."""
    grid = read_grid(lola().write(tmp_path))
    assert heights(grid) == [[-50, 50.5], [1.5, -2]]
    place = grid.georeference
    assert (place.body, place.vertical_reference) == ("Moon", "sphere of 1,737.4 km")
    assert grid.format == "LOLA (PDS3)"
    assert "OFFSET" in " ".join(grid.notes)


def test_lola_in_kilometres(tmp_path: Path) -> None:
    image = {
        "SAMPLE_TYPE": "PC_REAL",
        "SAMPLE_BITS": 32,
        "UNIT": "KILOMETER",
        "SCALING_FACTOR": 1,
        "OFFSET": 1737.4,
    }
    pair = replace(lola(**image), heights=[[-1.5, 2.25], [0, 1]], sample="<f")  # type: ignore[list-item]
    grid = read_grid(pair.write(tmp_path))
    assert heights(grid) == [[-1500, 2250], [0, 1000]]
    assert grid.georeference.vertical_unit == "km"
    assert grid.georeference.vertical_reference == "sphere of 1,737.4 km"


@pytest.mark.parametrize("name", ["PLANETARY_RADIUS", "MEAN_SHAPE", "AREOID"])
def test_radii_keep_their_offset(tmp_path: Path, name: str) -> None:
    grid = read_grid(lola(NAME=name).write(tmp_path))
    assert heights(grid)[0] == [1_737_350, 1_737_450.5]
    assert grid.georeference.vertical_reference == "centre of the body"


def test_counts_are_no_elevations_and_say_so(tmp_path: Path) -> None:
    image = {"NAME": "COUNTS_PER_BIN", "UNIT": "'N/A'"}
    grid = read_grid(MegdrPair([[0, 7], [1, 2]], image=image).write(tmp_path))
    assert heights(grid) == [[0, 7], [1, 2]]
    assert "counts, not elevations" in grid.title
    assert "not elevations" in " ".join(grid.notes)


def test_an_image_of_the_older_record_at_32_pixels_a_degree(tmp_path: Path) -> None:
    """IEG0031T: data set MGS-M-MOLA-5-IEGDR-L3-V2.0, 16-bit signed."""
    pair = MegdrPair(
        rough(32, 64),
        pixels_per_degree=32.0,
        header={"DATA_SET_ID": '"MGS-M-MOLA-5-IEGDR-L3-V2.0"'},
        name="ieg0031t",
    )
    grid = read_grid(pair.write(tmp_path))
    assert heights(grid) == pair.heights
    assert grid.georeference.step_x == 1.0 / 32.0
    assert grid.format == "MOLA (PDS3)"


@pytest.mark.parametrize("written", ["16#FF7FFFFB#", "-3.40282265508890445e+38"])
def test_a_void_of_real_numbers(tmp_path: Path, written: str) -> None:
    image = {"SAMPLE_TYPE": "PC_REAL", "SAMPLE_BITS": 32, "MISSING_CONSTANT": written}
    rows = [[1, -3.4028226550889045e38], [3, 4]]
    grid = read_grid(MegdrPair(rows, image=image, sample="<f").write(tmp_path))  # type: ignore[arg-type]
    assert heights(grid) == [[1, None], [3, 4]]


@pytest.mark.parametrize("written", ["16#8000#", "16#FFFF8000#", '"16#8000#"', "-32768", "32768"])
def test_a_void_of_whole_numbers_written_as_bits(tmp_path: Path, written: str) -> None:
    pair = MegdrPair([[1, -32768], [3, 4]], image={"MISSING_CONSTANT": written})
    assert heights(read_grid(pair.write(tmp_path))) == [[1, None], [3, 4]]


def test_the_bits_of_a_double(tmp_path: Path) -> None:
    image = {"SAMPLE_TYPE": "IEEE_REAL", "SAMPLE_BITS": 64, "MISSING_CONSTANT": "16#FFEFFFFFFFFFFFFB#"}
    rows = [[1, -1.7976931348623149e308], [3, 4]]
    grid = read_grid(MegdrPair(rows, image=image, sample=">d").write(tmp_path))  # type: ignore[arg-type]
    assert heights(grid) == [[1, None], [3, 4]]


@pytest.mark.parametrize(
    ("written", "named"),
    [
        ("16#18000#", "16#18000#"),
        ('"16#18000#"', "16#18000#"),
        (f"16#{'F' * 5000}#", "300 digits"),
        (f'"16#{"F" * 5000}#"', "16#FFFF"),
    ],
)
def test_bits_that_no_sample_has_are_refused(tmp_path: Path, written: str, named: str) -> None:
    pair = MegdrPair([[1, 2], [3, 4]], image={"MISSING_CONSTANT": written})
    text = complaint(pair.write(tmp_path))
    for word in ("MISSING_CONSTANT", named):
        assert word in text


@pytest.mark.parametrize("value", ["'N/A'", '"UNK"', "NULL"])
def test_a_void_that_is_not_applicable(tmp_path: Path, value: str) -> None:
    pair = MegdrPair([[1, 2], [3, 4]], image={"MISSING_CONSTANT": value})
    assert read_grid(pair.write(tmp_path)).layout.void is None


def test_a_label_of_a_packed_picture_names_the_way_out(tmp_path: Path) -> None:
    label = MegdrPair(rough(2, 3)).write(tmp_path)
    label.with_suffix(".img").write_bytes(b"\x00\x00\x00\x0cjP  \r\n\x87\n" * 9)
    text = complaint(label)
    assert "a JPEG 2000 file" in text
    assert ".IMG" in text


def test_a_description_inside_one_of_several_files(tmp_path: Path) -> None:
    pair = MegdrPair(rough(2, 3))
    label = pair.write(tmp_path)
    text = label.read_text()
    pointer = '^IMAGE = "GRID.IMG"\n'
    start, end = text.index("OBJECT = IMAGE\n"), text.index("OBJECT = IMAGE_MAP")
    inside = f"OBJECT = UNCOMPRESSED_FILE\n{pointer}{text[start:end]}END_OBJECT = UNCOMPRESSED_FILE\n"
    label.write_text(text[:start].replace(pointer, "") + inside + text[end:])
    assert heights(read_grid(label)) == pair.heights
