"""A 3D view as a pointer in it needs it: the ray under a pixel, in an object's coordinates; without Blender.

Blender's matrices have 32 bits. All that is made of them here has 64, so that a hand in a window of a few
cells does not tremble more than the view itself.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]

Pixel = tuple[float, float]
"""Pixels from the left and from the bottom of a view."""

Rows = Iterable[Iterable[float]]
"""Of a matrix, 4 x 4."""


@dataclass(frozen=True)
class Ray:
    """A straight line, in the object's coordinates."""

    origin: Numbers
    """In a perspective view the eye: what is behind it is not seen."""
    direction: Numbers
    """Away from whoever looks; of no length in particular."""
    has_eye: bool

    def at(self, share: float) -> Numbers | None:
        """The point so many directions from the origin; ``None`` behind the eye, and for no number."""
        if not np.isfinite(share) or (self.has_eye and share <= 0.0):
            return None
        return self.origin + share * self.direction


@dataclass(frozen=True)
class PointerView:
    """How an object lies before a camera, and what the camera makes of it."""

    to_camera: Numbers
    """4 x 4: from the object's coordinates to the camera's, which looks along its own -z."""
    projection: Numbers
    """4 x 4, of OpenGL's kind; sheared where a camera is shifted."""
    size: Pixel
    """Width and height."""

    @staticmethod
    def of(view: Rows, projection: Rows, world: Rows, size: Pixel) -> PointerView:
        """Put it together from a view's ``view_matrix`` and ``window_matrix`` and an object's place."""
        return PointerView(_numbers(view) @ _numbers(world), _numbers(projection), size)

    @property
    def is_perspective(self) -> bool:
        """Whether all rays come from one eye."""
        return bool(self.projection[3, 3] == 0.0)

    @property
    def forward(self) -> Numbers:
        """Where the camera looks, a unit vector in the object's coordinates."""
        along = np.linalg.inv(self.to_camera)[:3, :3] @ np.array((0.0, 0.0, -1.0))
        return np.asarray(along / np.linalg.norm(along))

    def ray(self, pointer: Pixel) -> Ray:
        """What lies under a pixel."""
        x, y = (2.0 * place / size - 1.0 for place, size in zip(pointer, self.size, strict=True))
        across, upward = self.projection[0], self.projection[1]
        if self.is_perspective:
            eye = np.zeros(3)
            along = np.array(((x + across[2]) / across[0], (y + upward[2]) / upward[1], -1.0))
        else:
            eye = np.array(((x - across[3]) / across[0], (y - upward[3]) / upward[1], 0.0))
            along = np.array((0.0, 0.0, -1.0))
        back = np.linalg.inv(self.to_camera)
        return Ray(back[:3, :3] @ eye + back[:3, 3], back[:3, :3] @ along, self.is_perspective)

    def units_per_pixel(self, place: Numbers) -> float:
        """How far apart two pixels are at an object's place, in its own units along its x."""
        depth = abs(float((self.to_camera @ np.append(place, 1.0))[2])) if self.is_perspective else 1.0
        apart = 2.0 * depth / (abs(float(self.projection[0, 0])) * self.size[0])
        return apart / float(np.linalg.norm(self.to_camera[:3, 0]))


def _numbers(matrix: Rows) -> Numbers:
    return np.array([list(row) for row in matrix], dtype=np.float64)
