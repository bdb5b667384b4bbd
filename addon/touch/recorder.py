"""The ticks of a take, as the native recorder has them; without Blender."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from proxygraph import Session, SessionError, Take


@dataclass
class TakeColumns(Mapping[str, memoryview]):
    """Columns of doubles by name (see ``proxygraph.Take.columns``), each read when it is first asked for."""

    take: Take
    read: dict[str, memoryview] = field(default_factory=dict)

    def __getitem__(self, name: str) -> memoryview:
        if name not in self.read:
            self.read[name] = self.take.column(name)
        return self.read[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.take.columns)

    def __len__(self) -> int:
        return len(self.take.columns)


@dataclass
class Recorder:
    """Ticks in the order in which they were felt: of a session that records, or of a take that has ended."""

    session: Session | None
    """That records; ``None`` once the take has ended."""
    ended: TakeColumns | None = None

    @property
    def columns(self) -> TakeColumns:
        """Of the take as far as it has come."""
        if self.ended is not None:
            return self.ended
        return TakeColumns(self._session.recorded())

    def __len__(self) -> int:
        if self.ended is not None:
            return len(self.ended.take)
        recording = self._session.recording
        return 0 if recording is None else recording.ticks

    @property
    def seconds(self) -> float:
        """From the first tick to the last."""
        if self.ended is not None:
            return self.ended.take.seconds
        recording = self._session.recording
        return 0.0 if recording is None else recording.seconds

    @property
    def dropped(self) -> int:
        """Ticks that were felt meanwhile and are not in the take."""
        if self.ended is not None:
            return self.ended.take.dropped
        recording = self._session.recording
        return 0 if recording is None else recording.dropped

    @property
    def spool_failure(self) -> str | None:
        """Why the take is in memory only, in the system's words; ``None`` where it is not."""
        if self.ended is not None:
            return self.ended.take.spool_failure
        recording = self._session.recording
        return None if recording is None else recording.spool_failure

    def end(self) -> Take:
        """End the take; harmless where it has ended."""
        if self.ended is None:
            self.ended = TakeColumns(self._session.stop_recording())
            self.session = None
        return self.ended.take

    @property
    def _session(self) -> Session:
        if self.session is None:
            raise SessionError("no take is being recorded")
        return self.session
