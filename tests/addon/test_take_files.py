"""Takes as files, there and back; what is hostile or cut short."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.addon.scene import module
from tests.addon.takes import CELL, about, georeference, same, take

ROOT = Path(__file__).resolve().parents[2]


def csv() -> Any:
    return module("record.files.csv_file")


def npz() -> Any:
    return module("record.files.npz_file")


def geojson() -> Any:
    return module("record.files.geojson_file")


def derived(data: Any) -> Any:
    """Work out what files have beside the ticks; the ground is a plane that falls southward."""
    return module("record.files.derived").derived_columns(data, lambda _east, north: north / 100.0)


def refused(path: Path, words: str, read: Callable[[Path], Any]) -> None:
    """Check that a reader says what is wrong with a file."""
    with pytest.raises(module("formats").FormatError, match=words) as error:
        read(path)
    assert path.name in str(error.value)


@pytest.mark.parametrize("kind", ["csv", "npz"])
def test_a_take_comes_back_to_its_last_bit(kind: str, tmp_path: Path) -> None:
    path = tmp_path / f"take.{kind}"
    twist = np.where(np.arange(5000) % 3 == 0, np.nan, 0.25)
    data = take(5000, twist=twist)
    files = csv() if kind == "csv" else npz()
    getattr(files, f"write_{kind}")(path, data, derived(data))
    found = getattr(files, f"read_{kind}")(path)
    assert same(found.data, data)
    assert found.notes == ()
    assert [thing.name for thing in tmp_path.iterdir()] == [path.name]


numbers = st.floats(allow_nan=False, allow_infinity=False)


@given(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=20))
@settings(max_examples=30, deadline=None)
def test_every_finite_number_comes_back(values: list[tuple[float, float]]) -> None:
    first, second = np.array(values).T
    data = take(len(values), proxy_up=first, force_z=second)
    folder = ROOT / "build" / "test-resources"
    for files, kind in ((csv(), "csv"), (npz(), "npz")):
        path = folder / f"every-number.{kind}"
        getattr(files, f"write_{kind}")(path, data, {})
        assert same(getattr(files, f"read_{kind}")(path).data, data)
        path.unlink()


def test_a_table_names_units_and_frames_and_numpy_reads_it(tmp_path: Path) -> None:
    path = tmp_path / "take.csv"
    data = take(50)
    csv().write_csv(path, data, derived(data))
    head = [line for line in path.read_text().splitlines() if line.startswith("#")]
    for name in (*data.columns, "longitude", "latitude", "ground_elevation"):
        (line,) = [line for line in head if line.startswith(f"# {name}: ")]
        assert "not described" not in line
    table = np.genfromtxt(path, delimiter=",", names=True, skip_header=len(head))
    assert np.array_equal(table["proxy_up"], data.columns["proxy_up"])
    assert table["ground_elevation"] == pytest.approx(np.full(50, -900.0))


def test_an_archive_is_read_by_numpy_without_pickles(tmp_path: Path) -> None:
    path = tmp_path / "take.npz"
    data = take(50)
    npz().write_npz(path, data, derived(data))
    with np.load(path, allow_pickle=False) as found:
        assert np.array_equal(found["proxy_up"], data.columns["proxy_up"])
        assert json.loads(str(found["about"]))["georeference"]["body"] == "Mars"
        assert json.loads(str(found["units"]))["force_x"].startswith("N, workspace")


def test_every_column_that_a_session_gives_has_a_unit() -> None:
    from proxygraph import Ticks

    meanings = module("record.files.columns").MEANINGS
    assert set(Ticks.columns) <= set(meanings)


def test_places_on_the_body_are_those_of_the_georeference() -> None:
    count = 500
    random = np.random.default_rng(3)
    east, north = random.uniform(-2e6, 2e6, count), random.uniform(-2e5, 1e4, count)
    data = take(count, proxy_east=east, proxy_north=north)
    longitude, latitude = module("record.files.derived").longitudes_latitudes(data)
    for tick in range(count):
        place = data.about.georeference.longitude_latitude(east[tick] / CELL, -north[tick] / CELL)
        if place is None:
            assert np.isnan([longitude[tick], latitude[tick]]).all()
        else:
            assert (longitude[tick], latitude[tick]) == pytest.approx(place, abs=1e-9)


def test_places_on_a_projected_map_are_those_of_its_projection() -> None:
    polar = module("formats.projections").PolarStereographic()
    on_it = georeference(projection=polar, first_x=-18e4, first_y=9e4, step_x=1000.0, step_y=1000.0)
    data = take(20, of=about(georeference=on_it, wraps=False))
    longitude, latitude = module("record.files.derived").longitudes_latitudes(data)
    for tick in range(20):
        east, north, _up = data.places[tick]
        assert (longitude[tick], latitude[tick]) == on_it.longitude_latitude(east / CELL, -north / CELL)


def test_what_nobody_can_tell_is_left_empty_in_a_table(tmp_path: Path) -> None:
    path = tmp_path / "take.csv"
    data = take(3, proxy_north=np.array([-9e4, 1e6, -9e4]))
    csv().write_csv(path, data, derived(data))
    lines = path.read_text().splitlines()
    names, row = lines[-4].split(","), lines[-2].split(",")
    assert row[names.index("longitude")] == row[names.index("latitude")] == ""
    assert same(csv().read_csv(path).data, data)


def test_a_table_that_was_cut_short_gives_its_whole_lines_and_tells_the_loss(tmp_path: Path) -> None:
    whole, cut = tmp_path / "whole.csv", tmp_path / "cut.csv"
    data = take(400)
    csv().write_csv(whole, data, derived(data))
    text = whole.read_bytes()
    first = text.index(b"\n12.0,") + 1
    for length in range(first + 200, len(text), 997):
        cut.write_bytes(text[:length])
        found = csv().read_csv(cut)
        lines = text[first:length].count(b"\n")
        assert len(found.data) == lines
        assert same(found.data, replace(data.ticks(slice(0, lines)), about=data.about))
        assert f"the last {400 - lines} of 400 ticks are lost" in found.notes[0]


def test_a_table_without_a_whole_line_is_refused_wherever_it_was_cut(tmp_path: Path) -> None:
    whole, cut = tmp_path / "whole.csv", tmp_path / "cut.csv"
    data = take(3)
    csv().write_csv(whole, data, derived(data))
    text = whole.read_bytes()
    first = text.index(b"\n12.0,") + 1
    for length in (*range(0, first, 61), first, first + 10):
        cut.write_bytes(text[:length])
        refused(cut, "found", csv().read_csv)


def table(path: Path, change: Callable[[str], str]) -> Path:
    """Write a table and change its text."""
    csv().write_csv(path, take(5), {})
    path.write_text(change(path.read_text()))
    return path


@pytest.mark.parametrize(
    ("words", "change"),
    [
        ("first line", lambda text: "x" + text),
        ("numbers", lambda text: text.replace("\n12.001,", "\nabc,")),
        ("column time, tick 2: found nan", lambda text: text.replace("\n12.001,", "\n,")),
        ("numbers", lambda text: text + "1.0\n"),
        ("ticks: found 6", lambda text: text + text.splitlines()[-1] + "\n"),
        ("column time, tick 2", lambda text: text.replace("\n12.001,", "\nnan,")),
        ("column time, tick 2", lambda text: text.replace("\n12.001,", "\n1e400,")),
        ("column time, tick 2", lambda text: text.replace("\n12.001,", "\n11.0,")),
        ("no goal_up", lambda text: text.replace("goal_up", "goal_down")),
        ("names of columns", lambda text: text.replace("goal_north,goal_up", "goal_up,goal_up")),
        ("ticks: found -5", lambda text: text.replace("# ticks: 5", "# ticks: -5")),
        ("ticks: found", lambda text: text.replace("# ticks: 5", "# ticks: " + "9" * 5000)),
        ("head", lambda text: text.replace("# ticks: 5", "# nothing")),
        ("about", lambda text: text.replace('{"terrain"', '{"x": ' + "[" * 5000 + '"terrain"')),
        ("about", lambda text: text.replace('"rows": 180', '"rows": 1')),
        ("about", lambda text: text.replace('"rows": 180', '"rows": 1e999')),
        ("about", lambda text: text.replace('"cell_width": 1000.0', '"cell_width": NaN')),
        ("about", lambda text: text.replace('"workspace_width": 0.16', '"workspace_width": 0')),
        ("about", lambda text: text.replace("longitude and latitude", "no such projection")),
        ("line: found more", lambda text: text + "1" * 100_000),
    ],
)
def test_a_table_that_cannot_be_is_refused(words: str, change: Callable[[str], str], tmp_path: Path) -> None:
    refused(table(tmp_path / "take.csv", change), words, csv().read_csv)


def test_a_table_that_is_no_text_is_refused(tmp_path: Path) -> None:
    path = table(tmp_path / "take.csv", str)
    path.write_bytes(path.read_bytes() + b"\xff\xfe\n")
    refused(path, "UTF-8", csv().read_csv)


def test_columns_that_nobody_knows_are_left_out(tmp_path: Path) -> None:
    data = take(5)
    more = {"position": np.zeros(5), "x" * 500: np.ones(5)}
    csv().write_csv(tmp_path / "take.csv", data, more)
    npz().write_npz(tmp_path / "take.npz", data, more)
    assert same(csv().read_csv(tmp_path / "take.csv").data, data)
    assert same(npz().read_npz(tmp_path / "take.npz").data, data)


def archive(path: Path, **changes: bytes | None) -> Path:
    """Write an archive with some of its members changed, or left out."""
    npz().write_npz(path, take(5), {})
    with zipfile.ZipFile(path) as before:
        members = {name: before.read(name) for name in before.namelist()}
    members.update({f"{name}.npy": content or b"" for name, content in changes.items()})
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as after:
        for name, content in members.items():
            if content:
                after.writestr(name, content)
    return path


def member(values: Any, **options: Any) -> bytes:
    """Make the bytes of an array as numpy writes them."""
    file = io.BytesIO()
    np.lib.format.write_array(file, np.asarray(values), **options)
    return file.getvalue()


def header(shape: str, kind: str = "<f8") -> bytes:
    """Make an array's header without what it tells of."""
    text = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text.encode()


def test_an_archive_that_was_packed_again_is_read(tmp_path: Path) -> None:
    assert same(npz().read_npz(archive(tmp_path / "take.npz")).data, take(5))


@pytest.mark.parametrize(
    ("words", "changes"),
    [
        ("time.npy", {"time": header("(100000000000,)")}),
        ("time.npy", {"time": header("(-5,)")}),
        ("time.npy", {"time": header("(5, 5)") + bytes(200)}),
        ("time.npy", {"time": member(np.arange(5, dtype=np.float32))}),
        ("time.npy", {"time": b"not an array"}),
        ("time.npy", {"time": member(np.array([None] * 5, dtype=object), allow_pickle=True)}),
        ("columns of one length", {"time": member(np.arange(6.0))}),
        ("columns of one length", {"time": member("text")}),
        ("no time", {"time": None}),
        ("about", {"about": None}),
        ("about", {"about": member("{}")}),
        ("about", {"about": member("[]")}),
        ("about", {"about": member(np.arange(5.0))}),
        ("column mode, tick 3", {"mode": member(np.array([0.0, 1.0, 3.0, 0.0, 0.0]))}),
        ("column feature, tick 1", {"feature": member(np.full(5, 0.5))}),
        ("column window_width, tick 1", {"window_width": member(np.zeros(5))}),
    ],
)
def test_an_archive_that_cannot_be_is_refused(
    words: str, changes: dict[str, bytes | None], tmp_path: Path
) -> None:
    refused(archive(tmp_path / "take.npz", **changes), words, npz().read_npz)


def test_an_archive_never_runs_what_it_brings(tmp_path: Path) -> None:
    class Bomb:
        def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
            return Path.touch, (tmp_path / "ran",)

    bomb = member(np.array([Bomb()], dtype=object), allow_pickle=True)
    refused(archive(tmp_path / "take.npz", time=bomb), "time.npy", npz().read_npz)
    assert not (tmp_path / "ran").exists()


def test_an_archive_that_was_cut_or_spoilt_is_refused_or_reads_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "take.npz"
    npz().write_npz(path, take(20), {})
    whole = path.read_bytes()
    random = np.random.default_rng(5)
    for length in range(0, len(whole), 301):
        path.write_bytes(whole[:length])
        refused(path, "archive", npz().read_npz)
    for _ in range(200):
        spoilt = bytearray(whole)
        spoilt[random.integers(len(whole))] ^= 1 << int(random.integers(8))
        path.write_bytes(spoilt)
        try:
            found = npz().read_npz(path)
        except module("formats").FormatError:
            continue
        assert set(found.data.columns) <= set(take(20).columns)


def lines_of(path: Path) -> list[list[list[float]]]:
    lines: list[list[list[float]]] = json.loads(path.read_text())["features"][0]["geometry"]["coordinates"]
    return lines


def test_a_path_is_cut_at_the_antimeridian(tmp_path: Path) -> None:
    path = tmp_path / "take.geojson"
    longitude = np.array([178.0, 179.0, 181.0, 183.0, 180.5, 179.5])
    up = np.array([0.0, 10.0, 30.0, 50.0, 25.0, 15.0])
    data = take(6, proxy_east=(longitude - 0.5) * CELL, proxy_up=up)
    geojson().write_geojson(path, data)
    first, second, third = lines_of(path)
    assert first == [[178.0, -0.5, 0.0], [179.0, -0.5, 10.0], [180.0, -0.5, 20.0]]
    assert second == [
        [-180.0, -0.5, 20.0],
        [-179.0, -0.5, 30.0],
        [-177.0, -0.5, 50.0],
        [-179.5, -0.5, 25.0],
        [-180.0, -0.5, 20.0],
    ]
    assert third == [[180.0, -0.5, 20.0], [179.5, -0.5, 15.0]]
    assert [line.tolist() for line in geojson().read_path(path)] == [first, second, third]


@given(st.lists(st.floats(-60.0, 60.0), min_size=2, max_size=30), st.floats(0.0, 360.0))
@settings(max_examples=100, deadline=None)
def test_no_line_of_a_path_sweeps_around_the_planet(steps: list[float], start: float) -> None:
    longitude = start + np.cumsum(steps)
    data = take(len(steps), proxy_east=longitude * CELL)
    lines = list(geojson().path_lines(data))
    away = 0.0
    for line in lines:
        assert (np.abs(line[:, 0]) <= 180.0).all()
        assert (np.abs(np.diff(line[:, 0])) <= 180.0).all()
        away += np.abs(np.diff(line[:, 0])).sum()
    assert away == pytest.approx(np.abs(np.diff(longitude)).sum(), abs=1e-6)


def test_a_path_names_its_body_and_leaves_out_where_the_hand_rests(tmp_path: Path) -> None:
    path = tmp_path / "take.geojson"
    east = np.array([1.0, 1.0, 2.0, 2.0, 2.0, 3.0]) * CELL
    geojson().write_geojson(path, take(6, proxy_east=east, proxy_up=np.zeros(6)))
    assert [place[0] for place in lines_of(path)[0]] == pytest.approx([1.5, 2.5, 3.5])
    foreign = json.loads(path.read_text())["haptic_terrain"]
    assert foreign["body"] == "Mars"
    assert foreign["ellipsoid_metres"] == {"semi_major": 3396000.0, "semi_minor": 3396000.0}
    assert foreign["latitude"] == "planetocentric"


def test_a_path_has_a_gap_beside_the_map_and_where_time_is_missing(tmp_path: Path) -> None:
    path = tmp_path / "take.geojson"
    north = np.full(9, -9e4)
    north[3] = 1e6
    time = np.arange(9) / 1000.0
    time[6:] += 5.0
    geojson().write_geojson(path, take(9, proxy_north=north, time=time))
    assert [len(line) for line in lines_of(path)] == [3, 2, 3]


def test_a_path_without_a_place_on_its_body_is_not_written(tmp_path: Path) -> None:
    unknown = georeference(projection=module("formats.projections").Unknown())
    with pytest.raises(geojson().NoPlaceError, match=r"mars.img does not tell"):
        geojson().write_geojson(tmp_path / "take.geojson", take(of=about(georeference=unknown)))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{",
        "[" * 100_000,
        '{"features": []}',
        '{"features": [{"geometry": {"type": "Point", "coordinates": [1, 2]}}]}',
        *(
            f'{{"features": [{{"geometry": {{"type": "MultiLineString", "coordinates": {lines}}}}}]}}'
            for lines in (
                "[[[1, 2]]]",
                '[[[1, 2, "x"], [1, 2, 3]]]',
                "[[[1, 2, NaN], [1, 2, 3]]]",
                "[[[1, 2, 3], [1, 2]]]",
                "[7]",
                "null",
            )
        ),
    ],
)
def test_a_path_that_cannot_be_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "take.geojson"
    path.write_text(text)
    refused(path, "found", geojson().read_path)


WITHOUT_BLENDER = """
import sys
for name in ("bpy", "mathutils", "bmesh", "bpy_extras"):
    sys.modules[name] = None
import resource
from pathlib import Path
import addon
from addon.record import keys, merge, reduce, resample, scene_view, take_data, trail_path, tube
from addon.record.files import csv_file, geojson_file, npz_file
from addon.record.files.derived import derived_columns
folder = Path(sys.argv[1])
data = csv_file.read_csv(folder / "take.csv").data
if len(sys.argv) > 2:
    resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[2]), int(sys.argv[2])))
for write in (
    lambda: csv_file.write_csv(folder / "take.csv", data, derived_columns(data)),
    lambda: npz_file.write_npz(folder / "take.npz", data, derived_columns(data)),
    lambda: geojson_file.write_geojson(folder / "take.geojson", data),
):
    try:
        write()
        print("written")
    except OSError as error:
        print(error.strerror)
"""


def run_without_blender(*arguments: str) -> list[str]:
    found_by = os.pathsep.join(filter(None, sys.path))  # also what an installed zip brings
    done = subprocess.run(
        [sys.executable, "-c", WITHOUT_BLENDER, *arguments],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": found_by},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_takes_are_read_and_written_with_bpy_blocked(tmp_path: Path) -> None:
    data = take(2000)
    csv().write_csv(tmp_path / "take.csv", data, {})
    assert run_without_blender(str(tmp_path)) == ["written"] * 3
    assert same(csv().read_csv(tmp_path / "take.csv").data, data)
    assert same(npz().read_npz(tmp_path / "take.npz").data, data)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no limit on the size of files")
def test_a_disk_that_is_full_leaves_nothing_half_written(tmp_path: Path) -> None:
    csv().write_csv(tmp_path / "take.csv", take(2000), {})
    before = (tmp_path / "take.csv").read_bytes()
    assert run_without_blender(str(tmp_path), "20000") == ["File too large"] * 3
    assert [path.name for path in tmp_path.iterdir()] == ["take.csv"]
    assert (tmp_path / "take.csv").read_bytes() == before
