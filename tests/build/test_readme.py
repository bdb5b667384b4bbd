"""The page that newcomers read: its example runs, and its pictures and links are there."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
MAXIMUM_PICTURE_BYTES = 1 << 20


def test_its_example_runs_without_blender() -> None:
    if not (ROOT / "build/sample/sample.img").exists():
        pytest.skip("build/sample/sample.img is not made yet: make sample")
    (example,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    without_blender = f"import sys; sys.modules['bpy'] = None\n{example}"
    ran = subprocess.run(
        [sys.executable, "-c", without_blender], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, ran.stderr
    (shown,) = re.findall(r"It prints `(.*?)`", README)
    assert ran.stdout.strip() == shown


def test_what_it_links_to_is_there() -> None:
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert links
    for link in links:
        if "://" not in link:
            assert (ROOT / link).exists(), link


def test_its_pictures_are_small() -> None:
    pictures = re.findall(r"!\[[^]]*\]\(([^)]+)\)", README)
    assert pictures
    for picture in pictures:
        assert (ROOT / picture).stat().st_size <= MAXIMUM_PICTURE_BYTES, picture
