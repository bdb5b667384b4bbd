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
Held = Literal["host", "late", "speed", "device", "not_finite"]
Vector = tuple[float, float, float]

class GridError(ValueError):
    """A layout, a file or a buffer cannot be used as a grid; the text says what was found and expected."""

class SessionError(RuntimeError):
    """A session was used in a state that does not allow the call (started twice, stepped while live)."""

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

@final
class ScriptedDevice:
    """Plays a path: (seconds, x, y, z) in the workspace frame, straight lines between.

    Times must rise. Before the first and after the last point the hand stays there.
    The force is taken and shown, and changes nothing.
    """

    def __init__(
        self, path: Sequence[tuple[float, float, float, float]], *, workspace: Vector = (0.16, 0.12, 0.12)
    ) -> None: ...
    @property
    def workspace(self) -> Vector:
        """Width, depth and height that the hand can reach, metres."""

@final
class SimulatedDevice:
    """A hand: a mass on a muscle spring and a damper, following a target, pushed by the force.

    Args:
        target: where the muscle pulls at first, and where the hand starts (workspace metres).
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
class Window:
    """The workspace frame laid over the terrain. Immutable.

    Args:
        east, north: terrain metres under the workspace's origin.
        up: elevation in metres at the workspace's z = 0.
        width: metres of terrain across the width of the device's workspace; positive.
        exaggeration: of heights, the same for eye and hand; positive.
    """

    def __init__(
        self, east: float, north: float, up: float, *, width: float, exaggeration: float = 1.0
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
        """Terrain frame."""
    @property
    def feature(self) -> Feature: ...
    @property
    def in_contact(self) -> bool: ...
    @property
    def force(self) -> Vector:
        """Newtons, workspace frame, as sent to the device."""
    @property
    def held(self) -> Held | None:
        """Why the force is away, or not yet wholly back; ``None`` where nothing holds it."""
    @property
    def mode(self) -> Literal["normal"]: ...
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
    def dropped(self) -> int:
        """Ticks that found the ring full; they are lost to recordings."""
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
    force_x force_y force_z feature vertices faces collision_tests cells`` (feature: 0 free, 1 face, 2 edge,
    3 vertex)."""
    def __len__(self) -> int: ...
    def column(self, name: str) -> memoryview:
        """One value a tick, format ``d``. Raises KeyError for an unknown name."""

@final
class Session:
    """A grid, a device and a contact model in one loop: 1 kHz live, or stepped.

    Forces: a spring from the hand to the proxy, behind a chain of safety stages. The force is never above
    ``max_force``; it rises from nothing in 50 ms when touch begins, and changes by no more than ``max_slew``;
    after a switch of models by no more than ``max_force`` in 50 ms until it is what the new model wants. It is
    zero while something is wrong (see ``State.held``), and comes back over as long as it was away, 50 ms to half
    a second. Zero force is the last thing that the device gets, however the session ends; dropping the object
    stops the thread too.

    Args:
        grid: what is touched. device: is taken over; a device serves one session.
        window: where the workspace lies.
        stiffness: of the spring, N/m; cut to what the device can show (see ``warnings``).
        max_force: N; the device's own limit holds too. ring_seconds: ticks kept for ``drain``.
        max_slew: N/s; ``None`` is the device's own limit. From nothing to ``max_force`` takes 5 ms at least.
        max_speed: of the hand, m/s, beyond which the handle counts as slipped and there is no force; ``None``
            is the device's own limit.
        stale_after: seconds; a session that runs live gives no force while neither ``state`` nor ``heartbeat`` is
            called for longer than this. For programs that draw what is felt, and may stall; ``None``, for scripts
            that start a session and sleep, never waits for anyone. Steps wait for nobody either.
        real_time: whether a live session asks the system for real-time priority; see ``priority``.
        model, step_budget, sub_step: see ContactModel.
        radius: of ``virtual_proxy`` only: of its sphere, workspace metres; ``None`` is 1 mm.

    Raises:
        ValueError: naming the name or number that cannot be used; the device is not taken then.
        SessionError: the device already serves a session.
    """

    def __init__(
        self,
        grid: Grid,
        device: ScriptedDevice | SimulatedDevice,
        window: Window,
        *,
        stiffness: float = 500.0,
        max_force: float = 8.0,
        ring_seconds: float = 60.0,
        max_slew: float | None = None,
        max_speed: float | None = None,
        stale_after: float | None = None,
        real_time: bool = True,
        model: str = "surface_walk",
        step_budget: int | None = None,
        sub_step: float | None = None,
        radius: float | None = None,
    ) -> None: ...
    def start(self) -> None:
        """Run at 1 kHz on a thread of its own. Raises SessionError when it already runs or has faulted."""
    def stop(self) -> None:
        """Send zero force and join the thread; harmless when it does not run."""
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
        """What the safety chain did so far, why, and what to do about it: a sentence each, the gravest first."""
    def heartbeat(self) -> None:
        """Whoever must look at a live session is still there; ``state`` says so too. See ``stale_after``."""
    @property
    def window(self) -> Window: ...
    def set_window(self, window: Window) -> None:
        """Lay the workspace elsewhere from the next tick on; the proxy begins anew at the hand."""
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
    def drain(self) -> Ticks: ...
