"""Well-known text of coordinate systems: names with arguments in brackets, as a tree.

Source: OGC 01-009, "Coordinate Transformation Services" (2001), section 7 (WKT 1), and ISO 19162, whose
brackets and texts are the same.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

MAXIMUM_LETTERS = 64 << 10
"""Such texts have some 500."""

DEEPEST = 24
"""Brackets within brackets; the longest systems known have 8."""

TOKEN = re.compile(r'\s*(?:"((?:[^"]|"")*)"|([\[\](),])|([^\s"\[\](),]+))')


class WktError(ValueError):
    """A text is no well-known text; says why."""


@dataclass
class WktNode:
    """A name and its arguments."""

    name: str
    """In capitals."""
    arguments: list[WktNode | str | float] = field(default_factory=list)

    def child(self, *names: str) -> WktNode | None:
        """The first argument of one of these names."""
        return next(self.children(*names), None)

    def children(self, *names: str) -> Iterator[WktNode]:
        """Every argument of one of these names."""
        return (node for node in self.arguments if isinstance(node, WktNode) and node.name in names)

    def text(self) -> str:
        """The first argument, where it is a text: what the thing is called."""
        return next((text for text in self.arguments[:1] if isinstance(text, str)), "")

    def number(self, place: int) -> float | None:
        """The number at a place among the arguments, from 0."""
        found = self.arguments[place] if place < len(self.arguments) else None
        return found if isinstance(found, float) else None


def parse_wkt(text: str) -> WktNode:
    """Make the tree of a text.

    Raises:
        WktError: it is not well-known text.
    """
    if len(text) > MAXIMUM_LETTERS:
        raise WktError(f"{len(text):,} letters, at most {MAXIMUM_LETTERS:,} are followed")
    root = WktNode("")
    open_nodes = [root]
    pending: WktNode | None = None
    for kind, word in _tokens(text):
        if kind == "word":
            pending = _argument(open_nodes[-1], word)
        elif kind == "text":
            open_nodes[-1].arguments.append(word)
            pending = None
        elif word in "[(":
            if pending is None or len(open_nodes) > DEEPEST:
                raise WktError("a bracket without a name before it, or too many in one another")
            open_nodes.append(pending)
            pending = None
        elif word in "])":
            if len(open_nodes) == 1:
                raise WktError("a bracket that was not opened")
            open_nodes.pop()
            pending = None
    if len(open_nodes) > 1:
        raise WktError("a bracket that is not closed")
    first = next(root.children(*(node.name for node in root.arguments if isinstance(node, WktNode))), None)
    if first is None or len(root.arguments) != 1:
        raise WktError("not one name with arguments in brackets")
    return first


def _argument(parent: WktNode, word: str) -> WktNode | None:
    """Take a bare word for a number, else for a name whose bracket may follow."""
    try:
        parent.arguments.append(float(word))
    except ValueError:
        node = WktNode(word.upper())
        parent.arguments.append(node)
        return node
    return None


def _tokens(text: str) -> Iterator[tuple[str, str]]:
    place = 0
    text = text.rstrip().rstrip("\0")
    while place < len(text):
        found = TOKEN.match(text, place)
        if found is None:
            raise WktError("a text that does not end")
        place = found.end()
        quoted, mark, word = found.groups()
        if quoted is not None:
            yield "text", quoted.replace('""', '"')
        elif mark is not None:
            yield "mark", mark
        else:
            yield "word", word
