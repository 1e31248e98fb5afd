"""Results of linting: of one project, of one target, and of a run."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.load.bringup import Bringup
from urdfctl.load.join_facts import JoinFacts
from urdfctl.startup.records import NamedTuple


def among(files: Iterable[str], focus: Sequence[str]) -> set[str]:
    """Return those of some files that are in focus: named, or in a folder that is named."""
    folders = tuple(f"{path}{os.sep}" for path in focus)
    return {file for file in files if file in focus or file.startswith(folders)}


class SuppressionUse(NamedTuple):
    """A suppression comment, and whether it suppressed anything in one project. For the excerpt, see Diagnostic."""

    at: Location
    codes: tuple[str, ...]
    used: bool
    excerpt: str
    excerpt_column: int = 1


class Outcome(NamedTuple):
    """The diagnostics of one project.

    crashed: True if a rule raised an exception, which is a diagnostic too.
    """

    diagnostics: list[Diagnostic]
    suppressions: list[SuppressionUse]
    crashed: bool = False

    @property
    def has_errors(self) -> bool:
        """Whether any diagnostic is an error."""
        return any(diagnostic.severity is Severity.ERROR for diagnostic in self.diagnostics)

    def only_errors(self) -> Outcome:
        """Return the outcome without its other diagnostics."""
        return self._replace(diagnostics=[each for each in self.diagnostics if each.severity is Severity.ERROR])


class TargetResult(NamedTuple):
    """The result of linting one target.

    path: the description, or the file that was linted without one.
    ros: 1 or 2; None if unknown.
    distro_from: what the distro was detected from.
    complete: False if a part of the robot could not be expanded.
    library: True if the file only defines macros, which were called with unknown values.
    robot: the robot's name.
    links: how many links it has; None if there is no robot.
    files: all files that were read.
    controllers: the controller files that belong to it.
    launch: the launch file that says which files belong together.
    arguments: the xacro arguments the description was given.
    bringup: what that launch file starts together.
    distros: the distros that it may be for.
    nodes: the nodes that were checked by a definition that the user names.
    sections: the names of other nodes that its files have parameters for, if the user names a definition.
    joining: what decides what is started beside it.
    idle: how many joints of the robot move, if nothing of it is controlled: 0 otherwise.
    twin: a digest of the expanded description if a file of the same name, plain or xacro, is beside it.
    is_only_shown: whether its launch file is known to start no simulator, and nothing that would wait for one.
    missing_packages: the packages that it uses and package.xml declares, and that are not in the workspace.
    """

    path: str
    ros: int | None
    distro: str | None
    distro_from: str | None
    simulator: str | None
    complete: bool
    library: bool
    robot: str | None
    links: int | None
    files: tuple[str, ...]
    outcome: Outcome
    controllers: tuple[str, ...] = ()
    launch: str | None = None
    arguments: tuple[tuple[str, str], ...] = ()
    bringup: Bringup | None = None
    distros: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    sections: tuple[str, ...] = ()
    missing_packages: tuple[str, ...] = ()
    twin: str | None = None
    idle: int = 0
    joining: JoinFacts = JoinFacts()
    is_only_shown: bool = False

    @property
    def started_simulator(self) -> str | None:
        """The simulator that it runs in: a plugin in the robot alone starts none."""
        return None if self.is_only_shown else self.simulator

    @property
    def is_controlled(self) -> bool:
        """Whether files declare controllers for it, or a launch file spawns some for its robot, simulates it, or plans
        for it with MoveIt."""
        bringup = self.bringup
        is_used = bringup and (bringup.spawned or bringup.simulators or bringup.moveit)
        return bool(self.controllers) or bool(self.links and is_used)


_LISTS_OF_UNJOINED = ("joints", "controllers", "packages", "models", "gone", "variables")


class Unjoined(NamedTuple):
    """A launch file that starts controllers without a robot, or what is not here, and the fact that is missing.

    robot: the description that fits best; None if nothing starts or describes a robot.
    joints: those that its controllers command, and that robot lacks.
    controllers: those that it spawns, and nothing declares for that robot.
    packages: those that are not here and that it takes the description from, or launch files.
    controls: whether it starts controllers.
    leftover: whether it is written for ROS 1, in a package for ROS 2.
    includes: whether it takes launch files from those packages.
    description: the one that it names, and that does not exist, or was not found.
    is_found_nowhere: whether it does not exist, and nothing makes it later.
    models: the files in SDF from which it spawns models.
    undescribed: whether it starts a robot whose description is not known.
    gone: the launch file of a package that is here which it includes and which cannot be read, and why; empty if there
        is none.
    variables: the environment variables that its description depends on, and that are not given.
    """

    path: str
    robot: str | None = None
    joints: tuple[str, ...] = ()
    controllers: tuple[str, ...] = ()
    packages: tuple[str, ...] = ()
    controls: bool = True
    includes: bool = False
    leftover: bool = False
    description: str = ""
    is_found_nowhere: bool = False
    models: tuple[str, ...] = ()
    undescribed: bool = False
    gone: tuple[str, ...] = ()
    variables: tuple[str, ...] = ()

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Unjoined:
        """Return what `_asdict` and JSON made `data` from."""
        lists = {name: tuple(data[name]) for name in _LISTS_OF_UNJOINED}
        return cls(**{**data, **lists})


class Report(NamedTuple):
    """What a run found.

    targets: the robots it looked at, and controllers' files and launch files named alone.
    findings: causes first.
    unused: the other files that were linted: macro libraries, fragments and controller files in folders.
    unjoined: the launch files that start controllers without a robot, or a robot that is not here.
    fail_on: from which severity on findings make it fail.
    known: how many more findings the baseline hides.
    statistics: whether the rules are to be counted.
    missing_packages: the declared packages that are not in the workspace.
    quiet: whether only the findings are shown.
    verbose: whether the text shows info beside errors and warnings.
    uncontrolled: the path of the robot if nothing controls it.
    """

    targets: tuple[TargetResult, ...]
    findings: tuple[Diagnostic, ...]
    unused: tuple[str, ...] = ()
    unjoined: tuple[Unjoined, ...] = ()
    fail_on: Severity = Severity.ERROR
    known: int = 0
    statistics: bool = False
    missing_packages: tuple[str, ...] = ()
    quiet: bool = False
    verbose: bool = False
    uncontrolled: str = ""

    @property
    def failing(self) -> tuple[Diagnostic, ...]:
        """The findings that make the run fail."""
        return tuple(finding for finding in self.findings if finding.severity.weight >= self.fail_on.weight)

    def count(self, severity: Severity) -> int:
        """Return the number of findings with a severity."""
        return sum(finding.severity is severity for finding in self.findings)
