"""Usage: complete_manifest.py FOLDER PLATFORM: lists in FOLDER's manifest the wheels that lie beside it.

PLATFORM is Blender's name of the one platform that the wheels are for.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

LISTS = re.compile(r"^(?:wheels|platforms)\s*=\s*\[.*?\]\n", re.MULTILINE | re.DOTALL)
FIRST_TABLE = re.compile(r"^\[", re.MULTILINE)


def completed(manifest: str, wheels: list[str], platform: str) -> str:
    """The manifest's text with both lists, which as top-level keys must stand before the first table."""
    text = LISTS.sub("", manifest)
    table = FIRST_TABLE.search(text)
    middle = table.start() if table else len(text)
    listed = "".join(f'    "./wheels/{wheel}",\n' for wheel in wheels)
    lists = f'platforms = ["{platform}"]\nwheels = [\n{listed}]\n'
    return f"{text[:middle].rstrip()}\n\n{lists}\n{text[middle:]}"


def main(arguments: list[str]) -> int:
    """Rewrite the manifest in place."""
    folder, platform = Path(arguments[0]), arguments[1]
    manifest = folder / "blender_manifest.toml"
    wheels = sorted(wheel.name for wheel in (folder / "wheels").glob("*.whl"))
    manifest.write_text(completed(manifest.read_text(encoding="utf-8"), wheels, platform), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
