"""The scripts for pipelines, as a pipeline runs them: exit codes, summaries, files."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.formats.megdr_pair import MegdrPair, rough

SCRIPTS = Path(__file__).resolve().parents[2] / "blender_scripts"

SCENE = """
import sys
sys.path.insert(0, sys.argv[1])
from pipeline.scene import enabled_parts
enabled_parts()
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
enabled_parts()
bpy.ops.haptic_terrain.import_grid(filepath=sys.argv[2])
scene = bpy.context.scene
scene.frame_end = 12
goal = bpy.data.objects.new("Goal", None)
scene.collection.objects.link(goal)
for frame, place in ((1, (-3.0, -1.0, -1.5)), (12, (3.0, 1.0, -1.5))):
    goal.location = place
    goal.keyframe_insert("location", frame=frame)
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[3])
"""


class Folder:
    """Where the tests of this file work: a scene, and what a bake made of it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.label = MegdrPair(rough(40, 60)).write(folder)
        self.blend = folder / "scene.blend"
        self.baked = folder / "baked.blend"
        self.take = folder / "take.csv"

    def run(self, *arguments: object, blocked: bool = False) -> subprocess.CompletedProcess[str]:
        """Run a script; ``blocked`` without Blender."""
        environment = {**os.environ, "BLENDER_USER_RESOURCES": str(self.folder / "blender")}
        environment["XDG_CACHE_HOME"] = str(self.folder / "blender" / "cache")
        words = [str(argument) for argument in arguments]
        script = str(SCRIPTS / words[0])
        command = [sys.executable, script, *words[1:]]
        if blocked:
            code = (
                "import runpy, sys; sys.modules['bpy'] = None; sys.argv = sys.argv[1:];"
                " runpy.run_path(sys.argv[0], run_name='__main__')"
            )
            command = [sys.executable, "-c", code, script, *words[1:]]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def summary(ended: subprocess.CompletedProcess[str]) -> Any:
    """Read the standard output, which has nothing else."""
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.count("\n") == 1
    return json.loads(ended.stdout)


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory) -> Folder:
    folder = Folder(tmp_path_factory.mktemp("pipeline"))
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(folder.folder / "blender")}
    command = [sys.executable, "-c", SCENE, str(SCRIPTS), str(folder.label), str(folder.blend)]
    subprocess.run(command, env=environment, check=True, capture_output=True)
    return folder


@pytest.fixture(scope="module")
def bake(here: Folder) -> Any:
    arguments = ("--blend", here.blend, "--goal", "Goal", "--output", here.baked, "--take", here.take)
    return summary(here.run("bake_touch_path.py", *arguments))


def test_a_bake_is_summed_up_and_written(here: Folder, bake: Any) -> None:
    assert bake["frames"] == [1, 12]
    assert bake["ticks"] == 460
    assert bake["in_contact_share"] == 1.0
    assert bake["keys"] == 12
    assert bake["written"] == [str(here.take), str(here.baked)]
    assert here.take.is_file()
    assert here.baked.is_file()
    assert not list(here.folder.glob("*.part*"))


def test_the_same_scene_has_the_same_digest(here: Folder, bake: Any) -> None:
    file = here.folder / "summary.json"
    ended = here.run("bake_touch_path.py", "--blend", here.blend, "--goal", "Goal", "--summary", file)
    assert (ended.returncode, ended.stdout) == (0, "")
    again = json.loads(file.read_text("utf-8"))
    assert again["digest"] == bake["digest"]
    assert again["written"] == []


@pytest.mark.parametrize("script", ["bake_touch_path.py", "compare_models.py", "render_touch.py", "rover.py"])
def test_help_tells_the_exit_codes(here: Folder, script: str) -> None:
    ended = here.run(script, "--help", blocked=True)
    assert ended.returncode == 0
    assert "exit codes: 0" in ended.stdout


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (("--blend", "missing.blend", "--goal", "Goal"), 2, "missing.blend: there is no such file"),
        (("--blend", "{blend}", "--goal", "Gaol"), 2, "has no object Gaol"),
        (("--blend", "{blend}", "--goal", "Goal", "--model", "hand"), 2, "no contact model hand"),
        (("--blend", "{blend}", "--goal", "Goal", "--frames", "9", "3"), 2, "run backwards, from 9 to 3"),
        (("--blend", "{blend}", "--goal", "Goal", "--take", "a.txt"), 2, "a.txt: expected a name"),
        (("--blend", "{blend}", "--goal", "Goal", "--output", "no/where.blend"), 1, "where.blend"),
    ],
)
def test_what_a_bake_cannot_do_is_told(here: Folder, arguments: Any, code: int, words: str) -> None:
    ended = here.run("bake_touch_path.py", *(word.format(blend=here.blend) for word in arguments))
    assert (ended.returncode, ended.stdout) == (code, "")
    assert words in ended.stderr


def test_models_are_compared_on_a_take_without_blender(here: Folder, bake: Any) -> None:
    arguments = ("--take", here.take, "--grid", here.label, "--models", "surface_walk,god_object_release")
    ended = here.run("compare_models.py", *arguments, blocked=True)
    found = summary(ended)
    assert found["ticks"] == bake["ticks"]
    assert list(found["models"]) == ["surface_walk", "god_object_release"]
    assert found["models"]["surface_walk"]["time_ratio"] == 1.0
    assert found["models"]["surface_walk"]["in_contact_share"] == 1.0
    apart = found["proxies_apart_millimetres"]["surface_walk, god_object_release"]
    assert 0.0 <= apart["mean"] <= apart["p99"] <= apart["max"]
    assert "god_object_release" in ended.stderr


def test_models_are_compared_on_an_animated_object(here: Folder) -> None:
    arguments = ("--blend", here.blend, "--goal", "Goal", "--models", "surface_walk,proxy_graph")
    found = summary(here.run("compare_models.py", *arguments))
    assert found["frames"] == [1, 12]
    assert found["models"]["proxy_graph"]["vertices_per_update"] > 0.0


def test_a_take_of_another_terrain_is_not_compared(here: Folder, bake: Any, tmp_path: Path) -> None:
    other = MegdrPair(rough(40, 60)[::-1]).write(tmp_path)
    ended = here.run("compare_models.py", "--take", here.take, "--grid", other, blocked=True)
    assert ended.returncode == 2
    assert "another terrain" in ended.stderr


def test_frames_of_a_take_are_rendered(here: Folder, bake: Any, tmp_path: Path) -> None:
    arguments = ("--blend", here.baked, "--output", tmp_path / "frames", "--growing", "--resolution", 32, 18)
    found = summary(here.run("render_touch.py", *arguments, "--step", 6))
    assert found["frames"] == [1, 7]
    assert sorted(tmp_path.rglob("*.*")) == [tmp_path / "frames" / f"touch_{n:04d}.png" for n in (1, 7)]
    for file in found["written"]:
        assert Path(file).read_bytes().startswith(b"\x89PNG")
    pictures = [Path(file).read_bytes() for file in found["written"]]
    assert pictures[0] != pictures[1]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--take", "Tuck"), "has no take Tuck; it has Touch Take"),
        (("--camera", "Goal"), "has no camera Goal"),
        (("--frames", "5", "2"), "run backwards"),
        (("--resolution", "1", "1"), "expected 4 to 65536 pixels"),
    ],
)
def test_what_cannot_be_rendered_is_told(
    here: Folder, bake: Any, tmp_path: Path, arguments: tuple[str, ...], words: str
) -> None:
    ended = here.run("render_touch.py", "--blend", here.baked, "--output", tmp_path / "frames", *arguments)
    assert ended.returncode == 2
    assert words in ended.stderr
    assert not (tmp_path / "frames").exists()


def test_a_scene_without_a_take_is_told(here: Folder, tmp_path: Path) -> None:
    ended = here.run("render_touch.py", "--blend", here.blend, "--output", tmp_path / "frames")
    assert ended.returncode == 2
    assert "has none" in ended.stderr
