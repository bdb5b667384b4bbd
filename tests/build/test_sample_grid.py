"""The synthetic sample grid: a real MEGDR pair, the same every time, without seam or spike."""

from __future__ import annotations

import hashlib
from pathlib import Path

import make_sample_grid
import numpy as np
import pvl
import pytest
from numpy.typing import NDArray


@pytest.fixture(scope="module")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_sample_grid.make_sample(tmp_path_factory.mktemp("sample"))


@pytest.fixture(scope="module")
def elevation(sample: Path) -> NDArray[np.int32]:
    raw = np.fromfile(sample.with_suffix(".img"), dtype=">i2")
    return raw.astype(np.int32).reshape(make_sample_grid.ROWS, make_sample_grid.COLUMNS)


def test_bytes_are_the_same_on_every_run_and_numpy(sample: Path, tmp_path: Path) -> None:
    again = make_sample_grid.make_sample(tmp_path)
    for suffix in (".lbl", ".img"):
        assert sample.with_suffix(suffix).read_bytes() == again.with_suffix(suffix).read_bytes()
    # Bench figures and the demo's exact values rest on these heights.
    digest = hashlib.sha256(sample.with_suffix(".img").read_bytes()).hexdigest()
    assert digest == "7cef43f7276dcd3079d17712c29199e9a506daae7975baffff95f46f9ed1ac87"


def test_label_describes_the_image_and_says_that_it_is_synthetic(sample: Path) -> None:
    label = pvl.load(sample)
    image = label["IMAGE"]
    assert (image["LINES"], image["LINE_SAMPLES"]) == (720, 1440)
    assert (image["SAMPLE_TYPE"], image["SAMPLE_BITS"]) == ("MSB_INTEGER", 16)
    assert label["RECORD_BYTES"] * label["FILE_RECORDS"] == sample.with_suffix(".img").stat().st_size
    assert label["^IMAGE"] == "SAMPLE.IMG"
    assert label["IMAGE_MAP_PROJECTION"]["MAP_RESOLUTION"].value == 4.0
    assert "SYNTHETIC" in label["PRODUCT_ID"]
    assert b"SYNTHETIC TERRAIN" in sample.read_bytes()


def test_east_meets_west_without_a_seam(elevation: NDArray[np.int32]) -> None:
    steps = np.abs(np.diff(elevation, axis=1)).mean(axis=0)
    seam = np.abs(elevation[:, 0] - elevation[:, -1]).mean()
    assert seam < np.quantile(steps, 0.95)


def test_poles_are_nearly_level_rings(elevation: NDArray[np.int32]) -> None:
    # The first and last rows lie within an eighth of a degree, 7 km, of a pole.
    for ring in (elevation[0], elevation[-1]):
        assert np.ptp(ring) < 600


def test_landforms_stand_out(elevation: NDArray[np.int32]) -> None:
    def at(latitude: float, longitude: float) -> int:
        return int(elevation[int((90.0 - latitude) * 4.0), int(longitude * 4.0)])

    assert elevation.max() > 15_000, "the highest volcano"
    assert -12_000 < elevation.min() < -6_000
    assert np.median(elevation[540:660]) - np.median(elevation[60:180]) > 3_000, "south above north"
    assert at(-43.0, 262.0) < -4_000, "the great basin"
    summit = elevation[270:310, 430:470]
    assert summit[summit.shape[0] // 2 - 4 : summit.shape[0] // 2 + 4].max() > 14_000


def test_wrong_folder_is_one_line_and_no_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("in the way")
    assert make_sample_grid.main(["--output", str(blocked)]) == 1
    complaint = capsys.readouterr().err
    assert complaint.count("\n") == 1
    assert "cannot be written" in complaint
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_wrong_option_is_wrong_usage(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        make_sample_grid.main(["--colour", "red"])
    assert ended.value.code == 2
    assert "--colour" in capsys.readouterr().err
