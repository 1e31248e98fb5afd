"""Load one target and lint it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import chain

from urdfctl.lint.engine import lint
from urdfctl.lint.generated import twin_digest
from urdfctl.lint.results import Outcome, TargetResult, among
from urdfctl.lint.selection import Selection
from urdfctl.load.bringup import bringup_of
from urdfctl.load.join_facts import join_facts
from urdfctl.load.loader import LoadedTarget, Loader
from urdfctl.load.origin.distro import without_prose
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.suppressions import Reach
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_OF_SIMULATORS = frozenset(
    {"gazebo_ros", "ros_gz", "ros_gz_sim", "ros_gz_bridge", "ros_ign", "ros_ign_gazebo", "ros_ign_bridge"}
)
"""Packages whose nodes spawn models into a simulator, or talk to one."""
_SIMULATES = r"(?i)gazebo|simul|world|(?:^|[^a-z])(?:gz|ign|sim|mujoco|isaac|webots)(?:[^a-z]|$)"
"""What the path of a launch file holds that may start a simulator."""
Run = Callable[..., Outcome]
"""Runs the rules on a project."""


class LintedTarget(NamedTuple):
    """A target's result, with the project it comes from. For root and sources, see LoadedTarget."""

    result: TargetResult
    project: Project
    root: Element | None
    sources: Mapping[str, SourceText]


def _is_only_shown(project: Project) -> bool:
    """Whether only a plugin in the robot names its simulator, and the launch file starts none, as far as the launch
    files that it includes can be read, and nothing that would wait for one."""
    launch = project.launch
    if launch is None or project.named_simulator or launch.simulations or launch.spawns:
        return False
    if not launch.complete and (not launch.unread or any(re.search(_SIMULATES, word.text) for word in launch.unread)):
        return False
    nodes = (*launch.nodes, *chain(*launch.beside))
    return not any(node.package.text in _OF_SIMULATORS for node in nodes)


def lint_target(
    loader: Loader,
    target: Target,
    selection: Selection,
    *,
    focus: Sequence[str] = (),
) -> LintedTarget:
    """Return the target with the findings in it: in the robot, or in a file without one.

    focus: files and folders; if there are any and none of them is read for the target, no rule runs.
    """
    loaded = loader.load(target)
    project, root = loaded.project, loaded.root
    robot, controllers = project.robot, project.controllers

    reached = Reach(root).contains if root is not None else _everywhere
    run = partial(lint, sources=list(loaded.sources.values()), selection=selection, reached=reached)
    if focus and not among(loaded.sources, focus):
        outcome = Outcome([], [])
    elif target.by_elimination and project.controllers is not None:
        project, outcome = _by_elimination(loaded, run)
    elif target.guessed:
        outcome = _guessed(project, run)
    else:
        outcome = _outcome(project, run)
    result = TargetResult(
        path=project.path,
        ros=project.ros,
        distro=project.distro,
        distro_from=project.distro_from,
        simulator=project.simulator,
        is_only_shown=_is_only_shown(project),
        complete=project.complete,
        library=project.library and not project.of_kind(ProblemKind.ARGUMENTS_NEEDED),
        robot=robot.name if robot else None,
        links=len(robot.links) if robot else None,
        files=tuple(loaded.sources),
        outcome=outcome,
        controllers=_controller_files(project),
        launch=project.launch.path if project.launch else None,
        arguments=loaded.arguments,
        bringup=bringup_of(project.launch, target) if project.launch else None,
        distros=project.distros,
        nodes=tuple(node.name for node in controllers.nodes) if controllers else (),
        sections=tuple(s.name for s in controllers.others) if controllers and loader.settings.nodes else (),
        missing_packages=tuple(sorted(_missing_packages(project))),
        twin=twin_digest(project.path, root) if project.complete else None,
        idle=_idle_joints(project),
        joining=join_facts(project),
    )
    return LintedTarget(result, project, root, loaded.sources)


def _outcome(project: Project, run: Run) -> Outcome:
    """The outcome of a project; what holds only in the distro that a README's prose names is a warning at most, and so
    is all about a launch file that is left over from ROS 1."""
    outcome = run(project)
    if project.launch is not None and project.launch.is_leftover and outcome.diagnostics:
        from urdfctl.lint.findings.weakening import of_leftover

        outcome = of_leftover(outcome, run(project._replace(controllers=None, started=None, launch=None)))
    evidence = project.evidence and without_prose(project.evidence)
    if not evidence or evidence.distros == project.distros or evidence.ros != project.ros or not outcome.has_errors:
        return outcome
    from urdfctl.lint.findings.weakening import OF_PROSE, weakened

    without = run(project._replace(distro=evidence.distro, distros=evidence.distros, evidence=evidence))
    return weakened(outcome, [without.only_errors()], OF_PROSE)


def _guessed(project: Project, run: Run) -> Outcome:
    """The outcome of a launch file whose arguments are guessed: only the robot alone can have errors."""
    from urdfctl.lint.findings.weakening import GUESSED, weakened

    alone = run(project._replace(controllers=None, started=None, launch=None))
    return weakened(run(project), [alone], GUESSED)


def _by_elimination(loaded: LoadedTarget, run: Run) -> tuple[Project, Outcome]:
    """The project and its outcome; without the controllers if they share no joint with the robot."""
    from urdfctl.lint.elimination import shares_joints

    project = loaded.project
    if shares_joints(project, loaded.sources):
        return project, run(project)
    without = project._replace(controllers=None, started=None)
    return without, run(without)


def _everywhere(_: SourceSpan) -> bool:
    return True


def _idle_joints(project: Project) -> int:
    """The number of joints that move, if nothing of the robot is controlled."""
    robot = project.robot
    if robot is None or not project.complete or project.library or project.controllers is not None:
        return 0
    if robot.ros2_controls or robot.transmissions or robot.plugins or (project.launch and project.launch.spawns):
        return 0
    return sum(joint.type in ("revolute", "continuous", "prismatic") and not joint.mimic for joint in robot.joints)


def _missing_packages(project: Project) -> set[str]:
    """The packages that the robot uses and package.xml declares, and that are not in the workspace."""
    of_meshes = (mesh.file for mesh in (project.robot.meshes if project.robot else ()))
    declared = {file.package for file in of_meshes if file and file.package and file.package_declared}
    return {problem.subject for problem in project.of_kind(ProblemKind.PACKAGE_ABSENT)} | declared


def _controller_files(project: Project) -> tuple[str, ...]:
    """Return the files that configure controllers; none if a launch file loads files without controllers."""
    configured = project.controllers
    if configured is None or (project.launch and not configured.managers and not configured.controllers):
        return ()
    loaded = {load.file.path for load in project.launch.loads} if project.launch else set()
    sections = [section for manager in configured.managers for section in manager.sections]
    sections += [section for controller in configured.controllers for section in controller.sections]
    places = [controller.declared_at for controller in configured.controllers if controller.declared_at]
    used = {place.span.source.path for place in (*places, *(section.at for section in sections))}
    files = (file.path for file in configured.files)
    return tuple(dict.fromkeys(path for path in files if path in used or path not in loaded))
