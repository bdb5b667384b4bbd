"""Touch elevation grids: proxy contact models and a 1 kHz haptic servo.

Frames and units (see each class):

* grid: column (eastward) and row (southward), in cells; sample (0, 0) is the first in the file.
* terrain: metres east, north and up, measured from sample (0, 0): ``east = column * cell_width``,
  ``north = -row * cell_height``, ``up`` = elevation in metres, never exaggerated. On a grid that
  wraps, ``east`` runs on beyond the last column instead of jumping.
* workspace: metres and newtons in the device's frame, x right (east), y away (north), z up.
"""

import os
from collections.abc import Buffer, Sequence
from pathlib import Path
from typing import Literal, final

__version__: str

MODELS: tuple[str, ...]
"""The names of the contact models, the default first: ``surface_walk proxy_graph god_object
god_object_release virtual_proxy``."""

STALE_AFTER: float
"""Seconds: what ``Session``'s ``stale_after`` should be for programs that draw."""

def model_descriptions() -> dict[str, str]:
    """A line on each contact model for those who choose, by name, in the order of ``MODELS``."""

SampleType = Literal["i16", "u16", "i32", "f32", "f64"]
ByteOrder = Literal["big", "little"]
Feature = Literal["free", "face", "edge", "vertex"]
Mode = Literal["normal", "pan", "zoom"]
Held = Literal["host", "late", "speed", "device", "not_finite", "finished", "below"]
"""Why there is no force, or not yet all of it: ``host``, nobody looked at the session for ``stale_after``; ``late``,
ticks were missed; ``speed``, the hand was faster than ``max_speed``; ``device``, the device failed and was forgiven;
``not_finite``, a position or a force was no number; ``finished``, a ``PlaybackDevice`` has played to its end; ``below``, the hand is under the ground and touch begins only
from above: after a start, a new window or a long pause the proxy begins at the hand."""
Vector = tuple[float, float, float]

class GridError(ValueError):
    """A layout, a file or a buffer cannot be used as a grid; the text says what was found and expected."""

class DecodeError(GridError):
    """A file cannot be decoded; ``args`` are the field, what was found and what was expected."""

class CancelledError(Exception):
    """A long work was asked to end, and did; nothing of it is left."""

class SessionError(RuntimeError):
    """A session was used in a state that does not allow the call (started twice, stepped while live)."""

class TakeError(ValueError):
    """A file cannot be read as a take; the text names it and says what was found and expected."""

class TakeInUseError(TakeError):
    """A take's file is being written, or was claimed, by a program that runs."""

@final
class Progress:
    """How far a long work has come; every call may come from any thread."""

    def __init__(self) -> None: ...
    @property
    def share(self) -> float:
        """What is done, from 0 to 1."""
    @property
    def cancelled(self) -> bool: ...
    def cancel(self) -> None:
        """Ask the work to end as soon as it can; it then raises ``CancelledError``."""
    def step(self, done: int, all: int) -> None:  # noqa: A002
        """Tell that ``done`` of ``all`` steps are done.

        Raises:
            CancelledError: the work was asked to end.
        """

@final
class GeoTiff:
    """A TIFF file whose first directory was read; its samples were not.

    Strips and tiles; none, LZW, deflate and PackBits compression; predictors 1 to 3; both byte orders; BigTIFF.
    """

    @staticmethod
    def open(path: str | os.PathLike[str]) -> GeoTiff:
        """Read the header and the first directory, and check that every strip or tile lies in the file.

        Raises:
            DecodeError: it is no TIFF, or one that cannot be decoded here.
            OSError: it cannot be read.
        """
    @property
    def rows(self) -> int:
        """At least 1."""
    @property
    def columns(self) -> int:
        """At least 1."""
    @property
    def bands(self) -> int:
        """Values for each place, at least 1; the first is what is decoded."""
    @property
    def planar(self) -> bool:
        """Whether each of several bands lies by itself."""
    @property
    def stored(self) -> Literal["u8", "i8", "u16", "i16", "u32", "i32", "f32", "f64"]:
        """The number format in the file."""
    @property
    def sample(self) -> SampleType:
        """The sample type that ``decode`` gives, which holds every value of ``stored``."""
    @property
    def byte_order(self) -> ByteOrder:
        """Of the file."""
    @property
    def big(self) -> bool:
        """Whether it is a BigTIFF."""
    @property
    def compression(self) -> Literal["none", "LZW", "deflate", "PackBits"]: ...
    @property
    def predictor(self) -> int:
        """1 none, 2 horizontal, 3 floating point."""
    @property
    def tiled(self) -> bool:
        """Whether the samples lie in tiles, not in strips."""
    @property
    def chunk(self) -> tuple[int, int]:
        """Columns and rows of a tile or strip."""
    @property
    def photometric(self) -> int | None:
        """The tag PhotometricInterpretation: 2 for red, green and blue, 3 for a colour table."""
    @property
    def in_place(self) -> tuple[int, int] | None:
        """Bytes before the first sample, and from one row to the next, where ``Grid.open`` can map the first band.

        ``None`` where it must be decoded: it is compressed, in pieces, beside others, or of a type that
        ``GridLayout`` does not have.
        """
    def numbers(self, tag: int) -> list[float] | None:
        """The numbers of a tag, of whatever numeric type; ``None`` where the file has no such tag.

        Raises:
            DecodeError: the tag is a text, has more than 65,536 values, or points out of the file.
        """
    def text(self, tag: int) -> str | None:
        """The text of a tag without NULs at its end; ``None`` where the file has no such tag.

        Raises:
            DecodeError: the tag has numbers, more than 16 MiB, or points out of the file.
        """
    def decode(
        self,
        layout: GridLayout,
        first_column: int = 0,
        first_row: int = 0,
        *,
        south_up: bool = False,
        fill: float = 0.0,
        progress: Progress | None = None,
        cache: str | os.PathLike[str] | None = None,
    ) -> Grid:
        """Decode the strips or tiles that a region needs (without the GIL).

        Args:
            layout: of the grid that is made: rows and columns of the region, and ``sample`` as above.
            first_column: of the region; columns beyond the file's last go on at its first.
            first_row: of the region, counted from the north.
            south_up: whether the file's first row is its southernmost: rows are turned over.
            fill: the stored value of strips and tiles that the file leaves out.
            cache: a file to decode into, which is then mapped; ``None`` decodes into memory.

        Raises:
            DecodeError: samples are damaged or missing, or the region is not on the raster.
            CancelledError: ``progress`` was asked to end.
            OSError: a file cannot be read or written; a full disk too.
        """

@final
class UsgsDem:
    """A USGS digital elevation model as text: its A record was read, its profiles were found and looked at.

    The grid is the smallest that holds every profile, row-major from the north-west; void where no profile is.
    """

    @staticmethod
    def open(path: str | os.PathLike[str], progress: Progress | None = None) -> UsgsDem:
        """Read the A record and look at every height once (without the GIL).

        A file that ends early is read as far as it is whole; ``notes`` tell what is missing.

        Raises:
            DecodeError: it is no USGS DEM, or a field cannot be right. OSError: it cannot be read.
            CancelledError: ``progress`` was asked to end.
        """
    @property
    def name(self) -> str:
        """Of the quadrangle."""
    @property
    def system(self) -> Literal["geographic", "UTM", "state plane", "other"]:
        """Of the coordinates."""
    @property
    def zone(self) -> int:
        """Of UTM or state plane, as it is written; 0 where there is none."""
    @property
    def ground_unit(self) -> Literal["radian", "foot", "metre", "arc-second"]:
        """Of ``corners``, ``step`` and ``first``."""
    @property
    def elevation_unit(self) -> Literal["foot", "metre"]:
        """Of ``range``, and of ``sample * scale + value_offset``."""
    @property
    def corners(self) -> list[tuple[float, float]] | None:
        """South-west, north-west, north-east and south-east of the quadrangle (x, y); ``None`` where blank."""
    @property
    def horizontal_datum(self) -> int | None:
        """1 NAD27, 2 WGS72, 3 WGS84, 4 NAD83, 5 Old Hawaiian, 6 Puerto Rico; ``None`` in old files."""
    @property
    def vertical_datum(self) -> int | None:
        """1 local mean sea level, 2 NGVD29, 3 NAVD88; ``None`` in old files."""
    @property
    def step(self) -> tuple[float, float]:
        """Between columns and between rows."""
    @property
    def rows(self) -> int:
        """At least 2."""
    @property
    def columns(self) -> int:
        """At least 2."""
    @property
    def first(self) -> tuple[float, float]:
        """x and y of the north-west sample."""
    @property
    def profiles(self) -> int:
        """That the file has."""
    @property
    def heights(self) -> int:
        """That the file has, voids left out."""
    @property
    def range(self) -> tuple[float, float] | None:
        """Lowest and highest height as they are, not as the header says; ``None`` where all are void."""
    @property
    def sample(self) -> Literal["i16", "i32", "f64"]:
        """The smallest type that keeps every height as it is."""
    @property
    def scale(self) -> float: ...
    @property
    def value_offset(self) -> float: ...
    @property
    def void(self) -> float:
        """The sample that means "no data"; NaN in ``f64``."""
    @property
    def notes(self) -> list[str]:
        """What a person should know: profiles that are missing, blank heights."""
    def decode(
        self,
        layout: GridLayout,
        first_column: int = 0,
        first_row: int = 0,
        *,
        progress: Progress | None = None,
        cache: str | os.PathLike[str] | None = None,
    ) -> Grid:
        """Decode a region of the layout's size (without the GIL) into memory, or into a new file ``cache``.

        Columns that run on beyond the last one go on with the first: meant for grids of a whole planet.

        Raises:
            DecodeError: the layout has another sample type, the region is not on the grid, or the file changed.
            CancelledError: ``progress`` was asked to end. OSError: the system refused.
        """

@final
class EsriAscii:
    """An Esri ASCII grid: its header was read, and every height where that was asked for."""

    @staticmethod
    def open(
        path: str | os.PathLike[str], progress: Progress | None = None, *, heights: bool = True
    ) -> EsriAscii:
        """Read the header, and every height once (without the GIL).

        Args:
            heights: whether to look at them: else ``range``, ``voids``, ``sample`` and ``void`` are ``None``, and
                words that are no numbers are found only when they are decoded.

        Raises:
            DecodeError: it is no Esri ASCII grid, a word is no number, or there are too few or too many heights.
            OSError: it cannot be read. CancelledError: ``progress`` was asked to end.
        """
    @property
    def rows(self) -> int:
        """At least 2."""
    @property
    def columns(self) -> int:
        """At least 2."""
    @property
    def step(self) -> tuple[float, float]:
        """Between columns and between rows, in the map's unit; above 0."""
    @property
    def corner(self) -> tuple[float, float]:
        """x and y at the lower left cell."""
    @property
    def corner_is_center(self) -> tuple[bool, bool]:
        """Whether x, and whether y, is of that cell's centre, not of its outer corner."""
    @property
    def nodata(self) -> float:
        """The value that means "no data" in the file; -9999 where the header does not say, NaN at times."""
    @property
    def range(self) -> tuple[float, float] | None:
        """Lowest and highest height; ``None`` where all are void, too."""
    @property
    def voids(self) -> int | None: ...
    @property
    def sample(self) -> Literal["i16", "i32", "f32", "f64"] | None:
        """The smallest type that keeps every height as it is written."""
    @property
    def void(self) -> float | None:
        """The sample that means "no data" once it is decoded; NaN in ``f32`` and ``f64``."""
    def decode(
        self,
        layout: GridLayout,
        first_column: int = 0,
        first_row: int = 0,
        *,
        progress: Progress | None = None,
        cache: str | os.PathLike[str] | None = None,
    ) -> Grid:
        """As ``UsgsDem.decode``; the layout has the type ``sample``, and ``void`` where that is not NaN."""

@final
class RawSamples:
    """Where the samples of one band lie in a file that cannot be mapped as it is.

    Args:
        rows, columns: of the whole band.
        sample: type in the file. ``i8`` and ``u8`` become ``i16``; ``u32``, ``i64`` and ``u64`` become ``f64``.
        byte_order: in the file.
        offset: bytes before the first sample of the band.
        pixel_stride, row_stride: bytes from one column, and from one row, to the next.
        south_first: whether the file's first row is the southernmost.
        wraps: whether a region may run on beyond the last column.

    Raises:
        ValueError: naming the field, what was found and what was expected.
    """

    def __init__(
        self,
        rows: int,
        columns: int,
        *,
        sample: Literal["i8", "u8", "i16", "u16", "i32", "u32", "i64", "u64", "f32", "f64"],
        byte_order: ByteOrder,
        offset: int,
        pixel_stride: int,
        row_stride: int,
        south_first: bool = False,
        wraps: bool = False,
    ) -> None: ...
    def decode(
        self,
        path: str | os.PathLike[str],
        layout: GridLayout,
        first_column: int = 0,
        first_row: int = 0,
        *,
        progress: Progress | None = None,
        cache: str | os.PathLike[str] | None = None,
    ) -> Grid:
        """Copy a region of the layout's size; only its own rows and columns are read. See ``UsgsDem.decode``.

        Raises:
            DecodeError: also where samples overlap, or the file is too short for them.
        """

@final
class GridLayout:
    """Where the samples of a row-major grid lie, and what they mean. Immutable.

    Args:
        rows, columns: the number of samples north-south and east-west; at least 2 each.
        cell_width, cell_height: metres between neighbouring columns, and between rows; positive.
        sample: the type of one sample.
        byte_order: of one sample.
        offset: bytes before the first sample.
        row_stride: bytes from one row to the next; ``None`` means that the rows are packed.
        scale, value_offset: elevation in metres = ``sample * scale + value_offset``.
        void: the sample value that means "no data"; NaN, infinite samples and heights beyond 1e100 m are
            void too.
        wraps: whether column ``columns`` is column 0 again (a whole planet).

    Raises:
        GridError: naming the field, what was found and what was expected.
    """

    def __init__(
        self,
        rows: int,
        columns: int,
        *,
        cell_width: float,
        cell_height: float,
        sample: SampleType = "i16",
        byte_order: ByteOrder = "big",
        offset: int = 0,
        row_stride: int | None = None,
        scale: float = 1.0,
        value_offset: float = 0.0,
        void: float | None = None,
        wraps: bool = False,
    ) -> None: ...
    @property
    def rows(self) -> int: ...
    @property
    def columns(self) -> int: ...
    @property
    def cell_width(self) -> float: ...
    @property
    def cell_height(self) -> float: ...
    @property
    def sample(self) -> SampleType: ...
    @property
    def byte_order(self) -> ByteOrder: ...
    @property
    def offset(self) -> int: ...
    @property
    def row_stride(self) -> int: ...
    @property
    def scale(self) -> float: ...
    @property
    def value_offset(self) -> float: ...
    @property
    def void(self) -> float | None: ...
    @property
    def wraps(self) -> bool: ...
    @property
    def samples(self) -> int:
        """rows x columns."""
    @property
    def triangles(self) -> int:
        """Two a cell; a grid that wraps has a cell more in each row."""
    @property
    def byte_length(self) -> int:
        """Bytes that a file or buffer must hold at the least, ``offset`` included."""

@final
class GridRange:
    """The lowest and the highest sample of a grid, and where they lie."""

    @property
    def minimum(self) -> float:
        """Metres."""
    @property
    def minimum_cell(self) -> tuple[int, int]:
        """(column, row); the first one in file order."""
    @property
    def maximum(self) -> float:
        """Metres."""
    @property
    def maximum_cell(self) -> tuple[int, int]: ...
    @property
    def voids(self) -> int:
        """How many samples are void."""

@final
class Grid:
    """An elevation grid whose samples stay where they lie: nothing is copied or converted.

    Every cell is split by the diagonal from (column, row) to (column + 1, row + 1). A triangle
    with a void corner is absent.
    """

    @staticmethod
    def open(path: str | os.PathLike[str], layout: GridLayout) -> Grid:
        """Map a file read-only.

        Raises:
            GridError: the file cannot be read, or is shorter than the layout says.
        """
    @staticmethod
    def from_buffer(buffer: Buffer, layout: GridLayout) -> Grid:
        """Use any C-contiguous Python buffer, which is held (and so locked) until the grid is freed.

        For files, ``open`` is better: it survives a file that is cut while in use, and a buffer that is
        itself a mapped file (``mmap``) does not.

        Raises:
            GridError: the buffer is not contiguous, or is shorter than the layout says.
        """
    @property
    def layout(self) -> GridLayout: ...
    @property
    def damaged(self) -> bool:
        """Whether the mapped file was cut while in use; the lost samples read as zero bytes.

        A file that was cut and has grown again in between is not noticed.
        """
    def elevation(self, column: int, row: int) -> float | None:
        """The sample in metres; ``None`` where it is void or off the map."""
    def elevation_at(self, east: float, north: float) -> float | None:
        """The height of the triangulated surface in metres; ``None`` in a hole or off the map."""
    def elevations(self, columns: Sequence[int], rows: Sequence[int]) -> memoryview:
        """The samples at ``rows`` x ``columns``, row-major, as doubles (format ``d``), NaN where void.

        On a grid that wraps, columns may lie beyond the last one.
        """
    def range(self) -> GridRange | None:
        """Scan the whole grid (without the GIL); ``None`` where every sample is void."""
    def filled(self, progress: Progress | None = None) -> Grid:
        """A packed copy in memory whose holes are filled from what surrounds them (without the GIL).

        Samples that are known keep their very bits. A made-up height is within the range of its own hole's
        rim. A grid without any height stays as it is. Takes twelve more bytes a sample meanwhile.

        Raises:
            CancelledError: ``progress`` was asked to end.
            DecodeError: there is not enough memory, or the mapped file was cut.
        """

@final
class Contact:
    """What one update of a contact model found."""

    @property
    def proxy(self) -> Vector:
        """Terrain frame, metres (east, north, up)."""
    @property
    def feature(self) -> Feature:
        """What the proxy lies on."""
    @property
    def in_contact(self) -> bool: ...
    @property
    def normal(self) -> Vector:
        """Unit vector from the goal to the proxy in the workspace; (0, 0, 1) where they coincide."""
    @property
    def distance(self) -> float:
        """Workspace metres between proxy and goal."""
    @property
    def vertices(self) -> int:
        """Vertices visited by constrained minimisation (paper 4.4)."""
    @property
    def faces(self) -> int:
        """Triangles that the surface walk looked at to find its way."""
    @property
    def collision_tests(self) -> int:
        """Free-space minimisations begun, each one collision test (paper 4.4)."""
    @property
    def cells(self) -> int:
        """Grid cells that the collision tests went through (paper 3.5)."""
    @property
    def far_edge_crossings(self) -> int: ...
    @property
    def far_edge_loops(self) -> int: ...
    @property
    def cycles_ended(self) -> int:
        """Free space re-entered from a vertex already left in the same update; not in the paper."""
    @property
    def steps_left(self) -> int:
        """Cells still between proxy and goal when the step budget ran out; 0 where the update finished."""

@final
class ContactModel:
    """A contact model without a servo, for comparisons and scripts.

    Args:
        grid: what is touched.
        model: one of ``MODELS``.
        scale: workspace metres per metre of terrain.
        exaggeration: of heights; it changes which point is nearest, as in the paper.
        step_budget: steps (vertices, faces or changes of constraints, and free-space cells) that one update
            may take, at least 64; ``None`` is the model's default. What is left is walked in the next updates.
            The floor of ``virtual_proxy`` is 100: it raises a smaller budget to that.
        sub_step: of ``surface_walk`` only: within an update the goal moves no further than this many cells at a
            time, which follows a fast hand more faithfully and costs time; at least 0.01; ``None`` moves it in
            one step.
        radius: of ``virtual_proxy`` only: of its sphere, workspace metres; ``None`` is half a cell's width. A
            sphere whose shadow has more cells than a quarter of the step budget is made as small as the budget
            can look at, silently: the property ``radius`` tells how large it is.

    Raises:
        ValueError: naming what was given, and what was expected; a knob that the model does not have too.
    """

    def __init__(
        self,
        grid: Grid,
        model: str = "surface_walk",
        *,
        scale: float = 1.0,
        exaggeration: float = 1.0,
        step_budget: int | None = None,
        sub_step: float | None = None,
        radius: float | None = None,
    ) -> None: ...
    @property
    def name(self) -> str:
        """One of ``MODELS``."""
    @property
    def step_budget(self) -> int:
        """The budget in force: as given, or the model's floor (100 steps for ``virtual_proxy``, 64 for others)."""
    @property
    def radius(self) -> float | None:
        """Of the sphere as it touches, workspace metres: as given, or as large as the budget can look at.

        ``None`` for models whose proxy is a point.
        """
    def place(self, east: float, north: float, up: float) -> None:
        """Put the proxy there, out of contact (terrain frame, metres)."""
    def update(self, east: float, north: float, up: float) -> Contact:
        """Move the proxy toward the goal (terrain frame, metres). Never raises for NaN: the proxy stays."""
    def follow(self, goals: Buffer) -> Contacts:
        """``update`` for one goal after the other, at once (without the GIL).

        Args:
            goals: n x 3 doubles, C-contiguous: east, north and up of each (terrain frame, metres).

        Raises:
            ValueError: the buffer holds something else.
        """

@final
class Contacts:
    """What the updates of ``ContactModel.follow`` found, a column of doubles for each quantity."""

    columns: tuple[str, ...]
    """``proxy_east proxy_north proxy_up spring_x spring_y spring_z feature vertices faces collision_tests cells
    far_edge_crossings steps_left`` (spring: workspace metres from the goal to the proxy; feature: 0 free, 1 face,
    2 edge, 3 vertex; the rest as in ``Contact``)."""
    def __len__(self) -> int: ...
    def column(self, name: str) -> memoryview:
        """One value an update, format ``d``. Raises KeyError for an unknown name."""

@final
class ScriptedDevice:
    """Plays a path: (seconds, x, y, z) in the workspace frame, straight lines between.

    Times must rise. Before the first and after the last point the hand stays there.
    The force is taken and shown, and changes nothing.

    Args:
        workspace: width, depth and height that the hand can reach, metres.
        handle: (seconds, radians, buttons): how far the handle is turned about the vertical, counter-clockwise
            seen from above and evenly from point to point, and which buttons are down from then on, a bit each
            (1 is the stylus button; before the first point none is). Left out, there is no handle.
        by_velocity: x, y and z push a puck that springs back, from -1 to 1, as a SpaceMouse has; the hand moves
            with up to 0.08 m/s, stays in the workspace, and gives way to the force by 0.2 m/s for a newton. It
            begins in the middle, at the upper end of the workspace. Radians twist the puck: the handle turns by
            3 rad/s for each.
    """

    def __init__(
        self,
        path: Sequence[tuple[float, float, float, float]],
        *,
        workspace: Vector = (0.16, 0.12, 0.12),
        handle: Sequence[tuple[float, float, int]] = (),
        by_velocity: bool = False,
    ) -> None: ...
    @property
    def workspace(self) -> Vector:
        """Width, depth and height that the hand can reach, metres."""

@final
class SimulatedDevice:
    """A hand: a mass on a muscle spring and a damper, following a target, pushed by the force.

    Args:
        target: where the muscle pulls at first, and where the hand starts (workspace metres). Under the ground it
            touches nothing until it has been above.
        mass: kilograms. muscle_stiffness: N/m. damping: N s/m. max_force: N.
    """

    def __init__(
        self,
        *,
        target: Vector = (0.0, 0.0, 0.05),
        mass: float = 0.1,
        muscle_stiffness: float = 300.0,
        damping: float = 8.0,
        max_force: float = 8.0,
        workspace: Vector = (0.16, 0.12, 0.12),
    ) -> None: ...
    @property
    def workspace(self) -> Vector: ...

@final
class PlaybackDevice:
    """Plays a hand that was recorded, straight and evenly between its ticks, at any speed, live or stepped.

    It begins with its first tick when it is first read. Stepped at speed 1, a take that was stepped is read tick by
    tick to the bit, so that the same contact model gives the same proxy to the bit; another one can be compared on
    the same motion. Past the last tick the hand rests there, the force is zero, and ``State.held`` is ``finished``.
    It takes every force and does not move by it.

    A take should begin above the ground, as every touch does: where its first tick is under it, nothing is felt
    until the hand has been above.

    Args:
        times: seconds, rising. hand_x, hand_y, hand_z: workspace metres. buttons, twist: as columns of a take have
            them; no button is down, and no turn told, where they are left out. All are buffers of doubles, or any
            sequences of numbers, and equally long.
        speed: from 0.1 to 100 times as fast as the times say.
        workspace: width, depth and height, metres.

    Raises:
        ValueError: naming what cannot be played, and where.
    """

    def __init__(
        self,
        times: Buffer | Sequence[float],
        hand_x: Buffer | Sequence[float],
        hand_y: Buffer | Sequence[float],
        hand_z: Buffer | Sequence[float],
        *,
        buttons: Buffer | Sequence[float] | None = None,
        twist: Buffer | Sequence[float] | None = None,
        speed: float = 1.0,
        workspace: Vector = (0.16, 0.12, 0.12),
    ) -> None: ...
    @staticmethod
    def of_take(take: Take, *, speed: float = 1.0) -> PlaybackDevice:
        """Lead the goal where it went in a take, in the window ``window``, which the session must be given.

        That is the window of the take's first tick, and it stays, whatever pans and zooms were done in the take: so
        every contact model touches the same ground. The session should have neither ``modes`` nor ``walls``. The
        hand is the recorded one, to the bit, wherever it leads to the recorded goal through this window; elsewhere
        the one that does. What a zoom changes is how large the hand's motion is, and with it the force; neither zoom
        nor pan changes what is nearest on the ground. Where the window was laid elsewhere in mid-take, the hand goes
        there within a tick.

        Raises ValueError: the take is empty, or its window or workspace cannot be.
        """
    @property
    def workspace(self) -> Vector: ...
    @property
    def seconds(self) -> float:
        """That it plays, at its speed."""
    @property
    def finished(self) -> bool:
        """Whether a session has gone past the last tick."""
    @property
    def window(self) -> Window | None:
        """Where the session's workspace must lie; ``None`` where the hand was not that of a take."""

@final
class Window:
    """The workspace frame laid over the terrain. Immutable.

    Args:
        east, north: terrain metres under the workspace's origin.
        up: elevation in metres at the workspace's z = 0.
        width: metres of terrain across the width of the device's workspace; positive.
        exaggeration: of heights, the same for eye and hand; positive.
        turn: radians from east to the workspace's x, counter-clockwise seen from above. A hand at (x, y) is
            over ``east + s (x cos(turn) - y sin(turn))``, ``north + s (x sin(turn) + y cos(turn))``, where ``s``
            is ``width`` over the workspace's width.
    """

    def __init__(
        self,
        east: float,
        north: float,
        up: float,
        *,
        width: float,
        exaggeration: float = 1.0,
        turn: float = 0.0,
    ) -> None: ...
    @property
    def east(self) -> float: ...
    @property
    def north(self) -> float: ...
    @property
    def up(self) -> float: ...
    @property
    def width(self) -> float: ...
    @property
    def exaggeration(self) -> float: ...
    @property
    def turn(self) -> float: ...

@final
class State:
    """The newest tick of a session."""

    @property
    def tick(self) -> int:
        """Ticks done since the session was made."""
    @property
    def time(self) -> float:
        """Seconds on the session's clock, which stands while the session does.

        A step takes a thousandth; live, it is measured where the tick began.
        """
    @property
    def hand(self) -> Vector:
        """Workspace frame, metres."""
    @property
    def goal(self) -> Vector:
        """The hand in the terrain frame: the haptic interface point."""
    @property
    def proxy(self) -> Vector:
        """Terrain frame; of ``virtual_proxy`` the sphere's centre, which lies above the ground."""
    @property
    def feature(self) -> Feature:
        """What the proxy lies on; in pan mode, what the point that is held lies on."""
    @property
    def in_contact(self) -> bool: ...
    @property
    def force(self) -> Vector:
        """Newtons, workspace frame, as sent to the device."""
    @property
    def held(self) -> Held | None:
        """Why the force is away, or not yet wholly back; ``None`` where nothing holds it."""
    @property
    def mode(self) -> Mode:
        """What the hand's motion does: touch the surface, push it along, or bring it nearer and turn it."""
    @property
    def window(self) -> Window:
        """Where the workspace lies: pan and zoom move it, and momentum after a pan."""
    @property
    def model(self) -> str:
        """The contact model in charge, one of ``MODELS``."""

@final
class Statistics:
    """Counts since the session was made."""

    @property
    def ticks(self) -> int: ...
    @property
    def missed_ticks(self) -> int:
        """Deadlines that passed while the thread was late; they are skipped, never caught up."""
    @property
    def contact_ticks(self) -> int: ...
    @property
    def vertices(self) -> int: ...
    @property
    def faces(self) -> int: ...
    @property
    def collision_tests(self) -> int: ...
    @property
    def cells(self) -> int: ...
    @property
    def far_edge_crossings(self) -> int: ...
    @property
    def far_edge_loops(self) -> int: ...
    @property
    def cycles_ended(self) -> int: ...
    @property
    def unfinished(self) -> int:
        """Updates that ended with steps left over."""
    @property
    def not_finite(self) -> int:
        """Ticks whose pose or force was not finite: answered with zero force."""
    @property
    def device_errors(self) -> int:
        """Reads and writes that the device failed: answered with zero force."""
    @property
    def speed_cuts(self) -> int:
        """Times that the hand was faster than ``max_speed``: zero force until it has been slow for 50 ms."""
    @property
    def host_cuts(self) -> int:
        """Times that nobody looked for ``stale_after`` seconds: no force until someone looks."""
    @property
    def late_cuts(self) -> int:
        """Times that two or more ticks in a row were missed: no force until 10 ms were punctual."""
    @property
    def clamped(self) -> int:
        """Ticks whose force was cut to the limit."""
    @property
    def ramped(self) -> int:
        """Ticks whose force was held back because touch had just begun, or the force just came back."""
    @property
    def slew_limited(self) -> int:
        """Ticks whose force was not yet what it should be, because it may change only so fast."""
    @property
    def engaged(self) -> int:
        """Times that the proxy was placed at the hand."""
    @property
    def active_ticks(self) -> int:
        """Ticks in which the spring had given the hand more energy than it took (passivity observer)."""
    @property
    def mode_changes(self) -> int: ...
    @property
    def dropped(self) -> int:
        """Ticks that found the ring full; they are lost to ``drain``. A take counts its own: ``Take.dropped``."""
    @property
    def goal_cells(self) -> float:
        """Cells that the goal travelled over the ground, summed over the ticks."""
    def update_us(self, quantile: float) -> float:
        """Microseconds from the device's read to its write (bucket error below 7%).

        Raises ValueError for a quantile outside 0 to 1.
        """
    @property
    def mean_load(self) -> float:
        """The share of a millisecond that live ticks take, from wake-up to sleep, mean; 0 before the first."""
    def load(self, quantile: float) -> float:
        """The same as a quantile."""
    def late_us(self, quantile: float) -> float:
        """Microseconds from deadline to wake-up, live ticks only. Quantiles as above."""

@final
class Ticks:
    """Every tick since the last drain, a column of doubles for each quantity."""

    columns: tuple[str, ...]
    """``tick time hand_x hand_y hand_z goal_east goal_north goal_up proxy_east proxy_north proxy_up
    force_x force_y force_z feature vertices faces collision_tests cells mode window_east window_north window_up
    window_width window_exaggeration window_turn normal_x normal_y normal_z buttons twist``; see ``Take.columns``."""
    def __len__(self) -> int: ...
    def column(self, name: str) -> memoryview:
        """One value a tick, format ``d``. Raises KeyError for an unknown name."""

@final
class Recording:
    """How far a take has come."""

    @property
    def ticks(self) -> int:
        """In memory; a live session's are collected every 50 ms."""
    @property
    def seconds(self) -> float:
        """From the first tick to the last."""
    @property
    def dropped(self) -> int:
        """Ticks that were done and are not in the take: the ring was full, or memory."""
    @property
    def spool(self) -> Path | None:
        """Where the take is spooled to."""
    @property
    def spooled(self) -> int:
        """Ticks that the spool has: the end of this process does not take them from it.

        Of a live session all but the last tenth of a second, of a stepped one all but the last 999. The disk is made
        to keep them every half second, should the power fail.
        """
    @property
    def spool_failure(self) -> str | None:
        """Why the spool gets no more, in the system's words, as for a full disk; memory goes on."""

@final
class Take:
    """Recorded touch: every tick, 192 bytes of memory each (11.5 MB a minute), 188 on the disk (11.3 MB)."""

    columns: tuple[str, ...]
    """``tick time hand_x hand_y hand_z goal_east goal_north goal_up proxy_east proxy_north proxy_up
    force_x force_y force_z feature mode window_east window_north window_up window_width window_exaggeration
    window_turn normal_x normal_y normal_z buttons twist``.

    ``tick`` counts the session's ticks: a step of more than 1 is a loss. ``time`` is in seconds on the session's
    clock. ``hand`` is in the workspace frame, metres; ``goal``, the hand, and ``proxy`` in the terrain frame, metres;
    ``force`` in newtons, workspace frame, as sent to the device. ``feature``: 0 free, 1 face, 2 edge, 3 vertex;
    ``mode``: 0 normal, 1 pan, 2 zoom. ``window``: see Window. ``normal`` is the unit vector from hand to proxy, the
    normal of a surface without friction, in the workspace frame (turned with the window, heights exaggerated); zero
    in free space, in pan mode as when the surface was grabbed; floats of 32 bits in a take. ``buttons``: a bit each,
    the first is the stylus button, also where ``Session.press`` pressed it. ``twist`` is the turn of the handle,
    radians; 0 where the device does not tell."""
    def __len__(self) -> int: ...
    def column(self, name: str) -> memoryview:
        """One value a tick, format ``d``. Raises KeyError for an unknown name."""
    @property
    def seconds(self) -> float:
        """From the first tick to the last."""
    @property
    def about(self) -> str:
        """The text that ``Session.start_recording`` was given."""
    @property
    def workspace(self) -> Vector:
        """Width, depth and height of the device's workspace, metres."""
    @property
    def pre_roll(self) -> int:
        """How many of the first ticks were felt before recording was asked for."""
    @property
    def dropped(self) -> int:
        """Ticks that were done meanwhile and are not in the take."""
    @property
    def finished(self) -> bool:
        """Whether recording came to its end: not of a file whose program ended before, nor of what ``recorded`` gives."""
    @property
    def lost(self) -> str | None:
        """What of a file was not read, in words: it was cut short or is damaged. ``None`` where it is whole."""
    @property
    def spool_failure(self) -> str | None:
        """Why the file that the take was spooled to is not whole, in the system's words; ``None`` where it is."""
    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a whole take to a file, over what was there.

        Raises OSError; what was there is there still then.
        """
    def discard_spool(self) -> None:
        """Remove the file that the take was spooled to, or was claimed from; harmless where there is none.

        Raises OSError.
        """
    def release_spool(self) -> None:
        """Leave that file where it is, to be claimed by whoever wants it.

        Until one of these is called, or the take is garbage, nobody can claim it. Harmless where there is none.
        """

def read_take(path: str | os.PathLike[str]) -> Take:
    """Read a take's file (``.touch``) up to its last whole block; ``Take.lost`` says what was not read.

    Also one that is being recorded. Raises TakeError: it is no take, of a newer version, or cut or damaged in its
    header; OSError.
    """

def claim_take(path: str | os.PathLike[str]) -> Take:
    """Read a spool that a process left when it ended, and let no other process do the same: see ``discard_spool``.

    Raises TakeInUseError: it is being recorded, or was claimed. TakeError and OSError as above.
    """

@final
class Session:
    """A grid, a device and a contact model in one loop: 1 kHz live, or stepped.

    Forces: a spring from the hand to the proxy, behind a chain of safety stages. The force is never above
    ``max_force``; it rises from nothing in 50 ms when touch begins, and changes by no more than ``max_slew``;
    after a switch of models or modes by no more than ``max_force`` in 50 ms until it is what is wanted then. It is
    zero while something is wrong (see ``State.held``), and comes back over as long as it was away, 50 ms to half
    a second. Zero force is the last thing that the device gets, however the session ends; dropping the object
    stops the thread too.

    Modes, where ``modes`` is true (the terrain never moves, the window does): the stylus button pressed in contact
    grabs the surface and pans it, held at its height, with inertia; let go in motion it drifts on, until friction, a
    wall or what it does to the hand has taken its momentum. Pressed in the air it holds the hand in its place and
    zooms with its height, with detents where the window is a power of 2 of the whole map's width, and turns the
    surface with the handle about the cursor. A button that is down while touch begins does nothing until it was up.

    Args:
        grid: what is touched. device: is taken over; a device serves one session.
        window: where the workspace lies.
        stiffness: of the spring, N/m; cut to what the device can show (see ``warnings``).
        max_force: N; the device's own limit holds too, without a word (see the property). ring_seconds: ticks kept for ``drain``.
        max_slew: N/s; ``None`` is the device's own limit. From nothing to ``max_force`` takes 5 ms at least.
        max_speed: of the hand, m/s, beyond which the handle counts as slipped and there is no force; ``None``
            is the device's own limit.
        stale_after: seconds; a session that runs live gives no force while neither ``state`` nor ``heartbeat`` is
            called for longer than this. For programs that draw what is felt, and may stall; ``None``, for scripts
            that start a session and sleep, never waits for anyone. Steps wait for nobody either.
        real_time: whether a live session asks the system for real-time priority; see ``priority``.
        walls: whether four walls keep the hand in the middle 90% of the workspace's width and depth. For whoever
            holds a device; a script's hand goes where the script wants.
        modes: whether the stylus button changes the mode. For whoever holds a device.
        pan_mass: of the surface in pan mode, kg. drift_time: seconds in which friction takes a drifting surface to
            1/e of its speed. zoom_travel: metres up that halve the window's width. detent_force: the largest, N.
        zoom_widths: the narrowest and the widest window that zoom leads to, metres of terrain; ``None`` is 4 cells
            and twice the whole map.
        model, step_budget, sub_step: see ContactModel.
        radius: of ``virtual_proxy`` only: of its sphere, workspace metres; ``None`` is 1 mm (a ContactModel alone
            knows no hand, and takes half a cell).

    Raises:
        ValueError: naming the name or number that cannot be used; the device is not taken then.
        SessionError: the device already serves a session.
    """

    def __init__(
        self,
        grid: Grid,
        device: ScriptedDevice | SimulatedDevice | PlaybackDevice,
        window: Window,
        *,
        stiffness: float = 500.0,
        max_force: float = 8.0,
        ring_seconds: float = 60.0,
        max_slew: float | None = None,
        max_speed: float | None = None,
        stale_after: float | None = None,
        real_time: bool = True,
        walls: bool = False,
        modes: bool = False,
        pan_mass: float = 0.2,
        drift_time: float = 0.5,
        zoom_travel: float = 0.02,
        detent_force: float = 0.4,
        zoom_widths: tuple[float, float] | None = None,
        model: str = "surface_walk",
        step_budget: int | None = None,
        sub_step: float | None = None,
        radius: float | None = None,
    ) -> None: ...
    def start(self) -> None:
        """Run at 1 kHz on a thread of its own. Raises SessionError when it already runs or has faulted."""
    def stop(self) -> None:
        """Send zero force and join the thread; harmless when it does not run.

        The next start or step begins with the proxy at the hand: under the ground there is no force.
        """
    def step(self, count: int) -> None:
        """Do ticks of 1 ms here and now, deterministically; Ctrl-C ends it early.

        Raises SessionError while live or after a fault.
        """
    @property
    def running(self) -> bool: ...
    @property
    def fault(self) -> str | None:
        """Why touch ended by itself, in words; ``None`` where it did not."""
    @property
    def stiffness(self) -> float:
        """Of the spring, N/m, after the device's limit."""
    @property
    def max_force(self) -> float:
        """The largest force, N, after the device's limit."""
    @property
    def max_slew(self) -> float:
        """The fastest change of the force, N/s, after the device's limit."""
    @property
    def max_speed(self) -> float:
        """The fastest hand, m/s, after the device's limit; infinite where nothing limits it."""
    @property
    def priority(self) -> str:
        """How the system schedules the live thread: ``real-time``, or ``normal``, and in the system's words why.

        Linux grants real-time priority to root, to CAP_SYS_NICE, or up to a limit (``ulimit -r``).
        """
    @property
    def locked_memory(self) -> tuple[int, int]:
        """Bytes that the system keeps in memory for the live thread, and bytes that it refused to.

        The thread's stack, and the state and rings that it was started with, never the grid. Beyond ``ulimit -l``
        it refuses; ticks may then meet a page that was taken away. After ``stop``, what it last was.
        """
    def warnings(self) -> list[str]:
        """What the safety chain did so far, why, and what to do about it: a sentence each, the gravest first.

        Why touch ended by itself is not among them: see ``fault``.
        """
    def heartbeat(self) -> None:
        """Whoever must look at a live session is still there; ``state`` says so too. See ``stale_after``."""
    @property
    def window(self) -> Window:
        """Where pan and zoom have moved the workspace, or where ``set_window`` will have it."""
    def set_window(self, window: Window) -> None:
        """Lay the workspace elsewhere from the next tick on.

        The proxy begins anew at the hand, in normal mode, over a surface at rest. Where that is under the ground
        there is no force until the hand has been above (``State.held`` is ``below``).
        """
    def press(self) -> None:
        """Press the stylus button, as a key does for every device; it stays down until ``release``.

        This, ``release`` and ``set_mode`` raise SessionError where the session has no ``modes``, or too many commands
        wait already.
        """
    def release(self) -> None:
        """Release what ``press`` pressed."""
    def set_mode(self, mode: Mode) -> None:
        """Change the mode from the next tick on, whatever the button says.

        It stays until ``normal`` is asked for, or touch begins anew. Pan in the air holds the point at the hand.

        Raises ValueError for another name.
        """
    def set_twist(self, radians: float) -> None:
        """Turn the simulated handle about the vertical, counter-clockwise seen from above; others ignore it.

        Raises ValueError for a number that is not finite.
        """
    @property
    def model(self) -> str:
        """The contact model that was chosen last, one of ``MODELS``."""
    def set_model(
        self,
        model: str,
        *,
        step_budget: int | None = None,
        sub_step: float | None = None,
        radius: float | None = None,
    ) -> None:
        """Let another contact model answer from the next tick on, also in mid-touch; see ContactModel.

        It goes on from where the proxy is, and the force follows without a jolt. A knob that is left out is
        the default again.

        Raises ValueError as the constructor does, SessionError when too many commands wait already.
        """
    def set_passivity_control(self, controls: bool) -> None:
        """Whether damping is added from the next tick on while ``Statistics.active_ticks`` grows. Off at first.

        Hannaford and Ryu, 2002. Counts on the damping that the device declares by its stiffness. Raises
        SessionError where too many commands wait for a live session already.
        """
    def set_target(self, x: float, y: float, z: float) -> None:
        """Where the simulated hand is pulled (workspace metres); other devices ignore it.

        Raises ValueError for a number that is not finite.
        """
    def state(self) -> State: ...
    def statistics(self) -> Statistics: ...
    def drain(self) -> Ticks:
        """Every tick since the last drain, as far as the ring took them.

        While a take is recorded or a pre-roll is kept, the ring is emptied for these: then the newest ticks, up to
        ``ring_seconds``.
        """
    def set_pre_roll(self, seconds: float) -> None:
        """Keep that many seconds of ticks from now on, up to an hour, for a take to begin with; 0 ends that.

        Raises ValueError for another number, SessionError where there is no thread to be had.
        """
    def start_recording(self, about: str = "", *, spool: str | os.PathLike[str] | None = None) -> None:
        """Keep every tick from the next one on, and those of the pre-roll.

        Of a live session a thread does that, whatever Python does; between steps it is done by ``step``, which
        loses none however many are done at a time. It goes on over ``stop`` and ``start``.

        Args:
            about: a text to be kept with the take, JSON by custom, at most 1 MiB.
            spool: a new file to which the take is written meanwhile, so that a crash loses a tenth of a second; at
                ``stop_recording`` it becomes a whole take. No other process can claim it meanwhile. Without it the
                take is in memory only.

        Raises:
            SessionError: a take is recorded already.
            OSError: the file is there already, or cannot be made; nothing is recorded then.
            ValueError: ``about`` is too long.
        """
    @property
    def recording(self) -> Recording | None:
        """How far the take has come; ``None`` where none is recorded."""
    def recorded(self) -> Take:
        """The take as far as it has come; it shares its memory. Raises SessionError where none is recorded."""
    def stop_recording(self) -> Take:
        """End the take, also after a fault. Raises SessionError where none is recorded."""
