"""Text that changes with every picture, at the price of one draw for each of its colours.

``blf`` draws each text by itself, and waits where a driver still reads the letters of the one before: 18
texts took ten times as long as the rest of the overlay. So ``blf`` draws each letter once, with its shadow,
and texts are put together from those.
"""

from __future__ import annotations

import math
import string
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import blf
import gpu
import numpy as np
from gpu.types import GPUBatch, GPUFrameBuffer, GPUTexture
from gpu_extras.batch import batch_for_shader
from mathutils import Matrix

from .colours import TEXT_SHADOW, Rgba

FONT = 0
"""Blender's own."""

LETTERS = string.ascii_letters + string.digits + string.punctuation + " \N{DEGREE SIGN}"
"""That every text may have; others are added when they come."""

SHADOW = 3
"""Pixels around a letter that its shadow may reach."""

ASCENT, DESCENT = 1.1, 0.4
"""Of a letter above and below the base line, in sizes of the font."""

ACROSS = 16
"""Letters in a row of the picture of all letters."""

TIMES = 16
"""Of a letter, to find its advance: the box of a text has no space after its last letter."""

WHITE: Rgba = (1.0, 1.0, 1.0, 1.0)


@dataclass(frozen=True)
class Words:
    """A text on a base line, from its left end; pixels."""

    text: str
    x: float
    y: float
    colour: Rgba


@dataclass
class Writing:
    """Texts in a size, each put together again only when it has changed."""

    _letters: Letters | None = None
    _kept: dict[tuple[str, Rgba], tuple[list[Words], GPUBatch]] = field(default_factory=dict)

    def use(self, size: float, text: str = "") -> Letters:
        """The letters in a size of the font, pixels, among them those of a text."""
        letters = self._letters
        if letters is None or letters.size != size or not letters.places.keys() >= set(text):
            self._letters = letters = Letters.drawn(size, "".join(dict.fromkeys(LETTERS + text)))
            self._kept.clear()
        return letters

    def draw(self, block: str, words: list[Words], size: float) -> None:
        """Draw texts.

        Args:
            block: a name for them, under which they are kept until they change.
        """
        letters = self.use(size, "".join(word.text for word in words))
        shader = gpu.shader.from_builtin("IMAGE_COLOR")
        gpu.state.blend_set("ALPHA_PREMULT")
        for colour in dict.fromkeys(word.colour for word in words):
            batch = self._batch(letters, block, colour, [word for word in words if word.colour == colour])
            red, green, blue, opacity = colour
            shader.bind()
            shader.uniform_sampler("image", letters.picture)
            shader.uniform_float("color", (red * opacity, green * opacity, blue * opacity, opacity))
            batch.draw(shader)
        gpu.state.blend_set("ALPHA")

    def _batch(self, letters: Letters, block: str, colour: Rgba, words: list[Words]) -> GPUBatch:
        kept = self._kept.get((block, colour))
        if kept is None or kept[0] != words:
            kept = self._kept[block, colour] = words, letters.batch(words)
        return kept[1]


@dataclass(frozen=True)
class Letters:
    """A picture of letters, white with their shadows, each in a cell of the same size."""

    size: float
    picture: GPUTexture
    places: dict[str, tuple[int, int]]
    """Left and lower side of a letter's cell, pixels."""
    advances: dict[str, float]
    """Pixels from a letter to the next one."""
    cell: tuple[int, int]
    """Pixels."""
    base: int
    """Pixels from a cell's lower side to the base line."""

    @staticmethod
    def drawn(size: float, letters: str) -> Letters:
        """Let ``blf`` draw them."""
        blf.size(FONT, size)
        advances = {letter: _advance(letter) for letter in letters}
        base = SHADOW + math.ceil(DESCENT * size)
        width = math.ceil(max(advances.values())) + 2 * SHADOW
        height = base + math.ceil(ASCENT * size) + SHADOW
        places = {
            letter: (number % ACROSS * width, number // ACROSS * height)
            for number, letter in enumerate(letters)
        }
        rows = math.ceil(len(letters) / ACROSS)
        picture = _painted(places, base, (width * ACROSS, height * rows))
        return Letters(size, picture, places, advances, (width, height), base)

    def width(self, text: str) -> float:
        """Pixels that a text takes."""
        return sum(self.advances[letter] for letter in text)

    def batch(self, words: Sequence[Words]) -> GPUBatch:
        """The letters of texts, each where it belongs."""
        corners = np.array(_quads(self, words), dtype=np.float32).reshape(-1, 4)
        across = np.array((0, 1, 1, 0, 1, 0)) * self.cell[0]
        up = np.array((0, 0, 1, 0, 1, 1)) * self.cell[1]
        shape = np.stack((across, up), axis=-1)
        places = (corners[:, None, :2] + shape).reshape(-1, 2)
        in_picture = (corners[:, None, 2:] + shape).reshape(-1, 2) / (self.picture.width, self.picture.height)
        flat = np.zeros((len(places), 3), dtype=np.float32)
        flat[:, :2] = places
        content = {"pos": flat, "texCoord": in_picture.astype(np.float32)}
        return batch_for_shader(gpu.shader.from_builtin("IMAGE_COLOR"), "TRIS", content)


def _quads(letters: Letters, words: Sequence[Words]) -> list[tuple[int, int, int, int]]:
    """The lower left corner of each letter, in the region and in the picture: whole pixels, to be sharp."""
    quads = []
    for word in words:
        x, y = word.x - SHADOW, round(word.y) - letters.base
        for letter in word.text:
            left, lower = letters.places[letter]
            quads.append((round(x), y, left, lower))
            x += letters.advances[letter]
    return quads


def _painted(places: dict[str, tuple[int, int]], base: int, size: tuple[int, int]) -> GPUTexture:
    """Let ``blf`` draw letters into their cells.

    What they are drawn into is copied: drivers wait before they read from something that was drawn into.
    """
    # Making a GPUOffScreen would take the framebuffer away that is being drawn into.
    canvas = GPUTexture(size, format="RGBA8")
    frame: Any = GPUFrameBuffer(color_slots=canvas)  # which does not hold it
    with frame.bind(), gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
        frame.clear(color=(0.0, 0.0, 0.0, 0.0))
        gpu.matrix.load_matrix(Matrix.Identity(4))
        gpu.matrix.load_projection_matrix(_in_pixels(*size))
        blf.enable(FONT, blf.SHADOW)
        blf.shadow(FONT, 3, *TEXT_SHADOW)
        blf.shadow_offset(FONT, 1, -1)
        blf.color(FONT, *WHITE)
        for letter, (left, lower) in places.items():
            blf.position(FONT, left + SHADOW, lower + base, 0.0)
            blf.draw(FONT, letter)
        blf.disable(FONT, blf.SHADOW)
        gpu.state.blend_set("ALPHA")  # which blf leaves switched off
        pixels = frame.read_color(0, 0, *size, 4, 0, "FLOAT")
    pixels.dimensions = size[0] * size[1] * 4
    return GPUTexture(size, format="RGBA8", data=pixels)


def _advance(letter: str) -> float:
    """Pixels, in the size that was set last."""
    return float(blf.dimensions(FONT, letter * (TIMES + 1))[0] - blf.dimensions(FONT, letter)[0]) / TIMES


def _in_pixels(width: int, height: int) -> Matrix:
    """From pixels to clip space."""
    matrix = Matrix.Diagonal((2.0 / width, 2.0 / height, -1.0, 1.0))
    matrix.translation = (-1.0, -1.0, 0.0)
    return matrix
