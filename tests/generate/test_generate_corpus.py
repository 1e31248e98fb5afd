"""Public robots without any control: a package of what controls them gives lint nothing to say."""

from __future__ import annotations

import pytest
from corpus import CORPUS, needs_corpus
from folder import Folder
from generating import command
from sampling import sample
from uncontrolled_robots import ROBOTS

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

EXPECTED = ("UC449", "UC467", "UC705", "UC706", "UC707")
"""Stand-ins are meant to be found; that later distros lack something is no fault of what is for this one."""


def told(robot: str, distro: str, simulator: str, *folders: str) -> set[tuple[str, str]]:
    """What lint says of a robot, by code and message."""
    settings = Settings(distro, simulator, workspace=folders[-1], package_paths=folders)
    outcome = lint_target(Loader(settings), Target(robot), Selection()).result.outcome
    return {(found.code, found.message) for found in outcome.diagnostics if found.code not in EXPECTED}


@needs_corpus
@pytest.mark.parametrize("path", sample(ROBOTS, 7))
def test_a_package_for_a_robot_without_control_adds_nothing_to_what_lint_says_of_it(path: str, folder: Folder) -> None:
    kind, distro, simulator = ROBOTS[path].split()
    robot, repository = str(CORPUS / path), str(CORPUS / path.partition("/")[0])
    asked = ("--type", kind, "--distro", distro, "--simulator", simulator)
    where = ("--workspace", repository, "--package-path", repository)
    ran = command("gen-all", robot, *asked, *where, "--force", "-o", "made")
    assert ran.returncode == 0, ran.stderr
    folders = (str(folder.path), repository)
    alone = told(robot, distro, simulator, *folders)
    assert told("made/urdf/robot.urdf.xacro", distro, simulator, *folders) - alone == set()


@needs_corpus
def test_at_least_twenty_robots_of_as_many_makers_are_tried() -> None:
    assert len({path.partition("/")[0] for path in ROBOTS}) >= 20
