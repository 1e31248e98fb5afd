"""What of a robot is not known, how to add it, and the test of a robot of which only the driver is missing."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Sequence

from urdfctl.catalog.values import is_known
from urdfctl.lint.target import LintedTarget
from urdfctl.model.project import Project
from urdfctl.names import enumerated
from urdfctl.report.common import in_command, shown
from urdfctl.smoke.lifecycle import stops_hardware
from urdfctl.smoke.robot import mechanism_of
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.workspaces.submodules import empty_submodule
from urdfctl.source.xacro.expanded import HARMLESS

UNKNOWN_ROBOT = "not simulated: the robot is not known, or some of its parts are not"
"""Why a controller does not move if no engine can move it, and nothing says what is missing."""
NO_ROBOT = "not simulated: the launch file starts no known robot: urdfctl smoke ROBOT --controllers {}"
NO_INCLUDED = (
    "not simulated: the launch file starts no known robot, but files of {}, not here: {}, "
    "or urdfctl smoke ROBOT --controllers {}"
)
NO_PACKAGES = "not simulated: the robot needs {}, not here: {}, or --package-path FOLDER"
NEEDS_PACKAGES = "it needs files of {}, not here: {}, or --package-path FOLDER"
NEEDS_VARIABLE = "it needs {}: {}urdfctl smoke {} {}"
NEEDS_ROBOT = "it starts a robot whose description is known only while it runs: urdfctl smoke ROBOT"
NO_ARGUMENT = "not simulated: the robot needs {}: {}urdfctl smoke {} {}"
NO_VARIABLE = "not simulated: the launch file needs {}: {}urdfctl smoke {} {}"
COMPUTED = "not simulated: the launch file computes {} of the robot: urdfctl smoke {}"
NO_PART = "not simulated: some parts of the robot are not known: {}:{}: {}"
OR_MOCK = "; or --hardware mock, if only the driver is in there"
MOCKED = {"driver (mock hardware)": "mock hardware was taken in its place"}
"""What is not tested of controllers whose driver is not in the files."""
_IN_PACKAGE = r"\$\(find(?:-pkg-share)? ([\w-]+)\)|([A-Za-z][\w-]+)/"
_PACKAGES = (ProblemKind.PACKAGE_ABSENT, ProblemKind.PACKAGE_NOT_FOUND)
_ARGUMENTS = (ProblemKind.ARGUMENTS_NEEDED, ProblemKind.UNDEFINED_ARGUMENT)


def why_unknown(seen: LintedTarget) -> str:
    """Return why no engine can move a robot: the package, argument or file that is missing, and what adds it."""
    project = seen.project
    incomplete = project.robot is None or not project.complete
    problems = _problems(project) if incomplete else []
    packages = _packages_of_robot(seen) if incomplete else set()
    if packages:
        return NO_PACKAGES.format(*_with_what_adds(packages, seen.result.path)) + (
            OR_MOCK if is_only_the_driver_missing(project) else ""
        )
    if project.robot is None and project.launch is not None and seen.result.controllers:
        files = " ".join(map(in_command, seen.result.controllers))
        if seen.result.joining.unread and project.launch.variables:
            return _asking(NO_VARIABLE, in_command(project.launch.path), variables=project.launch.variables)
        included = {*packages_lacking(project), *seen.result.joining.described_in}
        return (
            NO_INCLUDED.format(*_with_what_adds(included, seen.result.path), files)
            if included
            else NO_ROBOT.format(files)
        )
    return _computed(seen) if incomplete and not problems else _why_of(problems, seen.result.path)


def needs_of(seen: LintedTarget) -> str:
    """Return what a launch file, or the robot, needs that is not here or not given, and what adds it; empty if nothing
    is known."""
    joining, launch = seen.result.joining, seen.project.launch
    packages = {*packages_lacking(seen.project), *joining.described_in}
    if seen.project.robot is not None and not seen.project.complete:
        packages |= _packages_of_robot(seen)
    if packages:
        return NEEDS_PACKAGES.format(*_with_what_adds(packages, seen.result.path))
    if launch is None or not joining.unread:
        return ""
    given = launch.variables
    return _asking(NEEDS_VARIABLE, in_command(launch.path), variables=given) if given else NEEDS_ROBOT


def _problems(project: Project) -> list[Problem]:
    return [problem for problem in project.problems if problem.kind not in HARMLESS]


def _packages_of_robot(seen: LintedTarget) -> set[str]:
    """The packages of which parts of an incomplete robot are, and that are not here."""
    named = {each.subject for each in _problems(seen.project) if each.kind in _PACKAGES and each.subject}
    return {*named, *seen.result.missing_packages}


def _with_what_adds(packages: Collection[str], path: str) -> tuple[str, str]:
    """Packages that a file needs, by name, and what adds them: the command for those that are submodules."""
    names = f"package{'s' * (len(packages) > 1)} {_quoted(sorted(packages))}"
    submodules = list(filter(None, (empty_submodule(name, path) for name in sorted(packages))))
    left = len(packages) - len(submodules)
    clone = f"clone {'it' if left == 1 else 'them'} beside it" if not submodules else "clone the others beside it"
    if not submodules:
        return names, clone
    root, paths = shown(submodules[0][0] + os.sep).rstrip("/"), " ".join(path for _, path in submodules)
    fetch = f"git {f'-C {root} ' if root else ''}submodule update --init {paths}"
    return names, f"{fetch}, and {clone}" if left else fetch


def _computed(seen: LintedTarget) -> str:
    """That a launch file gives the robot values that are not known before it runs, and how to give them."""
    descriptions = seen.project.launch.descriptions if seen.project.launch else ()
    unknown = [(each, name) for each in descriptions for name, value in each.arguments or () if not is_known(value)]
    path = unknown[0][0].file.path if unknown and unknown[0][0].file else None
    if path is None:
        return UNKNOWN_ROBOT
    names = list(dict.fromkeys(name for _, name in unknown))
    what = f"argument{'s' if len(names) > 1 else ''} {_quoted(names)}"
    files = [f"--controllers {in_command(path)}" for path in seen.result.controllers]
    words = [in_command(path), *files, *(f"{name}:=VALUE" for name in names)]
    return COMPUTED.format(what, " ".join(words))


def _why_of(problems: list[Problem], path: str) -> str:
    needed = [problem.subject for problem in problems if problem.kind in _ARGUMENTS and problem.subject]
    wanted = dict.fromkeys(name for names in needed for name in re.findall(r"[^,\s]+", names))
    if wanted:
        variables = [name[1:] for name in wanted if name.startswith("$")]
        return _asking(NO_ARGUMENT, in_command(path), [name for name in wanted if not name.startswith("$")], variables)
    if problems:
        first = problems[0]
        return NO_PART.format(shown(first.at.source.path), first.at.source.position(first.at.start)[0], first.message)
    return UNKNOWN_ROBOT


def _asking(text: str, path: str, arguments: Sequence[str] = (), variables: Sequence[str] = ()) -> str:
    """That arguments and environment variables are needed, and the command that gives them."""
    kinds = ("argument", arguments), ("environment variable", variables)
    parts = [f"{kind}{'s' * (len(names) > 1)} {_quoted(names)}" for kind, names in kinds if names]
    before = "".join(f"{name}=VALUE " for name in variables)
    given = " ".join([*(f"{name}:=VALUE" for name in arguments), *(f"--env {name}" for name in variables)])
    return text.format(" and ".join(parts), before, path, given)


def _quoted(names: Iterable[str]) -> str:
    return enumerated([f"'{name}'" for name in names], "and")


def packages_lacking(project: Project) -> tuple[str, ...]:
    """Return the packages of the files that a launch file includes and that are not here, sorted.

    Its own package is here, whatever file of it is missing.
    """
    absent = project.launch.absent if project.launch else ()
    own = project.launch.package.name if project.launch and project.launch.package else None
    found = (re.match(_IN_PACKAGE, word.text) for word in absent)
    return tuple(sorted({match[1] or match[2] for match in found if match} - {own}))


def is_only_the_driver_missing(project: Project) -> bool:
    """Return whether the links and joints of a robot are whole although some parts are unknown, but not its hardware.

    They are if they form one tree, and have the joints that the controllers name.
    """
    robot = project.robot
    if project.complete or project.library or robot is None or robot.ros2_controls or mechanism_of(robot) is None:
        return False
    controllers = project.controllers.controllers if project.controllers else ()
    listed = [each.parameters.value("joints") for each in controllers]
    named = {name for value in listed if value for name, _ in value.strings}
    return named <= set(robot.joint_names)


def with_mock_hardware(seen: LintedTarget) -> LintedTarget | None:
    """Return a target as it is with mock hardware in the place of its driver; None if that is not what it lacks."""
    stopped = [one for one in seen.result.outcome.diagnostics if stops_hardware(one)]
    driverless = is_only_the_driver_missing(seen.project)
    if not stopped and not driverless:
        return None
    kept = [one for one in seen.result.outcome.diagnostics if one not in stopped]
    outcome = seen.result.outcome._replace(diagnostics=kept)
    return seen._replace(
        result=seen.result._replace(outcome=outcome),
        project=seen.project._replace(complete=True) if driverless else seen.project,
    )
