"""What of a robot is not known, how to add it, and the test of a robot of which only the driver is missing."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Sequence

from urdfctl.catalog.repositories import repository_of
from urdfctl.catalog.values import is_known
from urdfctl.lint.target import LintedTarget
from urdfctl.model.project import Project
from urdfctl.names import enumerated
from urdfctl.report.common import in_command, shown
from urdfctl.smoke.lifecycle import stops_hardware
from urdfctl.smoke.robot import mechanism_of
from urdfctl.source.disk.gate import is_file
from urdfctl.source.opaque import OUTSIDE
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.workspaces.repository_lists import list_with
from urdfctl.source.workspaces.submodules import empty_submodule
from urdfctl.source.xacro.expanded import HARMLESS

UNKNOWN_ROBOT = "not simulated: the robot is not known, or some of its parts are not"
"""Why a controller does not move if no engine can move it, and nothing says what is missing."""
NO_ROBOT = "not simulated: the launch file starts no known robot: urdfctl smoke ROBOT --controllers {}"
NO_INCLUDED = (
    "not simulated: the launch file starts no known robot, but files of {}, not here: {}, "
    "or urdfctl smoke ROBOT --controllers {}"
)
NO_FILE = (
    "not simulated: the launch file reads the robot from '{}', which does not exist{} "
    "urdfctl smoke ROBOT --controllers {}"
)
NO_PACKAGES = "not simulated: the robot needs {}, not here: {}, or --package-path FOLDER"
NEEDS_PACKAGES = "it needs files of {}, not here: {}, or --package-path FOLDER"
NEEDS_VARIABLE = "it needs {}: {}urdfctl smoke {} {}"
NEEDS_FILE = "it reads the robot from '{}', which does not exist{} urdfctl smoke ROBOT"
NEEDS_ROBOT = "it starts a robot whose description is known only while it runs: urdfctl smoke ROBOT"
STARTS_NONE = "it starts no robot"
STARTS_UNKNOWN = "it starts no robot that is known before it runs: urdfctl smoke ROBOT"
STARTS_WITH = "it starts no robot that is known without {}: {}urdfctl smoke {} {}"
NO_ARGUMENT = "not simulated: the robot needs {}: {}urdfctl smoke {} {}"
NO_VARIABLE = "not simulated: the launch file needs {}: {}urdfctl smoke {} {}"
COMPUTED = "not simulated: the launch file computes {} of the robot: urdfctl smoke {}"
NO_PART = "not simulated: some parts of the robot are not known: {}:{}: {}"
OR_MOCK = "; or --hardware mock, if only the driver is in there"
MOCKED = {"driver (mock hardware)": "mock hardware was taken in its place"}
"""What is not tested of controllers whose driver is not in the files."""
_IN_PACKAGE = rf"\$\(find(?:-pkg-share)? ([\w-]+)\)|([A-Za-z][\w-]+)/|{OUTSIDE}"
_ANY_NAME = r"(?:^|_)(?:name|namespace|ns|prefix|suffix)$"
"""How the names of arguments end that are empty by default, and choose no robot."""
_PACKAGES = (ProblemKind.PACKAGE_ABSENT, ProblemKind.PACKAGE_NOT_FOUND)
_ARGUMENTS = (ProblemKind.ARGUMENTS_NEEDED, ProblemKind.UNDEFINED_ARGUMENT)


def why_unknown(seen: LintedTarget) -> str:
    """Return why no engine can move a robot: the package, argument or file that is missing, and what adds it."""
    project = seen.project
    incomplete = project.robot is None or not project.complete
    problems = _problems(project) if incomplete else []
    packages = _packages_of_robot(seen) if incomplete else set()
    if packages:
        return NO_PACKAGES.format(*_with_what_adds(packages, seen)) + (
            OR_MOCK if is_only_the_driver_missing(project) else ""
        )
    if project.robot is None and project.launch is not None and seen.result.controllers:
        files = " ".join(map(in_command, seen.result.controllers))
        if seen.result.joining.unread and project.launch.variables:
            return _asking(NO_VARIABLE, in_command(project.launch.path), variables=project.launch.variables)
        included = {*packages_lacking(project), *seen.result.joining.described_in}
        if included:
            return NO_INCLUDED.format(*_with_what_adds(included, seen), files)
        lost = lost_description(project)
        return NO_FILE.format(*lost, files) if lost else NO_ROBOT.format(files)
    return _computed(seen) if incomplete and not problems else _why_of(problems, seen.result.path)


def needs_of(seen: LintedTarget) -> str:
    """Return what a launch file, or the robot, needs that is not here or not given, and what adds it; empty if nothing
    is known."""
    joining, launch = seen.result.joining, seen.project.launch
    packages = {*packages_lacking(seen.project), *joining.described_in}
    if seen.project.robot is not None and not seen.project.complete:
        packages |= _packages_of_robot(seen)
    if packages:
        return NEEDS_PACKAGES.format(*_with_what_adds(packages, seen))
    lost = lost_description(seen.project)
    if lost and seen.project.robot is None:
        return NEEDS_FILE.format(*lost)
    if launch is None:
        return "" if seen.project.complete else _asking_for(NEEDS_VARIABLE, _problems(seen.project), seen.result.path)
    if not joining.unread:
        return ""
    given = launch.variables
    return _asking(NEEDS_VARIABLE, in_command(launch.path), variables=given) if given else NEEDS_ROBOT


def why_robotless(seen: LintedTarget) -> str:
    """Return why a launch file starts no robot, and the argument without which it does not; empty if it starts one."""
    launch = seen.project.launch
    if launch is None or seen.project.robot is not None:
        return ""
    given = dict(seen.result.bringup.arguments) if seen.result.bringup else {}
    unset = (name for name, value in launch.arguments if not value and name not in given)
    empty = [name for name in unset if not re.search(_ANY_NAME, name)]
    if not launch.complete and len(empty) == 1:
        return _asking(STARTS_WITH, in_command(launch.path), empty)
    return STARTS_NONE if launch.complete else STARTS_UNKNOWN


def _problems(project: Project) -> list[Problem]:
    return [problem for problem in project.problems if problem.kind not in HARMLESS]


def _packages_of_robot(seen: LintedTarget) -> set[str]:
    """The packages of which parts of an incomplete robot are, and that are not here."""
    named = {each.subject for each in _problems(seen.project) if each.kind in _PACKAGES and each.subject}
    return {*named, *seen.result.missing_packages}


def _with_what_adds(packages: Collection[str], seen: LintedTarget) -> tuple[str, str]:
    """Packages that a file needs, by name, and what adds them: the commands for submodules and repositories."""
    names, path = sorted(packages), seen.result.path
    fetched = {name: at for name in names if (at := empty_submodule(name, path))}
    listed = {name: at for name in names if name not in fetched and (at := list_with(name, path))}
    commands = [*_fetching(fetched.values()), *map(_importing, dict.fromkeys(listed.values()))]
    left = [name for name in names if name not in fetched and name not in listed]
    clones = [_cloning(left, seen, is_all=not commands)] if left else []
    return f"package{'s' * (len(names) > 1)} {_quoted(names)}", ", and ".join([*commands, *clones])


def _cloning(names: Sequence[str], seen: LintedTarget, *, is_all: bool) -> str:
    """What clones packages: beside the file, from their repositories as far as these are known."""
    found = [repository_of(name, seen.result.ros) for name in names]
    distro = f" for {seen.result.distro}" if seen.result.distro else ""
    known, rest = dict.fromkeys(f"{one}{distro}" for one in found if one), found.count(None)
    one, several = ("it", "them") if is_all and not known else ("the other", "the others")
    others = one if rest == 1 else several
    return f"clone {enumerated([*known, *([others] if rest else [])], 'and')} beside it"


def _fetching(submodules: Collection[tuple[str, str]]) -> Iterator[str]:
    """The command that fetches submodules of one repository, each with its path there."""
    if submodules:
        root, paths = shown(next(iter(submodules))[0] + os.sep).rstrip("/"), " ".join(path for _, path in submodules)
        yield f"git {f'-C {root} ' if root else ''}submodule update --init {paths}"


def _importing(listed: tuple[str, str]) -> str:
    """The command that imports the repositories of a list to a folder."""
    path, folder = (in_command(os.path.relpath(each)) for each in listed)
    return f"vcs import {folder} < {path}"


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
    asked = _asking_for(NO_ARGUMENT, problems, path)
    if asked:
        return asked
    if problems:
        first = problems[0]
        return NO_PART.format(shown(first.at.source.path), first.at.source.position(first.at.start)[0], first.message)
    return UNKNOWN_ROBOT


def _asking_for(text: str, problems: list[Problem], path: str) -> str:
    """That a robot needs the arguments and the environment variables that some problems are about; empty if none."""
    needed = [problem.subject for problem in problems if problem.kind in _ARGUMENTS and problem.subject]
    wanted = dict.fromkeys(name for names in needed for name in re.findall(r"[^,\s]+", names))
    variables = [name[1:] for name in wanted if name.startswith("$")]
    arguments = [name for name in wanted if not name.startswith("$")]
    return _asking(text, in_command(path), arguments, variables) if wanted else ""


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
    return tuple(sorted({next(filter(None, match.groups())) for match in found if match} - {own}))


def lost_description(project: Project) -> tuple[str, str] | None:
    """Return the only description of a launch file if it is not there, and what makes it if the build may do that."""
    files = {each.file.path: each.file for each in project.launch.descriptions} if project.launch else {}
    [path, file], *others = files.items() or [(None, None)]
    if others or path is None or file is None or is_file(path):
        return None
    return shown(path), " before the build: build the workspace, or" if file.exists is None else ":"


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
