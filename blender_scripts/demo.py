#!/usr/bin/env python3
"""Touch a planet, live and without a window: import a grid, slide a hand over it at 1 kHz, record, render.

Runs with the bpy module (python demo.py ...) and in Blender (blender -b -P demo.py -- ...). Writes
touch.png, touch.blend and touch.json.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

# Blender does not look for modules beside the script that it runs.
sys.path.insert(0, str(Path(__file__).resolve().parent))

PREVIEW_VERTICES = 1_100_000
"""For the picture: every sample of a grid of 4 cells per degree."""

RESULTS = ("touch.png", "touch.blend", "touch.json")


def main(arguments: list[str]) -> int:
    """Exit code 0 when all is written, 1 where touch ended by itself, 2 for a grid that cannot be used."""
    chosen = _parser().parse_args(arguments)
    if chosen.site is not None:
        sys.path.insert(0, str(chosen.site.resolve()))
    say = _teller()
    grid = chosen.grid or _sample(say)

    # These need bpy and proxygraph, which ``--site`` may have brought within reach only now.
    from touch_demo.extension import enabled_extension
    from touch_demo.live_session import TouchEndedError
    from touch_demo.run import GridRefusedError, run, stage

    try:
        staged = stage(enabled_extension(), grid, PREVIEW_VERTICES, say)
    except GridRefusedError as error:
        print(f"GRID: {error}", file=sys.stderr)
        return 2
    try:
        with _all_or_nothing(chosen.output) as folder:
            print(run(staged, folder, say))
    except TouchEndedError as error:
        print(f"The demo ended early: {error}", file=sys.stderr)
        return 1
    print("\n" + "\n".join(str(chosen.output / name) for name in RESULTS))
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="demo.py", description=__doc__)
    parser.add_argument("--grid", type=Path, help="MOLA label (.lbl) or data file (.img); else the sample")
    parser.add_argument("--output", type=Path, default=Path("build/demo"), help="of results (%(default)s)")
    parser.add_argument("--site", type=Path, help="folder of proxygraph and pvl, where Blender lacks them")
    return parser


def _sample(say: Callable[[str], None]) -> Path:
    """The synthetic grid; written now where it is not yet."""
    label = Path(__file__).resolve().parents[1] / "build" / "sample" / "sample.lbl"
    if not label.is_file():
        from make_sample_grid import make_sample

        say("Making the synthetic sample grid")
        make_sample(label.parent)
    return label


def _teller() -> Callable[[str], None]:
    began = time.perf_counter()

    def say(text: str) -> None:
        print(f"[{time.perf_counter() - began:5.1f} s] {text}", flush=True)

    return say


@contextmanager
def _all_or_nothing(output: Path) -> Iterator[Path]:
    """Give a folder for the results, which take the place of older ones only when all are there."""
    output.parent.mkdir(parents=True, exist_ok=True)
    folder = Path(tempfile.mkdtemp(prefix=f"{output.name}-", dir=output.parent))
    try:
        yield folder
        missing = [name for name in RESULTS if not (folder / name).is_file()]
        if missing:
            raise RuntimeError(f"The demo did not write {', '.join(missing)}.")
        output.mkdir(exist_ok=True)
        for name in RESULTS:
            (folder / name).replace(output / name)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    # In Blender, the script's own arguments stand after "--".
    own = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    sys.exit(main(own))
