"""The licences in the extension's zip: of every part that is bundled, or no zip at all."""

from __future__ import annotations

import importlib.util
import json
import zipfile
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]
CI = ROOT / ".ci"


@pytest.fixture(scope="module")
def writer() -> ModuleType:
    spec = importlib.util.spec_from_file_location("write_notices", CI / "write_notices.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    import sys

    sys.modules[spec.name] = module  # dataclasses look their own module up
    spec.loader.exec_module(module)
    return module


def wheel(folder: Path, name: str = "thing", *, facts: str = "", **files: str) -> Path:
    """Write a wheel."""
    path = folder / f"{name}-1.0-py3-none-any.whl"
    with zipfile.ZipFile(path, "w") as packed:
        packed.writestr(f"{name}-1.0.dist-info/METADATA", f"Name: {name}\n{facts}\n")
        for file, text in files.items():
            packed.writestr(file.replace("__", "/").replace("DIST", f"{name}-1.0.dist-info"), text)
    return path


FACTS = "License-Expression: MIT\nHome-page: https://example.org/thing"


def test_a_wheel_s_licence_is_taken_as_it_stands(writer: ModuleType, tmp_path: Path) -> None:
    wheel(tmp_path, facts=FACTS, DIST__licenses__LICENSE="Do as you like.")
    (component,) = writer.wheels(tmp_path)
    assert (component.licence, component.source) == ("MIT", "https://example.org/thing")
    assert component.texts == ("Do as you like.",)


@pytest.mark.parametrize("facts", [FACTS, "License-Expression: MIT", "Home-page: https://example.org"])
def test_a_wheel_without_its_licence_or_source_is_refused(
    writer: ModuleType, tmp_path: Path, facts: str
) -> None:
    files = {} if facts == FACTS else {"DIST__LICENSE": "Do as you like."}
    wheel(tmp_path, facts=facts, **files)
    with pytest.raises(ValueError, match="thing 1.0"):
        writer.wheels(tmp_path)


def test_a_library_in_a_wheel_has_to_be_known(writer: ModuleType, tmp_path: Path) -> None:
    path = wheel(tmp_path, facts=FACTS, DIST__LICENSE="Do as you like.")
    with zipfile.ZipFile(path, "a") as packed:
        packed.writestr("thing.libs/libusb-1-150b88da.0.so.0.1.0", b"")
    (component,) = writer.libraries(tmp_path)
    assert component.name.startswith("libusb ")
    with zipfile.ZipFile(path, "a") as packed:
        packed.writestr("thing.libs/libstrange-1.so", b"")
    with pytest.raises(ValueError, match="libstrange"):
        writer.libraries(tmp_path)


def test_only_crates_that_are_linked_are_named(writer: ModuleType) -> None:
    def package(name: str, kind: str = "lib", source: str | None = "elsewhere") -> dict[str, object]:
        return {"id": name, "name": name, "source": source, "targets": [{"kind": [kind]}]}

    def node(name: str, **kinds: str | None) -> dict[str, object]:
        return {"id": name, "deps": [{"pkg": to, "dep_kinds": [{"kind": kind}]} for to, kind in kinds.items()]}

    metadata = {
        "packages": [
            package("proxygraph", source=None),
            package("ours", source=None),
            package("linked"),
            package("tested"),
            package("built"),
            package("derive", "proc-macro"),
            package("syn"),
        ],
        "resolve": {
            "nodes": [
                node("proxygraph", ours=None, tested="dev", built="build", derive=None),
                node("ours", linked=None),
                node("linked"),
                node("tested"),
                node("built"),
                node("derive", syn=None),
                node("syn"),
            ]
        },
    }
    assert [crate["name"] for crate in writer.linked_crates(metadata)] == ["linked"]


def test_a_text_that_several_share_is_there_once(writer: ModuleType) -> None:
    parts = [writer.Component(name, "MIT", "https://example.org", ("The text.\n",)) for name in ("one", "two")]
    text = writer.notices(parts)
    assert text.count("The text.") == 1
    assert text.count("(text 1)") == 2


def test_the_libraries_that_are_known_have_their_texts() -> None:
    known = json.loads((CI / "licences" / "libraries.json").read_text(encoding="utf-8"))
    for name, facts in known.items():
        assert facts["source"].startswith("https://"), name
        assert facts["licence"]
        for text in facts["texts"]:
            assert (CI / "licences" / text).is_file()
