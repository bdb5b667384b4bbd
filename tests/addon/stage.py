"""A 3D view off the screen: the ground of a touch, and the overlay over it."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
import numpy.typing as npt
from mathutils import Euler, Matrix, Vector

from tests.addon.scene import module, positions

Pixels = npt.NDArray[np.uint8]

WIDTH, HEIGHT = 1280, 800


def why_not() -> str | None:
    """Why nothing can be drawn here; ``None`` where it can."""
    if not bpy.app.background:
        return None
    import gpu

    if not hasattr(gpu, "init"):
        return "this Blender cannot draw in the background: that needs 5.2"
    try:
        gpu.init()
    except (RuntimeError, SystemError) as error:
        return f"Blender cannot draw on this machine: {error}"
    return None


class Stage:
    """A view of so many pixels that looks at a place, from the south and above."""

    def __init__(
        self,
        *,
        at: Vector | None = None,
        distance: float = 12.0,
        tilt: float = 0.9,
        scale: float = 1.0,
        size: tuple[int, int] = (WIDTH, HEIGHT),
        orthographic: bool = False,
    ) -> None:
        """
        Args:
            distance: Blender units. tilt: radians from straight down. scale: of the interface.
        """
        import gpu

        self.size = size
        self.canvas = gpu.types.GPUOffScreen(*size, format="RGBA8")
        turn = Euler((tilt, 0.0, 0.0)).to_matrix()
        eye = (at or Vector()) + turn @ Vector((0.0, 0.0, distance))
        self.looking = (Matrix.Translation(eye[:]) @ turn.to_4x4()).inverted()
        self.projection = _orthographic(distance, size) if orthographic else _perspective(size)
        self.view = module("overlay.view").View(
            free=module("overlay.rect").Rect(0.0, 0.0, *size),
            axes=105.0 * scale,
            has_buttons=True,
            width=size[0],
            scale=scale,
            perspective=self.projection @ self.looking,
            rotation=turn,
        )

    def pixel(self, place: Vector) -> tuple[float, float]:
        """Where a place of the scene is seen, from the lower left corner."""
        clip = self.view.perspective @ place.to_4d()
        x, y = (0.5 + 0.5 * clip[axis] / clip.w for axis in (0, 1))
        return x * self.size[0], y * self.size[1]

    def draw_overlay(self, overlay: Any, wanted: Any) -> None:
        """Draw the overlay alone, as a redraw of a 3D view would; nothing is read back."""
        import gpu

        pen = module("overlay.pen")
        with self.canvas.bind(), gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
            gpu.matrix.load_matrix(self.looking)
            gpu.matrix.load_projection_matrix(self.projection)
            with pen.clean_state():
                overlay.draw_in_scene(self.view, wanted)
            gpu.matrix.load_matrix(Matrix.Identity(4))
            gpu.matrix.load_projection_matrix(_pixels(self.size))
            with pen.clean_state():
                overlay.draw_flat(self.view, wanted)

    def read(self) -> Pixels:
        """What was drawn, once it is: rows x columns x 4, the lowest row first."""
        import gpu

        with self.canvas.bind():
            frame = gpu.state.active_framebuffer_get()
            buffer: Any = frame.read_color(0, 0, *self.size, 4, 0, "UBYTE")
        buffer.dimensions = self.size[0] * self.size[1] * 4
        return np.array(buffer, dtype=np.uint8).reshape(self.size[1], self.size[0], 4)

    def draw(
        self,
        overlay: Any,
        wanted: Any,
        *,
        ground: bpy.types.Object | None = None,
        colour: tuple[float, float, float, float] = (0.25, 0.25, 0.25, 1.0),
    ) -> Pixels:
        """Draw the overlay over a colour, or over a terrain in its colours.

        Returns:
            Rows x columns x 4, the lowest row first.
        """
        import gpu

        with self.canvas.bind():
            gpu.state.active_framebuffer_get().clear(color=colour, depth=1.0)
            with gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
                gpu.matrix.load_matrix(self.looking)
                gpu.matrix.load_projection_matrix(self.projection)
                if ground is not None:
                    _draw_ground(ground)
                    _draw_cursor(bpy.data.objects["Haptic Cursor"])
        self.draw_overlay(overlay, wanted)
        return self.read()


def wait_for_map(overlay: Any) -> None:
    """Let the thread finish the picture of the map."""
    overlay.overview.painting._picture.result(timeout=60)


def save(pixels: Pixels, path: Any) -> None:
    """Write a picture to look at."""
    image = bpy.data.images.new("stage", pixels.shape[1], pixels.shape[0])
    values: Any = image.pixels
    values.foreach_set((pixels.astype(np.float32) / 255.0).ravel())
    image.filepath_raw, image.file_format = str(path), "PNG"
    image.save()
    bpy.data.images.remove(image)


def _draw_ground(terrain: bpy.types.Object) -> None:
    mesh = terrain.data
    values = np.empty(len(mesh.vertices), dtype=np.float32)
    mesh.attributes["elevation"].data.foreach_get("value", values)
    normals = np.empty(len(mesh.vertices) * 3, dtype=np.float32)
    mesh.vertices.foreach_get("normal", normals)
    light = np.clip(normals.reshape(-1, 3) @ np.array((-0.5, 0.5, 0.707)), 0.1, 1.0)
    look = module("terrain.terrain_material")
    swatches = list(reversed(look.swatches(look.material_of(terrain), look.ColourBy.ELEVATION)))
    levels = [swatch.value for swatch in swatches]
    colours = np.ones((len(values), 4), dtype=np.float32)
    for channel in range(3):
        shares = [tuple(swatch.element.color)[channel] for swatch in swatches]
        colours[:, channel] = np.interp(values, levels, shares) * light
    colours[:, :3] = module("overlay.colours").on_screen(colours[:, :3])
    _draw_mesh(terrain, colours)


def _draw_cursor(cursor: bpy.types.Object) -> None:
    mesh: Any = cursor.data
    colour = module("overlay.colours").opaque(tuple(mesh.materials[0].diffuse_color)[:3])
    _draw_mesh(cursor, np.tile(np.array(colour, dtype=np.float32), (len(mesh.vertices), 1)))


def _draw_mesh(thing: bpy.types.Object, colours: npt.NDArray[np.float32]) -> None:
    """Draw it with the depth that hides what lies behind."""
    import gpu
    from gpu_extras.batch import batch_for_shader

    mesh: Any = thing.data
    mesh.calc_loop_triangles()
    corners = np.empty(len(mesh.loop_triangles) * 3, dtype=np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners)
    matrix = np.array(thing.matrix_world, dtype=np.float32)
    places = positions(mesh) @ matrix[:3, :3].T + matrix[:3, 3]
    shader = gpu.shader.from_builtin("SMOOTH_COLOR")
    content: Any = {"pos": places, "color": colours}
    faces: Any = corners.reshape(-1, 3)
    batch = batch_for_shader(shader, "TRIS", content, indices=faces)
    gpu.state.depth_test_set("LESS_EQUAL")
    gpu.state.depth_mask_set(True)
    batch.draw(shader)
    gpu.state.depth_test_set("NONE")
    gpu.state.depth_mask_set(False)


def _perspective(size: tuple[int, int]) -> Matrix:
    near, far, across = 0.01, 1000.0, 0.72
    up = across * size[1] / size[0]
    return Matrix(
        (
            (2.0 / across, 0.0, 0.0, 0.0),
            (0.0, 2.0 / up, 0.0, 0.0),
            (0.0, 0.0, -(far + near) / (far - near), -2.0 * far * near / (far - near)),
            (0.0, 0.0, -1.0, 0.0),
        )
    )


def _orthographic(distance: float, size: tuple[int, int]) -> Matrix:
    far = 1000.0
    up = distance * size[1] / size[0]
    return Matrix.Diagonal((2.0 / distance, 2.0 / up, -1.0 / far, 1.0))


def _pixels(size: tuple[int, int]) -> Matrix:
    """From pixels to clip space."""
    matrix = Matrix.Diagonal((2.0 / size[0], 2.0 / size[1], -0.01, 1.0))
    matrix.translation = (-1.0, -1.0, 0.0)
    return matrix
