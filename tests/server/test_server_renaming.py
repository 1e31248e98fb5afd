"""A name is renamed wherever it is meant, and nowhere else: rename and expand gives what expand and rename gives."""

from __future__ import annotations

from pathlib import Path

import pytest
from corpus import CORPUS, own_roots, roots
from folder import CHECKOUT
from renaming import differences
from sampling import sample

from urdfctl.load.target import Target
from urdfctl.server.analysis.workspace import EditorSettings, Workspace

SAMPLES = sorted((CHECKOUT / "samples").glob("*/urdf/*.xacro"))


@pytest.mark.parametrize("path", SAMPLES, ids=lambda path: path.name)
def test_names_of_samples_are_renamed_everywhere(path: Path) -> None:
    assert list(differences(Target(str(path)), number=10, seed=1)) == []


@pytest.mark.parametrize("name", ["my_robot", "mybot", "radu", "gripper"])
def test_names_of_what_is_started_together_are_renamed_everywhere(name: str) -> None:
    run = Workspace(str(CHECKOUT / "samples" / name), EditorSettings()).check().run
    targets = [target for target, result in run.targets if result.launch is not None]
    assert targets
    assert [found for target in targets for found in differences(target, number=6, seed=2)] == []


def test_names_of_whole_robots_are_renamed_everywhere() -> None:
    paths = [root["path"] for root in (*own_roots(), *sample(roots(), 25))]
    found = {path: list(differences(Target(str(CORPUS / path)), number=4, seed=1)) for path in paths}
    assert {path: names for path, names in found.items() if names} == {}
