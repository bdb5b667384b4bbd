"""What a fresh machine sees: interpreters are run, not believed, and what is missing is named in one line."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIND_PYTHON = ROOT / ".ci" / "find-python"
BUILD = "build"
VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"


def _run(
    *command: str | Path, environment: Mapping[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    # The flags of a make that runs these tests must not reach the one under test.
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MFLAGS"))}
    return subprocess.run(
        [str(part) for part in command],
        cwd=ROOT,
        env=clean | dict(environment or {}),
        capture_output=True,
        text=True,
        check=False,
    )


def _executable(path: Path, text: str) -> None:
    path.write_text(f"#!/bin/bash\n{text}\n")
    path.chmod(0o755)


def test_shim_that_fails_is_passed_over(tmp_path: Path) -> None:
    _executable(tmp_path / f"python{VERSION}", 'echo "command not found" >&2; exit 127')
    _executable(tmp_path / "python3", 'exec "' + sys.executable + '" "$@"')
    found = _run(FIND_PYTHON, VERSION, environment={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert found.returncode == 0
    assert found.stdout.count("\n") == 1
    assert Path(found.stdout.strip()).exists()


def test_shim_that_wants_its_version_named_is_asked_again(tmp_path: Path) -> None:
    _executable(tmp_path / "pyenv", "printf '2.7.18\\n9.99.1\\n'")
    _executable(
        tmp_path / "python9.99", '[ "${PYENV_VERSION-}" = 9.99.1 ] || exit 127; echo "9.99 /opt/python9.99"'
    )
    found = _run(FIND_PYTHON, "9.99", environment={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert found.stdout == "/opt/python9.99\n"


def test_missing_python_is_one_line(tmp_path: Path) -> None:
    found = _run(FIND_PYTHON, "9.98", "9.97", environment={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert found.returncode == 1
    assert found.stdout == ""
    assert found.stderr == "Missing: Python 9.98 or 9.97; install it, or name one: make PYTHON=path\n"


def test_python_without_venv_is_named(tmp_path: Path) -> None:
    _executable(
        tmp_path / "python9.99", 'case "$2" in *ensurepip*) exit 1;; *) echo "9.99 /opt/python9.99";; esac'
    )
    found = _run(FIND_PYTHON, "9.99", environment={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert found.returncode == 1
    assert "/opt/python9.99 cannot make a virtual environment" in found.stderr


def test_make_names_an_unsuitable_python(tmp_path: Path) -> None:
    _executable(tmp_path / "python", "echo 3.9")
    made = _run("make", "venv", f"PYTHON={tmp_path / 'python'}", f"BUILD={tmp_path / 'build'}")
    assert made.returncode != 0
    first = made.stderr.splitlines()[0]
    assert first.startswith("Missing: Python 3.11 or 3.13")
    assert not (tmp_path / "build").exists()


def test_make_names_a_missing_rust(tmp_path: Path) -> None:
    _executable(tmp_path / "cargo", "exit 127")
    made = _run("make", "test-native", environment={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert made.returncode != 0
    assert made.stderr.splitlines()[0].startswith("Missing: Rust")


def test_help_is_the_default_and_needs_nothing(tmp_path: Path) -> None:
    shown = _run("make", environment={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert shown.returncode == 0
    for target in ("demo", "test", "lint", "bench", "package", "clean"):
        assert f"make {target} " in shown.stdout


def test_a_path_with_a_space_is_one_path(tmp_path: Path) -> None:
    checkout = tmp_path / "a checkout"
    checkout.mkdir()
    (checkout / "Makefile").symlink_to(ROOT / "Makefile")
    for name in ("native", "addon", "blender_scripts", "tests", ".ci", "pyproject.toml"):
        (checkout / name).symlink_to(ROOT / name)
    planned = _run("make", "--dry-run", "--directory", checkout, "demo", f"PYTHON={sys.executable}")
    assert planned.returncode == 0, planned.stderr
    (recipe,) = [line for line in planned.stdout.splitlines() if "demo.py" in line]
    setting = recipe.split(f"{BUILD}/venv")[0]
    told = _run("bash", "-c", f"{setting} printenv XDG_CACHE_HOME")
    assert told.stdout.strip() == f"{checkout}/build/blender-user/cache", told.stderr


def test_what_bpy_lacks_is_one_line(tmp_path: Path) -> None:
    broken = tmp_path / "bpy"
    broken.mkdir()
    (broken / "__init__.py").write_text("raise ImportError('libX11.so.6: cannot open shared object file')\n")
    planned = _run("make", "--dry-run", "--always-make", "venv", f"PYTHON={sys.executable}")
    (recipe,) = [line for line in planned.stdout.splitlines() if "import bpy" in line]
    told = _run("bash", "-c", recipe, environment={"PYTHONPATH": str(tmp_path)})
    assert told.returncode == 1
    assert told.stderr.count("\n") == 1
    assert "Missing: system libraries" in told.stderr
    assert "libX11.so.6" in told.stderr
    assert "apt-get install" in told.stderr
