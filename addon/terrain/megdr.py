"""The public MOLA grids of the PDS Geosciences Node, and fetching one; without Blender."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from proxygraph import Progress

from ..formats import FormatError, read_grid
from .download import DownloadError, Wanted, discard, fetch
from .job import Job
from .work import Tell, Work

ADDRESS = "https://pds-geosciences.wustl.edu/mgs/mgs-m-mola-5-megdr-l3-v1/mgsl_300x"
"""Of the folder that has a folder for each resolution: Smith and others, MGS-M-MOLA-5-MEGDR-L3-V1.0, 2003."""

MOST_LABEL_BYTES = 1 << 16
"""A label has some 2 to 8 kB."""


@dataclass(frozen=True)
class Megdr:
    """A global topography of 16-bit samples."""

    pixels_per_degree: int
    folder: str
    name: str
    sha256: str | None
    """Of the image, where it is known from several sources that do not depend on each other."""

    @property
    def rows(self) -> int:
        """From pole to pole."""
        return 180 * self.pixels_per_degree

    @property
    def columns(self) -> int:
        """Once around."""
        return 360 * self.pixels_per_degree

    @property
    def image_bytes(self) -> int:
        """Of the image."""
        return self.rows * self.columns * 2

    def address(self, base: str, suffix: str) -> str:
        """Of one of its two files."""
        return f"{base.strip().rstrip('/')}/{self.folder}/{self.name}{suffix}"

    def label_in(self, folder: Path) -> Path:
        """Where its label comes to lie."""
        return folder / f"{self.name}.lbl"

    def image_in(self, folder: Path) -> Path:
        """Where its image comes to lie."""
        return folder / f"{self.name}.img"


PRODUCTS = (
    Megdr(4, "meg004", "megt90n000cb", "25f16fb7aaf857898dcf98bc4f841341a24f8b9f7e98453ca083bc45d897ca2c"),
    Megdr(16, "meg016", "megt90n000eb", "d18d9b9ab8c5516d02e157dd2cde0f1d0d160c21940e953ba22391269a545e7b"),
    Megdr(32, "meg032", "megt90n000fb", None),
)


def fetch_megdr(product: Megdr, base: str, folder: Path, work: Work) -> Path:
    """Fetch label and image, unless they are there, and look whether they belong together; gives the label.

    Raises:
        DownloadError: a file cannot be fetched, or is not what it should be.
        CancelledError: the work was asked to end; what was fetched stays, and another call goes on.
    """
    label, image = product.label_in(folder), product.image_in(folder)
    if not label.is_file():
        wanted = Wanted(product.address(base, ".lbl"), MOST_LABEL_BYTES, is_exact=False)
        discard(label)  # too small to go on with, and without a size to tell when it is whole
        fetch(wanted, label, _telling(work.begin("Fetching the label", until=0.02), wanted.most_bytes))
    if not _is_whole(product, image):
        wanted = Wanted(product.address(base, ".img"), product.image_bytes, sha256=product.sha256)
        fetch(wanted, image, _telling(work.begin("Fetching the samples", until=0.98), wanted.most_bytes))
    work.begin("Checking", until=1.0)
    try:
        _check_pair(product, label, image)
    except FormatError as error:
        label.unlink(missing_ok=True)  # so that the next call fetches another
        raise DownloadError(
            f"The label from {product.address(base, '.lbl')} was removed: {error} Try another address."
        ) from error
    return label


def _telling(progress: Progress, size: int) -> Callable[[int], None]:
    """Tell how much is there, and raise ``CancelledError`` when that is wanted."""
    return lambda done: progress.step(min(done, size), size)


def _is_whole(product: Megdr, image: Path) -> bool:
    return image.is_file() and image.stat().st_size == product.image_bytes


def _check_pair(product: Megdr, label: Path, image: Path) -> None:
    """Refuse a label that does not describe this image: it came from elsewhere than the checksum.

    Raises:
        FormatError: naming what is wrong.
    """
    grid = read_grid(label)
    layout = grid.layout
    found = (grid.data_path.name, layout.columns, layout.rows, layout.sample)
    expected = (image.name, product.columns, product.rows, "i16")
    if found != expected or grid.decoding is not None:
        raise FormatError(
            label, "label", found=_in_words(found), expected=_in_words(expected), way_out="Fetch it again."
        )


def _in_words(description: Sequence[object]) -> str:
    name, columns, rows, sample = description
    return f"{name} of {columns} x {rows} {sample}"


class MegdrJob(Job):
    """Fetches a grid. See ``fetch_megdr`` for what ``check`` may raise."""

    def __init__(self, product: Megdr, base: str, folder: Path, tell: Tell | None = None) -> None:
        super().__init__(f"MOLA, {product.pixels_per_degree} px/deg", tell)
        self._product, self._base, self._folder = product, base, folder
        self.label = product.label_in(folder)
        """Where it is, once ``check`` says nothing."""

    def do(self, work: Work) -> None:
        """Fetch what is missing."""
        fetch_megdr(self._product, self._base, self._folder, work)
