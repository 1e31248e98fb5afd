"""The sound samples: lint finds nothing in them, and what controls them is what the generators write."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from folder import CHECKOUT
from generating import command

SAMPLES = {"mybot": "noetic", "my_robot": "noetic", "radu": "humble"}


def generated(sample: str) -> dict[str, list[str]]:
    """The command that made each generated file of a sample, by the file's name in it."""
    root, found = CHECKOUT / "samples" / sample, {}
    for path in sorted(root.rglob("*.*")):
        said = re.search(r"made by urdfctl (.*?)( -->)?\n", path.read_text(encoding="utf-8"))
        if said:
            found[path.relative_to(root).as_posix()] = shlex.split(said[1])
    return found


@pytest.mark.parametrize("sample", SAMPLES)
def test_what_controls_a_sample_is_generated(sample: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(CHECKOUT / "samples" / sample)
    made = generated(sample)
    assert [words[0] for words in made.values()] in (
        ["gen-controllers", "gen-launch", "gen-gazebo", "gen-transmissions"],
        ["gen-controllers", "gen-launch", "gen-gazebo", "gen-ros2-control"],
    )
    for name, words in made.items():
        assert command(*words, "-o", name, "--check") == (0, "", ""), name


@pytest.mark.parametrize(("sample", "distro"), SAMPLES.items())
def test_a_sound_sample_has_neither_errors_nor_warnings(
    sample: str, distro: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(CHECKOUT)
    ran = command("lint", str(Path("samples", sample)), "--distro", distro, "--fail-on", "warning")
    assert ran.returncode == 0, ran.stdout
