"""The manifest of the extension's zip lists the wheels that are in it."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MANIFEST = (ROOT / "addon" / "blender_manifest.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "manifest",
    [MANIFEST, MANIFEST.replace("[permissions]", 'wheels = [\n  "./wheels/old.whl",\n]\n\n[permissions]')],
    ids=["without wheels", "with others"],
)
def test_wheels_and_platform_are_listed_at_the_top_level(manifest: str, tmp_path: Path) -> None:
    (tmp_path / "blender_manifest.toml").write_text(manifest, encoding="utf-8")
    (tmp_path / "wheels").mkdir()
    for wheel in ("b-2-py3-none-any.whl", "a-1-cp311-abi3-manylinux_2_28_x86_64.whl"):
        (tmp_path / "wheels" / wheel).touch()
    subprocess.run([sys.executable, ROOT / ".ci/complete_manifest.py", tmp_path, "linux-x64"], check=True)
    completed = tomllib.loads((tmp_path / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert completed.pop("wheels") == [
        "./wheels/a-1-cp311-abi3-manylinux_2_28_x86_64.whl",
        "./wheels/b-2-py3-none-any.whl",
    ]
    assert completed.pop("platforms") == ["linux-x64"]
    assert completed == tomllib.loads(MANIFEST), "nothing else changed"


def test_add_on_and_native_module_have_one_version() -> None:
    """They are compared when the add-on is enabled: see ``restart``."""
    cargo = tomllib.loads((ROOT / "native" / "Cargo.toml").read_text(encoding="utf-8"))
    assert tomllib.loads(MANIFEST)["version"] == cargo["workspace"]["package"]["version"]
