"""rasterio where the person has it, and what is asked of it."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any, Literal

DRIVERS = (
    *("AIG", "BAG", "BT", "BSB", "CTable2", "DTED", "FITS", "GRIB", "GS7BG", "GSAG", "GSBG", "GTiff", "GXF"),
    *("HDF4", "HDF4Image", "HDF5", "HDF5Image", "HFA", "ILWIS", "ISIS2", "ISIS3", "JP2OpenJPEG", "JP2ECW"),
    *("JP2KAK", "KEA", "Leveller", "netCDF", "NITF", "NWT_GRD", "NTv2", "PCRaster", "RMF", "RST", "SAGA"),
    *("SDTS", "SIGDEM", "SNAP_TIFF", "SRTMHGT", "Terragen", "VICAR", "XYZ", "ZMap"),
)
"""GDAL's names of formats that hold their own samples; others lead to other files, or into the network."""

SampleType = Literal["i16", "u16", "i32", "f32", "f64"]

SAMPLES: dict[str, tuple[SampleType, str]] = {
    "int8": ("i16", "int16"),
    "uint8": ("i16", "int16"),
    "int16": ("i16", "int16"),
    "uint16": ("u16", "uint16"),
    "int32": ("i32", "int32"),
    "uint32": ("f64", "float64"),
    "int64": ("f64", "float64"),
    "uint64": ("f64", "float64"),
    "float32": ("f32", "float32"),
    "float64": ("f64", "float64"),
}
"""By rasterio's names: the sample of the layout, and what rasterio is asked to give."""


def rasterio_module() -> Any:
    """The module where the person has it; a broken installation counts as none."""
    try:
        return import_module("rasterio")
    except Exception:  # a library that cannot be loaded raises what it likes
        return None


def open_raster(rasterio: Any, path: Path) -> Any:
    """Open a file for reading, to be used in a ``with`` statement.

    rasterio takes one driver or any: each of ``DRIVERS`` is asked in its turn, and those that do not know the
    file, or are not built in, refuse it.

    Raises:
        OSError: none of them reads it.
    """
    for driver in DRIVERS:
        try:
            return rasterio.open(path, driver=driver)
        except Exception:  # of many kinds, some of them rasterio's own
            continue
    raise OSError("none of GDAL's drivers for single files reads it")
