"""Build meshes of a million vertices in Blender's Python module until the input ends.

Prints a line when it begins, and how many it built when it ends: something for a servo to be on time beside.
"""

from __future__ import annotations

import sys
import threading

import bpy
import numpy as np

SIDE = 1000


def main() -> None:
    """Build until there is no more to read."""
    ended = threading.Event()
    threading.Thread(target=_wait_for_end, args=(ended,), daemon=True).start()
    print("begins", flush=True)
    built = 0
    while not ended.is_set():
        _build()
        built += 1
    print(built, flush=True)


def _wait_for_end(ended: threading.Event) -> None:
    sys.stdin.read()
    ended.set()


def _build() -> None:
    """A grid of quads with heights, as an import makes it, and away with it."""
    rows, columns = np.mgrid[0:SIDE, 0:SIDE]
    vertices = np.stack([columns, rows, np.sin(columns * 0.01) * rows], axis=-1).astype(np.float32)
    corner = (rows[:-1, :-1] * SIDE + columns[:-1, :-1]).ravel()
    quads = np.stack([corner, corner + 1, corner + SIDE + 1, corner + SIDE], axis=-1).astype(np.int32)
    mesh = bpy.data.meshes.new("busy")
    mesh.vertices.add(SIDE * SIDE)
    mesh.vertices.foreach_set("co", vertices.ravel())
    mesh.loops.add(quads.size)
    mesh.loops.foreach_set("vertex_index", quads.ravel())
    mesh.polygons.add(len(quads))
    mesh.polygons.foreach_set("loop_start", np.arange(0, quads.size, 4, dtype=np.int32))
    mesh.update(calc_edges=True)
    mesh.validate()
    bpy.data.meshes.remove(mesh)


if __name__ == "__main__":
    main()
