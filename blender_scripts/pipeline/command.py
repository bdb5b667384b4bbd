"""A script that people put into pipelines: arguments, exit codes, and a summary in JSON."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

DONE, FAILED, REFUSED = 0, 1, 2
"""Exit codes: all is written; it could not be done or written; arguments or input cannot be used."""

EPILOG = """\
exit codes: 0 all is written; 1 it could not be done or written; 2 arguments or input cannot be used.
The summary is one line of JSON on the standard output; all else goes to the error output. With Blender
itself: blender -b [scene.blend] --python-exit-code 1 -P this_script.py -- arguments (its own words then stand
on the standard output too: use --summary)."""

Say = Callable[[str], None]


class RefusedError(ValueError):
    """Arguments or input cannot be used; the text says why, and what to do."""


def parser_of(name: str, description: str | None) -> argparse.ArgumentParser:
    """Begin a script's arguments with those that all have."""
    parser = argparse.ArgumentParser(
        prog=name,
        description=description,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--summary", type=Path, metavar="FILE", help="write the summary there instead")
    parser.add_argument(
        "--site", type=Path, metavar="FOLDER", help="of proxygraph and pvl, where Blender lacks them"
    )
    return parser


def own_arguments() -> list[str]:
    """The script's own arguments: in Blender they stand after ``--``."""
    return sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]


def run(
    parser: argparse.ArgumentParser,
    arguments: list[str],
    work: Callable[[argparse.Namespace, Say], Mapping[str, Any]],
) -> int:
    """Do a script's work and write its summary.

    Args:
        work: gives what goes into the summary; raises ``RefusedError`` for what a person can mend.

    Returns:
        An exit code, as in ``EPILOG``.
    """
    chosen = parser.parse_args(arguments)
    if chosen.site is not None:
        sys.path.insert(0, str(chosen.site.resolve()))
    try:
        with _blender_on_the_error_output():
            summary = dict(work(chosen, _teller()))
        _write(chosen.summary, json.dumps(summary, allow_nan=False) + "\n")
    except RefusedError as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return REFUSED
    except (OSError, RuntimeError, MemoryError) as error:
        words = str(error).removeprefix("Error: ").strip() or repr(error)
        print(f"{parser.prog}: {words}", file=sys.stderr)
        return FAILED
    return DONE


def _write(file: Path | None, text: str) -> None:
    if file is None:
        print(text, end="", flush=True)
        return
    beginning = file.with_name(file.name + ".part")
    beginning.write_text(text, encoding="utf-8")
    beginning.replace(file)


def _teller() -> Say:
    began = time.perf_counter()

    def say(text: str) -> None:
        print(f"[{time.perf_counter() - began:5.1f} s] {text}", file=sys.stderr, flush=True)

    return say


@contextmanager
def _blender_on_the_error_output() -> Iterator[None]:
    """Keep the standard output for the summary: Blender's own code writes there, too."""
    sys.stdout.flush()
    standard = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(standard, 1)
        os.close(standard)
