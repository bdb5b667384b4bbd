"""pvl's forgiving parser, which goes round for ever at two equals signs in a row, made to end."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

from pvl.parser import OmniParser


class LabelParser(OmniParser):  # type: ignore[misc]  # pvl has no types
    """The same, but what makes no step forward is refused."""

    def parse_module_post_hook(self, module: Any, tokens: Generator[Any, Any, None]) -> tuple[Any, bool]:
        """Mend an assignment without a value, where that takes a token.

        Raises:
            ValueError: nothing was taken, and the parser would come back to the same token.
        """
        before = _next_place(tokens)
        module, goes_on = super().parse_module_post_hook(module, tokens)
        if goes_on and before is not None and _next_place(tokens) == before:
            raise ValueError(f"nothing can be made of the text at letter {before}")
        return module, goes_on


def _next_place(tokens: Generator[Any, Any, None]) -> int | None:
    """Where in the text the next token is; ``None`` at the end."""
    try:
        token = next(tokens)
    except StopIteration:
        return None
    tokens.send(token)
    return int(token.pos)
