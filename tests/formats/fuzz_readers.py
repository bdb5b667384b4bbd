"""Spoil small valid files of every family, and see that each is read or refused in words.

Run by hand: ``python -m tests.formats.fuzz_readers --seconds 600``. A finding is any other exception, an
answer that takes too long, or more memory than a small file can be worth; its files are kept.
"""

from __future__ import annotations

import argparse
import faulthandler
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable
from pathlib import Path

from addon.formats import ElevationGrid, FormatError, Region, read_grid
from addon.formats.decoders import DECODERS
from tests.formats.fuzz_mutations import spoil
from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.raw_grids import EQUIRECTANGULAR, POLAR, EhdrPair, EnviPair, GridFloatPair, Pds4Pair

SLOW_SECONDS = 20
"""An answer that takes longer is a hang."""

STUCK_SECONDS = 90
"""A hang that Python cannot end, inside of native code: the run ends, and says where."""

MOST_GROWN_KIB = 256 << 10
"""That the process may grow beyond its size after the first cases."""

MOST_ADDRESSES = 8 << 30
"""Bytes: an allocation beyond fails, and is found as MemoryError."""

PLACES_LOOKED_AT = ((0.0, 0.0), (1.5, 1.5), (-1e9, 1e9))


def attached(folder: Path) -> None:
    """Label and data in one file."""
    pair = MegdrPair(rough(4, 6), header={"RECORD_BYTES": 512, "^IMAGE": 8})
    (folder / "grid.img").write_bytes(pair.label().encode().ljust(512 * 7) + pair.data())


def polar(folder: Path) -> None:
    """A square around a pole."""
    projection = {
        "MAP_PROJECTION_TYPE": '"POLAR STEREOGRAPHIC"',
        "MAP_SCALE": "59 <KM/PIXEL>",
        "C_AXIS_RADIUS": 3376.2,
        "CENTER_LATITUDE": 90,
        "CENTER_LONGITUDE": 0,
        "LINE_PROJECTION_OFFSET": 2.5,
        "SAMPLE_PROJECTION_OFFSET": 2.5,
    }
    MegdrPair(rough(4, 4), projection=projection, image={"MISSING_CONSTANT": "16#FF7FFFFB#"}).write(folder)


def equirectangular(folder: Path) -> None:
    """Placed by offsets, three bands of bytes."""
    projection = {
        "MAP_PROJECTION_TYPE": "EQUIRECTANGULAR",
        "MAP_SCALE": "59.27 <KM/PIXEL>",
        "CENTER_LATITUDE": 10,
        "LINE_PROJECTION_OFFSET": 12.5,
        "SAMPLE_PROJECTION_OFFSET": -12.5,
    }
    image = {"SAMPLE_BITS": 8, "SAMPLE_TYPE": "UNSIGNED_INTEGER", "BANDS": 1, "UNIT": "KILOMETER"}
    pair = MegdrPair(rough(4, 6), projection=projection, image=image)
    pair.heights, pair.sample = [[1] * 6] * 4, "B"
    pair.write(folder)


def hgt(folder: Path) -> None:
    """The smallest degree square that is known."""
    (folder / "N10E020.hgt").write_bytes(bytes(2 * 601 * 601))


PDS4_CORNER = (
    '<cart:upperleft_corner_x unit="m">100</cart:upperleft_corner_x>'
    '<cart:upperleft_corner_y unit="m">100</cart:upperleft_corner_y>'
)
PDS4_METRES = (
    '<cart:pixel_resolution_x unit="m/pixel">60</cart:pixel_resolution_x>'
    '<cart:pixel_resolution_y unit="m/pixel">60</cart:pixel_resolution_y>'
)

FAMILIES: dict[str, Callable[[Path], object]] = {
    "PDS3": MegdrPair(rough(4, 6)).write,
    "PDS3 attached": attached,
    "PDS3 polar": polar,
    "PDS3 equirectangular": equirectangular,
    "PDS4": Pds4Pair().write,
    "PDS4 polar": Pds4Pair(projection=POLAR, resolution=PDS4_METRES, corner=PDS4_CORNER).write,
    "PDS4 equirectangular": Pds4Pair(
        projection=EQUIRECTANGULAR, resolution=PDS4_METRES, corner=PDS4_CORNER, data_type="UnsignedMSB2"
    ).write,
    "EHdr": EhdrPair().write,
    "EHdr bands": EhdrPair(
        words={"NBANDS": 2, "LAYOUT": "BIP", "TOTALROWBYTES": None}, data=bytes(100)
    ).write,
    "GridFloat": GridFloatPair().write,
    "GridFloat without byte order": GridFloatPair(words={"byteorder": None}).write,
    "ENVI": EnviPair().write,
    "ENVI bands": EnviPair(words={"bands": 3, "interleave": "bip"}, data=bytes(100)).write,
    "SRTM": hgt,
}


def envi_of_open_lists(folder: Path) -> None:
    """A megabyte of lists of which only the last is closed: each begins in the one before."""
    (folder / "grid.hdr").write_text("ENVI\n" + "a={\n" * 250_000 + "}", encoding="ascii")


def pds4_of_nested(element: str, count: int) -> Callable[[Path], object]:
    """A label of elements each inside the one before."""

    def write(folder: Path) -> None:
        nested = f"<{element}>" * count + f"</{element}>" * count
        (folder / "grid.xml").write_text(
            f'<P xmlns="http://pds.nasa.gov/pds4/pds/v1">{nested}</P>', encoding="ascii"
        )

    return write


def pds4_of_nested_axes(folder: Path) -> None:
    """Axes of an array each inside the one before."""
    count = 60_000
    nested = (
        "<Axis_Array>" * count + "<axis_name>Line</axis_name><elements>2</elements>" + "</Axis_Array>" * count
    )
    Pds4Pair(axes=nested).write(folder)


def pds3_of_empty_assignments(folder: Path) -> None:
    """The largest text that is followed, of assignments without values."""
    (folder / "grid.lbl").write_text(
        "PDS_VERSION_ID = PDS3\n" + "A = \n" * 12_000 + "END\n", encoding="ascii"
    )


SLOW_ONCE: dict[str, Callable[[Path], object]] = {
    "ENVI of open lists": envi_of_open_lists,
    "PDS4 of nested file areas": pds4_of_nested("File_Area_Observational", 60_000),
    "PDS4 of nested axes": pds4_of_nested_axes,
    "PDS3 of empty assignments": pds3_of_empty_assignments,
}
"""Small files that took seconds, or minutes, of which no spoiling comes."""


class SlowError(BaseException):
    """An answer took too long; no reader may catch it."""


def ring(_signal: int, _frame: object) -> None:
    """End what takes too long."""
    raise SlowError(f"no answer after {SLOW_SECONDS} s")


def main() -> int:
    """Fuzz for so many seconds, and print counts."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--seconds", type=float, default=60.0)
    arguments.add_argument(
        "--seed", type=int, default=0, help="of the first case; each case has the next one"
    )
    arguments.add_argument("--family", choices=[*FAMILIES], help="only this one")
    asked = arguments.parse_args()
    signal.signal(signal.SIGALRM, ring)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))
    names = [asked.family] if asked.family else [*FAMILIES]
    counts: Counter[str] = Counter()
    findings = 0
    grown_from = None
    for name in SLOW_ONCE:
        answer = run_case(name, None)
        counts[f"{name}: {answer}"] += 1
        findings += answer == "FOUND"
    began, seed = time.monotonic(), asked.seed
    while time.monotonic() - began < asked.seconds:
        name = names[seed % len(names)]
        answer = run_case(name, seed)
        counts[f"{name}: {answer}"] += 1
        findings += answer == "FOUND"
        seed += 1
        if seed - asked.seed == 2000:
            grown_from = resident_kib()
        if grown_from is not None and resident_kib() - grown_from > MOST_GROWN_KIB:
            print(f"memory grew from {grown_from:,} to {resident_kib():,} KiB by case {seed}")
            findings += 1
            grown_from = resident_kib()
    for line, count in sorted(counts.items()):
        print(f"{count:9,}  {line}")
    print(f"{seed - asked.seed:,} cases, {findings} findings, {resident_kib():,} KiB at the most")
    return 1 if findings else 0


def run_case(name: str, seed: int | None) -> str:
    """Make one set of files, and read each of them.

    Args:
        seed: of what is spoilt in them; ``None``: nothing, they are bad as they are.
    """
    folder = Path(tempfile.mkdtemp(prefix="fuzz-"))
    try:
        if seed is None:
            SLOW_ONCE[name](folder)
        else:
            FAMILIES[name](folder)
            spoil(folder, random.Random(seed))
        signal.setitimer(signal.ITIMER_REAL, SLOW_SECONDS)
        faulthandler.dump_traceback_later(STUCK_SECONDS, exit=True)
        answers = {read_all(path) for path in sorted(folder.iterdir())}
    except (Exception, SlowError):
        print(f"{name}, seed {seed}:\n{traceback.format_exc()}", file=sys.stderr, flush=True)
        kept = Path(tempfile.gettempdir()) / "fuzz-findings" / f"{name.replace(' ', '-')}-{seed}"
        shutil.copytree(folder, kept, dirs_exist_ok=True)
        return "FOUND"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        faulthandler.cancel_dump_traceback_later()
        shutil.rmtree(folder, ignore_errors=True)
    return "read" if "read" in answers else "refused"


def read_all(path: Path) -> str:
    """Read one file wholly: the header, some places, a region, and every sample."""
    try:
        grid = read_grid(path)
        look_at(grid)
    except FormatError as error:
        text = str(error)
        assert len(text) < 2000, text
        assert "found" in text, text
        assert "expected" in text, text
        return "refused"
    return "read"


def look_at(grid: ElevationGrid) -> None:
    """What the add-on does with a grid."""
    place = grid.georeference
    for column, row in PLACES_LOOKED_AT:
        found = place.longitude_latitude(column, row)
        if found is not None:
            place.column_row(*found, grid.layout.columns)
    assert grid.layout.byte_length > 0
    parts = [grid]
    if min(grid.layout.rows, grid.layout.columns) >= 3:
        parts.append(grid.region(Region(1, 1, 2, 2)))
    for part in parts:
        if part.decoding is None or part.decoding.kind in DECODERS:
            part.open().range()


def resident_kib() -> int:
    """The most memory that the process had."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


if __name__ == "__main__":
    sys.exit(main())
