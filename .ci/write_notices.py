"""Usage: write_notices.py FOLDER CARGO_TOML TARGET: writes the licences of all that is bundled.

They come into FOLDER/THIRD-PARTY.txt: of every Rust crate that is linked into the module for TARGET, and
of every wheel in FOLDER/wheels, their licence files as they stand; and of the C libraries inside the wheels,
what ``.ci/licences`` says.
"""

from __future__ import annotations

import email
import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zipfile import ZipFile

ROOT_CRATE = "proxygraph"
LICENCE_NAMES = ("licen", "copying", "copyright", "notice", "unlicense")
LIBRARIES = Path(__file__).parent / "licences"
RULE = "=" * 100


@dataclass(frozen=True)
class Component:
    """Something bundled."""

    name: str
    licence: str
    source: str
    texts: tuple[str, ...]


RUST = Component(
    "Rust standard library",
    "MIT OR Apache-2.0",
    "https://github.com/rust-lang/rust",
    ((LIBRARIES / "rust.txt").read_text(encoding="utf-8"),),
)
"""No crate of Cargo's, and linked in all the same."""


def linked_crates(metadata: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Cargo's packages that end up in the module: no tests' ones, and no compilers' helpers."""
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    waiting = [package["id"] for package in metadata["packages"] if package["name"] == ROOT_CRATE]
    seen: set[str] = set()
    while waiting:
        crate = waiting.pop()
        package = packages[crate]
        at_compile_time = any("proc-macro" in target["kind"] for target in package["targets"])
        if crate in seen or at_compile_time:
            continue
        seen.add(crate)
        if package["source"] is not None:  # else it is our own
            yield package
        waiting.extend(
            dependency["pkg"]
            for dependency in nodes[crate]["deps"]
            if any(kind["kind"] is None for kind in dependency["dep_kinds"])
        )


def crates(cargo_toml: str, target: str) -> list[Component]:
    """Everything that is linked into the native module.

    Raises:
        ValueError: a crate has no licence file.
    """
    asked = ["cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", target]
    told = subprocess.run([*asked, "--manifest-path", cargo_toml], check=True, stdout=subprocess.PIPE)
    found = []
    for package in linked_crates(json.loads(told.stdout)):
        folder = Path(package["manifest_path"]).parent
        files = sorted(path for path in folder.iterdir() if _is_licence(path.name) and path.is_file())
        name = f"{package['name']} {package['version']} (Rust crate)"
        texts = tuple(path.read_text(encoding="utf-8") for path in files)
        found.append(_whole(name, package["license"], package["repository"], texts))
    return sorted(found, key=lambda component: component.name)


def wheels(folder: Path) -> list[Component]:
    """Every other project's wheel; one that is there for several Pythons once.

    Raises:
        ValueError: a wheel has no licence file.
    """
    found: dict[str, Component] = {}
    for path in sorted(folder.glob("*.whl")):
        project, version = path.name.split("-")[:2]
        name = f"{project} {version} (Python wheel)"
        if project == ROOT_CRATE or name in found:
            continue
        with ZipFile(path) as wheel:
            inside = f"{project}-{version}.dist-info/"
            names = [entry for entry in wheel.namelist() if entry.startswith(inside)]
            facts = email.message_from_bytes(wheel.read(f"{inside}METADATA"))
            texts = [wheel.read(entry).decode() for entry in names if _is_licence(entry.rpartition("/")[2])]
        licence = (
            facts["License-Expression"] or facts["License"] or _classified(facts.get_all("Classifier", []))
        )
        source = facts["Home-page"] or ", ".join(facts.get_all("Project-URL", []))
        found[name] = _whole(name, licence, source, tuple(texts))
    return list(found.values())


def libraries(folder: Path) -> list[Component]:
    """The C libraries that lie in other projects' wheels.

    Raises:
        ValueError: one of them is not known, so that its licence would be missing.
    """
    known = json.loads((LIBRARIES / "libraries.json").read_text(encoding="utf-8"))
    found: set[str] = set()
    for path in folder.glob("*.whl"):
        with ZipFile(path) as wheel:
            files = {Path(entry).name for entry in wheel.namelist() if Path(entry).name.startswith("lib")}
        for file in (file for file in files if ".so" in file):
            name = file.partition(".so")[0].partition("-")[0]
            if name not in known:
                raise ValueError(f"{path.name} has {file}: state its licence in {LIBRARIES}/libraries.json")
            found.add(name)
    return [
        Component(
            f"{name} (C library inside a wheel)",
            known[name]["licence"],
            known[name]["source"],
            tuple((LIBRARIES / text).read_text(encoding="utf-8") for text in known[name]["texts"]),
        )
        for name in sorted(found)
    ]


def notices(components: list[Component]) -> str:
    """Put it into words; a text that several share is there once."""
    numbers: dict[str, int] = {}
    lines = [
        "What Haptic Terrain brings along, and the licences of it. Haptic Terrain itself is under the GNU",
        "General Public License, version 3 or later: see LICENSE. Where a choice of licences is offered, any",
        "of them may be taken. The unchanged source of each part is to be had where it is named.",
        "",
    ]
    for component in components:
        shared = [numbers.setdefault(text.strip(), len(numbers) + 1) for text in component.texts]
        where = ", ".join(f"text {number}" for number in shared) or "see LICENSE"
        lines += [
            component.name,
            f"    licence: {component.licence} ({where})",
            f"    source: {component.source}",
        ]
    for text, number in numbers.items():
        lines += ["", RULE, f"Text {number}", RULE, "", text]
    return "\n".join(lines) + "\n"


def _whole(name: str, licence: str | None, source: str | None, texts: tuple[str, ...]) -> Component:
    if not (licence and source and texts):
        raise ValueError(f"{name} comes without its licence, or without the place of its source")
    return Component(name, licence, source, texts)


def _is_licence(name: str) -> bool:
    return name.lower().startswith(LICENCE_NAMES)


def _classified(classifiers: list[str]) -> str:
    return ", ".join(line.rpartition(" :: ")[2] for line in classifiers if line.startswith("License :: "))


def main(arguments: list[str]) -> int:
    """Write the file, or say what is missing."""
    folder, cargo_toml, target = Path(arguments[0]), arguments[1], arguments[2]
    try:
        found = [RUST, *crates(cargo_toml, target), *wheels(folder / "wheels"), *libraries(folder / "wheels")]
    except ValueError as error:
        print(f"Missing: {error}", file=sys.stderr)
        return 1
    (folder / "THIRD-PARTY.txt").write_text(notices(found), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
