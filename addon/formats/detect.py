"""What kind of grid a file is: its content decides, then the header beside it, never its ending alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from proxygraph import Progress

from .elevation_grid import ElevationGrid
from .file_bytes import file_length, read_head
from .format_error import FormatError
from .geotiff.geotiff_reader import read_geotiff
from .geotiff.tiff_magic import looks_like_tiff
from .not_a_grid import kind_of_file, without_header
from .partner_file import file_in_any_case
from .pds.label import FIRST_KEYWORD
from .pds.pds3_image import LABEL_SUFFIX, read_pds3
from .pds.pds4_array import read_pds4
from .pds.pds4_label import NAMESPACE
from .raw.data_beside import header_beside
from .raw.dem_without_header import looks_like_headless_dem, read_headless_dem
from .raw.ehdr import read_ehdr
from .raw.envi import read_envi
from .raw.envi_header import MAGIC as ENVI_MAGIC
from .raw.gridfloat import read_gridfloat
from .raw.hgt import SIZES as HGT_SIZES
from .raw.hgt import SUFFIX as HGT_SUFFIX
from .raw.hgt import HgtPosition, position_of, read_hgt
from .raw.keyword_header import keywords_of, looks_like_keyword_header
from .text.esri_ascii import read_esri_ascii
from .text.text_grids import looks_like_esri_ascii, looks_like_usgs_dem
from .text.usgs_dem import read_usgs_dem
from .through_rasterio import rasterio_fallback

SUFFIXES = (
    ".lbl",
    ".img",
    ".xml",
    ".hdr",
    ".dem",
    ".bil",
    ".bip",
    ".bsq",
    ".flt",
    ".hgt",
    ".tif",
    ".tiff",
    ".asc",
    ".grd",
    ".envi",
    ".dat",
    ".raw",
    ".jp2",
)
"""Endings that file browsers show; ``read_grid`` takes any."""

COMPANIONS = (".prj", ".stx", ".dmw", ".sch", ".src", ".gif", ".blw", ".aux", ".clr", ".stat", ".txt", ".jpg")
"""Endings of files that come along with a raster and its header, and hold no heights."""

HEAD_BYTES = 64 << 10
"""How much of a file is looked at."""

LABEL_BEGINS_WITHIN = 4096
"""Bytes before PDS_VERSION_ID: other keywords, comments, or the marks of an SFDU."""


PACKING_FIELDS = frozenset(("Compression", "Predictor", "SampleFormat", "BitsPerSample"))
"""Of a TIFF: what is refused by these may be read by a library with more decoders."""


@dataclass(frozen=True)
class Sniffed:
    """A file that was chosen, and how it begins."""

    path: Path
    head: bytes
    length: int
    position: HgtPosition | None = None
    """Where a degree square lies whose name does not tell."""
    progress: Progress | None = None
    """Where readers that look at every height tell how far they are."""


@dataclass(frozen=True)
class Family:
    """Formats that one reader reads."""

    name: str
    recognises: Callable[[Sniffed], bool]
    read: Callable[[Sniffed], ElevationGrid]


def read_grid(
    path: Path, position: HgtPosition | None = None, progress: Progress | None = None
) -> ElevationGrid:
    """Read the header of a grid file: what it describes and where its samples lie, not the samples.

    Grids of text are looked through once: nothing else tells where their heights are, and of which type.

    Args:
        path: of the header or of the data, whichever is at hand.
        position: of an SRTM square (``.hgt``) whose name does not say where it lies.
        progress: moves while a grid of text is looked through.

    Raises:
        FormatError: naming file, field, what was found and expected, and a way out.
        CancelledError: ``progress`` was asked to end.
    """
    sniffed = _sniffed(path, position, progress)
    for family in FAMILIES:
        if family.recognises(sniffed):
            return family.read(sniffed)
    raise _no_grid(sniffed)


def _sniffed(path: Path, position: HgtPosition | None, progress: Progress | None) -> Sniffed:
    """Look at the file; a folder, an empty file and a wrong path are told here."""
    found = file_in_any_case(path)
    if found is None:
        raise _not_a_file(path)
    length = file_length(found)
    head = read_head(found, HEAD_BYTES)
    if not head:
        raise FormatError(
            found, "file", found="no bytes", expected="an elevation grid", way_out="Download it again."
        )
    return Sniffed(found, head, length, position, progress)


def _not_a_file(path: Path) -> FormatError:
    try:
        is_folder = path.is_dir()
    except OSError:
        is_folder = False
    if is_folder:
        return FormatError(
            path, "file", found="a folder", expected="a file", way_out="Choose a file inside the folder."
        )
    return FormatError(
        path,
        "file",
        found=f"no such file as {path.absolute()}",
        expected="an elevation grid",
        way_out="Check the path.",
    )


def _is_pds4(file: Sniffed) -> bool:
    return (
        file.head.lstrip(b"\xef\xbb\xbf\xff\xfe \t\r\n").startswith(b"<") and NAMESPACE.encode() in file.head
    )


def _is_pds3(file: Sniffed) -> bool:
    return FIRST_KEYWORD.encode() in file.head[:LABEL_BEGINS_WITHIN]


def _is_envi_header(file: Sniffed) -> bool:
    return file.head[:4] == ENVI_MAGIC and file.head[4:5] in b"\r\n \t"


def _is_keyword_header(file: Sniffed) -> bool:
    return file.length < HEAD_BYTES and looks_like_keyword_header(file.head)


def _read_keyword_header(header: Path, data: Path | None) -> ElevationGrid:
    """EHdr says how many bits a sample has; GridFloat does not have to."""
    words = keywords_of(read_head(header, HEAD_BYTES))
    is_ehdr = {"NBITS", "PIXELTYPE", "LAYOUT", "BANDROWBYTES", "TOTALROWBYTES"} & words.keys()
    return read_ehdr(header, data) if is_ehdr else read_gridfloat(header, data)


def _pds3_label_beside(file: Sniffed) -> bool:
    return (
        file.path.suffix.lower() != LABEL_SUFFIX
        and (label := header_beside(file.path, LABEL_SUFFIX)) is not None
        and FIRST_KEYWORD.encode() in read_head(label, HEAD_BYTES)
    )


def _pds4_label_beside(file: Sniffed) -> bool:
    return (
        file.path.suffix.lower() != ".xml"
        and (label := header_beside(file.path, ".xml")) is not None
        and NAMESPACE.encode() in read_head(label, HEAD_BYTES)
    )


def _header_beside(file: Sniffed) -> bool:
    if file.path.suffix.lower() == ".hdr" or (header := header_beside(file.path, ".hdr")) is None:
        return False
    beside = Sniffed(header, read_head(header, HEAD_BYTES), file_length(header))
    return _is_envi_header(beside) or _is_keyword_header(beside)


def _read_with_header(file: Sniffed) -> ElevationGrid:
    """The file is the data, unless it is one of the others that come along."""
    header = header_beside(file.path, ".hdr")
    assert header is not None  # recognised by it
    data = None if file.path.suffix.lower() in COMPANIONS else file.path
    if read_head(header, 4) == ENVI_MAGIC:
        return read_envi(header, data)
    return _read_keyword_header(header, data)


def _is_hgt(file: Sniffed) -> bool:
    """By its ending or place; heights of the right size may begin with any bytes, also those of a picture."""
    if file.length not in HGT_SIZES and kind_of_file(file.head) is not None:
        return False
    named = file.path.suffix.lower() == HGT_SUFFIX
    return named or (
        file.length in HGT_SIZES and (position_of(file.path.name) is not None or file.position is not None)
    )


def _is_named_label(file: Sniffed) -> bool:
    return file.path.suffix.lower() == LABEL_SUFFIX and kind_of_file(file.head) is None


def _read_tiff(path: Path) -> ElevationGrid:
    """What is packed in a way that is not read here may be known to rasterio."""
    try:
        return read_geotiff(path)
    except FormatError as error:
        if error.field not in PACKING_FIELDS or rasterio_fallback.rasterio_module() is None:
            raise
        return rasterio_fallback.read_through_rasterio(path)


FAMILIES = (
    # What a file begins with.
    Family("GeoTIFF", lambda file: looks_like_tiff(file.head), lambda file: _read_tiff(file.path)),
    Family("PDS4", _is_pds4, lambda file: read_pds4(file.path)),
    Family("PDS3", _is_pds3, lambda file: read_pds3(file.path)),
    Family("ENVI", _is_envi_header, lambda file: read_envi(file.path)),
    Family("EHdr", _is_keyword_header, lambda file: _read_keyword_header(file.path, None)),
    Family(
        "Esri ASCII",
        lambda file: looks_like_esri_ascii(file.head),
        lambda file: read_esri_ascii(file.path, file.progress),
    ),
    Family(
        "USGS DEM",
        lambda file: looks_like_usgs_dem(file.head),
        lambda file: read_usgs_dem(file.path, file.progress),
    ),
    # What lies beside raw samples.
    Family("PDS3", _pds3_label_beside, lambda file: read_pds3(file.path)),
    Family("PDS4", _pds4_label_beside, lambda file: read_pds4(file.path)),
    Family("EHdr, GridFloat, ENVI", _header_beside, _read_with_header),
    # Raw samples alone, known by size and name.
    Family("SRTM", _is_hgt, lambda file: read_hgt(file.path, file.position)),
    Family(
        "GTOPO30 without its header",
        lambda file: looks_like_headless_dem(file.path, file.head, file.length),
        lambda file: read_headless_dem(file.path),
    ),
    Family("a label in name only", _is_named_label, lambda file: read_pds3(file.path)),
    # What another library may read.
    Family(
        "through rasterio",
        lambda file: rasterio_fallback.may_read(file.head),
        lambda file: rasterio_fallback.read_through_rasterio(file.path),
    ),
)
"""In the order in which they are asked."""


def _no_grid(file: Sniffed) -> FormatError:
    """Say what the file looks like, and what to do."""
    kind = kind_of_file(file.head)
    if kind is not None:
        return FormatError(
            file.path, "content", found=kind.name, expected="an elevation grid", way_out=kind.way_out
        )
    return without_header(file.path, file.length)
