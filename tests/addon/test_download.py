"""Fetching MOLA grids: from a server that helps, from ones that do not, and from ones that mean harm."""

from __future__ import annotations

import hashlib
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from proxygraph import CancelledError

from tests.addon.scene import contents, module
from tests.addon.status_bar import said
from tests.addon.test_import_job import SHOWING, Window, run_until_done
from tests.addon.web_server import Site, served
from tests.formats.megdr_pair import MegdrPair, rough

LABEL, IMAGE = "/meg001/megt90n000xb.lbl", "/meg001/megt90n000xb.img"


@pytest.fixture
def pair(tmp_path: Path) -> dict[str, bytes]:
    """Give label and image of a whole planet at one pixel per degree, under their paths on the server."""
    folder = tmp_path / "server"
    folder.mkdir()
    label = MegdrPair(rough(180, 360), north=90.0, west=0.0, name="megt90n000xb").write(folder)
    return {LABEL: label.read_bytes(), IMAGE: label.with_suffix(".img").read_bytes()}


@pytest.fixture
def site(pair: dict[str, bytes]) -> Iterator[Site]:
    with served(Site(pair)) as site:
        yield site


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "mola"


def product(pair: dict[str, bytes], *, checksum: bool = True) -> Any:
    """Give what the server has, as the extension would know it."""
    sha256 = hashlib.sha256(pair[IMAGE]).hexdigest() if checksum else None
    return module("terrain.megdr").Megdr(1, "meg001", "megt90n000xb", sha256)


def fetch(site: Site, folder: Path, *, checksum: bool = True) -> Path:
    """Fetch both files from the server."""
    work = module("terrain.work").Work()
    label: Path = module("terrain.megdr").fetch_megdr(
        product(site.files, checksum=checksum), site.address, folder, work
    )
    return label


def refused(site: Site, folder: Path, **how: bool) -> str:
    """Fetch what cannot be fetched; gives the message."""
    with pytest.raises(module("terrain.download").DownloadError) as error:
        fetch(site, folder, **how)
    return str(error.value)


def test_label_and_samples_are_fetched_as_they_are(site: Site, folder: Path) -> None:
    label = fetch(site, folder)
    assert label.read_bytes() == site.files[LABEL]
    assert label.with_suffix(".img").read_bytes() == site.files[IMAGE]
    assert len(list(folder.iterdir())) == 2, "nothing else is left"


def test_what_is_there_is_not_fetched_again(site: Site, folder: Path) -> None:
    fetch(site, folder)
    asked = list(site.asked)
    fetch(site, folder)
    assert site.asked == asked


@pytest.mark.parametrize("checksum", [True, False])
def test_a_cut_download_goes_on_where_it_stopped(site: Site, folder: Path, checksum: bool) -> None:
    site.cuts_after = 50_000
    message = refused(site, folder, checksum=checksum)
    assert "50,000 of 129,600 bytes" in message
    assert "Try again" in message
    assert not (folder / "megt90n000xb.img").exists()
    site.cuts_after = None
    image = fetch(site, folder, checksum=checksum).with_suffix(".img")
    assert image.read_bytes() == site.files[IMAGE]
    assert site.asked[-1] == (IMAGE, "bytes=50000-")


def test_a_server_that_knows_no_ranges_sends_all_of_it_again(site: Site, folder: Path) -> None:
    site.cuts_after = 50_000
    refused(site, folder)
    site.cuts_after, site.honours_range = None, False
    assert fetch(site, folder).with_suffix(".img").read_bytes() == site.files[IMAGE]


def test_a_file_that_has_changed_meanwhile_is_begun_anew(site: Site, folder: Path) -> None:
    site.cuts_after = 50_000
    refused(site, folder, checksum=False)
    site.cuts_after, site.tag = None, '"second"'
    site.files[IMAGE] = bytes(reversed(site.files[IMAGE]))
    assert fetch(site, folder, checksum=False).with_suffix(".img").read_bytes() == site.files[IMAGE]


def test_another_part_than_was_asked_for_is_refused(site: Site, folder: Path) -> None:
    site.cuts_after = 50_000
    refused(site, folder)
    site.cuts_after, site.begins_at = None, 7
    assert "another part" in refused(site, folder)
    site.begins_at = None
    assert fetch(site, folder).with_suffix(".img").read_bytes() == site.files[IMAGE]


@pytest.mark.parametrize("size", [129_598, 129_602, 10**12])
def test_a_stated_length_that_is_not_the_grid_s_is_refused_at_once(
    site: Site, folder: Path, size: int
) -> None:
    site.states = lambda length: size if length == 129_600 else length
    assert f"{size:,} bytes, expected 129,600" in refused(site, folder)
    assert not (folder / "megt90n000xb.img").exists()


def test_a_body_that_never_ends_is_cut_off(site: Site, folder: Path) -> None:
    site.files[LABEL] = b" " * 1_000_000
    assert "at most 65,536" in refused(site, folder)
    assert sum(file.stat().st_size for file in folder.iterdir()) <= 65_536 + 100


def test_another_image_of_the_same_size_is_found_out_and_removed(
    site: Site, folder: Path, pair: dict[str, bytes]
) -> None:
    wanted = product(pair)
    site.files = {**pair, IMAGE: bytes(129_600)}
    work = module("terrain.work").Work()
    with pytest.raises(module("terrain.download").DownloadError, match="SHA-256"):
        module("terrain.megdr").fetch_megdr(wanted, site.address, folder, work)
    assert [file.name for file in folder.iterdir()] == ["megt90n000xb.lbl"]


def test_a_missing_file_is_named(site: Site, folder: Path) -> None:
    del site.files[IMAGE]
    message = refused(site, folder, checksum=False)
    assert f"{site.address}{IMAGE}" in message
    assert "404" in message


def test_redirects_are_followed(site: Site, folder: Path) -> None:
    site.files["/elsewhere.img"] = site.files[IMAGE]
    site.redirects[IMAGE] = f"{site.address}/elsewhere.img"
    assert fetch(site, folder).with_suffix(".img").read_bytes() == site.files[IMAGE]


@pytest.mark.parametrize("target", ["file:///etc/hostname", "ftp://127.0.0.1/file", "data:,hello"])
def test_redirects_lead_to_the_web_only(site: Site, folder: Path, target: str) -> None:
    site.redirects[IMAGE] = target
    assert "edirect" in refused(site, folder)
    assert not (folder / "megt90n000xb.img").exists()


def test_a_redirect_that_goes_round_ends(site: Site, folder: Path) -> None:
    site.redirects[IMAGE] = f"{site.address}{IMAGE}"
    assert "redirect" in refused(site, folder)


@pytest.mark.parametrize(
    "address", ["", "file:///tmp", "/tmp", "ftp://127.0.0.1", "https://", "http://a b/", "http://[x"]
)
def test_only_web_addresses_are_asked(site: Site, folder: Path, address: str) -> None:
    site.address = address
    assert "no address" in refused(site, folder)


def test_a_server_that_is_not_there_is_told(site: Site, folder: Path) -> None:
    site.address = "http://127.0.0.1:1"
    assert "was not fetched" in refused(site, folder)


def test_a_silent_server_is_given_up(site: Site, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module("terrain.download"), "TIMEOUT_SECONDS", 0.2)
    site.gate = threading.Event()
    assert "silent" in refused(site, folder)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (b"<html>Not found</html>", "label"),
        (b"", "label"),
        (b"PDS_VERSION_ID = PDS3\nEND\n", "megt90n000xb.lbl"),
    ],
)
def test_a_label_that_is_none_is_removed(site: Site, folder: Path, text: bytes, words: str) -> None:
    whole, site.files[LABEL] = site.files[LABEL], text
    assert words in refused(site, folder)
    assert not (folder / "megt90n000xb.lbl").exists()
    site.files[LABEL] = whole
    assert fetch(site, folder).is_file()


@pytest.mark.parametrize("pointer", [b"../../secret.img", b"/etc/passwd", b"other.img"])
def test_a_label_cannot_point_elsewhere(site: Site, folder: Path, pointer: bytes) -> None:
    (folder).mkdir()
    (folder / "other.img").write_bytes(bytes(129_600))
    site.files[LABEL] = site.files[LABEL].replace(b"MEGT90N000XB.IMG", pointer)
    assert "was removed" in refused(site, folder)


def test_a_label_of_another_grid_is_refused(site: Site, folder: Path, tmp_path: Path) -> None:
    other = MegdrPair(rough(90, 180), pixels_per_degree=0.5).write(tmp_path)
    site.files[LABEL] = other.read_bytes()
    assert "was removed" in refused(site, folder)


def test_a_download_can_be_cancelled_and_goes_on_later(site: Site, folder: Path) -> None:
    site.gate = threading.Event()
    job = module("terrain.megdr").MegdrJob(product(site.files), site.address, folder)
    site.gate.set()  # for the label
    fetch_only_label(site, folder)
    site.gate.clear()
    site.reached.clear()
    job.start()
    assert site.reached.wait(60.0)
    part = folder / "megt90n000xb.img.part"
    end = time.monotonic() + 60.0
    while not (part.is_file() and part.stat().st_size) and time.monotonic() < end:
        time.sleep(0.01)  # until the first half has come through
    job.cancel()
    assert job.poll()
    site.gate.set()
    job._thread.join()
    with pytest.raises(CancelledError):
        job.check()
    assert part.stat().st_size == 64_800, "nothing was written after the end"
    assert fetch(site, folder).with_suffix(".img").read_bytes() == site.files[IMAGE]
    assert str(site.asked[-1][1]).startswith("bytes=")


def fetch_only_label(site: Site, folder: Path) -> None:
    """Fetch the label, of a server that has no image yet."""
    image = site.files.pop(IMAGE)
    refused_because_missing = module("terrain.download").DownloadError
    with pytest.raises(refused_because_missing):
        module("terrain.megdr").fetch_megdr(
            module("terrain.megdr").Megdr(1, "meg001", "megt90n000xb", None),
            site.address,
            folder,
            module("terrain.work").Work(),
        )
    site.files[IMAGE] = image


def test_the_real_products_have_the_sizes_of_their_grids(mola: Path) -> None:
    known = {product.pixels_per_degree: product for product in module("terrain.megdr").PRODUCTS}
    assert sorted(known) == [4, 16, 32]
    image = mola.with_suffix(".img")
    assert known[4].image_bytes == image.stat().st_size
    assert known[4].sha256 == hashlib.sha256(image.read_bytes()).hexdigest()
    assert known[4].name == mola.stem


@pytest.fixture
def online(monkeypatch: pytest.MonkeyPatch) -> None:
    bpy.context.preferences.system.use_online_access = True
    if not bpy.app.online_access:
        pytest.skip("Blender was started offline")


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch, site: Site) -> None:
    """Let the 4 px/deg grid be the small one of the server."""
    wanted = replace(product(site.files), pixels_per_degree=1)
    operator = module("ui.download_operator").HAPTIC_TERRAIN_OT_download_mola
    monkeypatch.setattr(operator, "_product", lambda _self: wanted)


@pytest.mark.usefixtures("online", "small")
def test_the_operator_fetches_and_imports(site: Site) -> None:
    assert bpy.ops.haptic_terrain.download_mola(address=site.address) == {"FINISHED"}
    terrain = bpy.context.view_layer.objects.active
    assert terrain is not None
    source = module("terrain.kept").recall(terrain).grid.data_path
    own = Path(bpy.utils.extension_path_user(module("package").PACKAGE))
    assert source == own / "mola" / "megt90n000xb.img"
    for file in (source, source.with_suffix(".lbl")):
        file.unlink()


@pytest.mark.usefixtures("online", "small")
def test_the_operator_tells_what_failed_and_adds_nothing(site: Site) -> None:
    before = contents()
    site.files.clear()
    with pytest.raises(RuntimeError, match="404"):
        bpy.ops.haptic_terrain.download_mola(address=site.address)
    assert contents() == before


@pytest.mark.parametrize("cancelled", [False, True])
def test_a_person_sees_how_far_it_is_and_can_cancel(
    site: Site, folder: Path, monkeypatch: pytest.MonkeyPatch, cancelled: bool
) -> None:
    window, reports, imported = Window(), [], []
    operators = module("ui.download_operator")
    cls = operators.HAPTIC_TERRAIN_OT_download_mola
    job = module("terrain.megdr").MegdrJob(product(site.files), site.address, folder)
    operator = SimpleNamespace(_job=None, _timer=None, answered=True, _new_job=lambda: job)
    operator.report = lambda kind, text: reports.append((kind, text))
    for name in ("invoke", "begin", "modal", "_clear", "end", *SHOWING):
        setattr(operator, name, getattr(cls, name).__get__(operator))

    def import_grid(*_call: str, filepath: str, **_more: object) -> set[str]:
        imported.append(filepath)
        return {"FINISHED"}

    fake = SimpleNamespace(
        app=bpy.app, ops=SimpleNamespace(haptic_terrain=SimpleNamespace(import_grid=import_grid))
    )
    monkeypatch.setattr(operators, "bpy", fake)
    site.gate = threading.Event()
    assert operator.invoke(window.context, None) == {"RUNNING_MODAL"}
    operator.modal(window.context, SimpleNamespace(type="TIMER", value="NOTHING"))
    assert "Esc cancels" in said(window.status[-1])
    if cancelled:
        operator.modal(window.context, SimpleNamespace(type="ESC", value="PRESS"))
    else:
        site.gate.set()
    assert run_until_done(operator, window.context) == ({"CANCELLED"} if cancelled else {"FINISHED"})
    assert imported == ([] if cancelled else [str(folder / "megt90n000xb.lbl")])
    assert ("goes on from where" in reports[0][1]) == cancelled
    assert (window.timers, window.status[-1]) == (0, None)


def test_nothing_is_fetched_where_blender_is_offline(site: Site) -> None:
    bpy.context.preferences.system.use_online_access = False
    try:
        with pytest.raises(RuntimeError, match="offline"):
            bpy.ops.haptic_terrain.download_mola(address=site.address)
    finally:
        bpy.context.preferences.system.use_online_access = True
    assert site.asked == []
