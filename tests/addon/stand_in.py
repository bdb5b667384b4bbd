"""A session, or a take, that behaves in one way as a test wants it, and in all others as itself."""

from __future__ import annotations

from typing import Any


class StandIn:
    """Stands before it; the calls that are given take the place of its own."""

    def __init__(self, session: Any, **calls: Any) -> None:
        self._session = session
        self._calls = calls

    def __len__(self) -> int:
        return len(self._session)

    def __getattr__(self, name: str) -> Any:
        return self._calls[name] if name in self._calls else getattr(self._session, name)
