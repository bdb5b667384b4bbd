"""Map projections: from longitude and latitude to a map's own coordinates, and back."""

from __future__ import annotations

from .albers import Albers
from .equirectangular import Equirectangular
from .geographic import Geographic
from .lambert_azimuthal_equal_area import LambertAzimuthalEqualArea
from .lambert_conformal_conic import LambertConformalConic
from .mercator import Mercator, WebMercator
from .oblique_stereographic import ObliqueStereographic
from .polar_stereographic import PolarStereographic
from .projection import Coordinates, Projection
from .sinusoidal import Sinusoidal
from .transverse_mercator import TransverseMercator
from .unknown import Unknown

__all__ = [
    "KINDS",
    "Albers",
    "Coordinates",
    "Equirectangular",
    "Geographic",
    "LambertAzimuthalEqualArea",
    "LambertConformalConic",
    "Mercator",
    "ObliqueStereographic",
    "PolarStereographic",
    "Projection",
    "Sinusoidal",
    "TransverseMercator",
    "Unknown",
    "WebMercator",
]

KINDS: dict[str, type[Projection]] = {
    kind.name: kind
    for kind in (
        Geographic,
        Unknown,
        TransverseMercator,
        PolarStereographic,
        ObliqueStereographic,
        LambertConformalConic,
        LambertAzimuthalEqualArea,
        Albers,
        Mercator,
        WebMercator,
        Equirectangular,
        Sinusoidal,
    )
}
"""Every projection by its name, for those who keep one as text and numbers."""
