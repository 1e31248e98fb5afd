"""What a target says that decides what is started beside it: joints, controllers, and what manages these."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Any

from urdfctl.control.robots import hangs_on_others
from urdfctl.model.project import Project
from urdfctl.source.opaque import OUTSIDE, UNKNOWN
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.launch import Launch, Word

_LISTS = ("joints", "declared", "described_in", "started_in", "gone", "models", "variables")
_DESCRIPTIONS = (".urdf", ".xacro")
_PUBLISHER = "robot_state_publisher"
_DESCRIBED = (None, _PUBLISHER, "ros2_control_node")
"""The nodes that have the description of a robot that is started, the parameter server of ROS 1 among them."""


class JoinFacts(NamedTuple):
    """Facts of a target by which it is joined with what is started beside it.

    joints: the names of the robot's joints.
    hangs: whether each link of a plain URDF is the child of a joint, and some hang on links that it does not have: it
        is a part, to be joined with the rest of a robot by other means than xacro.
    claimed: without a robot: the joints that its controllers command, each with the namespace of its manager.
    declared: the controllers that its parameter files declare, with their namespaces if known.
    manages: whether it starts a simulator, or a controller manager.
    form: the generation of ROS that the launch file is written for; None if there is none.
    described_in: without a robot: the packages that its description is in, and that are not here.
    started_in: without a robot: the packages that are not here and whose launch files it includes, if these seem to
        start a robot.
    gone: without a robot: the launch file that it includes, that seems to start a robot, and that cannot be read though
        its package is here; and what is wrong with it. Empty if there is none.
    leftover: whether the launch file is written for ROS 1, in a package for ROS 2.
    lost: the description that it names, and that does not exist; empty if there is none.
    unfound: without a robot: the description that it names, and that was not found, though it may be made later; empty
        if there is none.
    unread: without a robot: whether it starts one whose description is not known.
    variables: the environment variables that it requires, and that are not given.
    models: without a robot: the files in SDF from which models are spawned.
    simulates: whether it starts a simulator, and no other controller manager.
    puts: whether it puts a model into a simulator.
    waits: ROS 2: whether it certainly spawns controllers of a robot whose manager another launch file starts.
    """

    joints: tuple[str, ...] = ()
    hangs: bool = False
    claimed: tuple[tuple[str, str], ...] = ()
    declared: tuple[str, ...] = ()
    manages: bool = False
    form: int | None = None
    described_in: tuple[str, ...] = ()
    started_in: tuple[str, ...] = ()
    gone: tuple[str, ...] = ()
    leftover: bool = False
    lost: str = ""
    unfound: str = ""
    waits: bool = False
    unread: bool = False
    models: tuple[str, ...] = ()
    simulates: bool = False
    puts: bool = False
    variables: tuple[str, ...] = ()

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> JoinFacts:
        """Return the facts that `_asdict` and JSON made `data` from."""
        claimed = tuple((namespace, joint) for namespace, joint in data["claimed"])
        lists = {name: tuple(data[name]) for name in _LISTS} | {"claimed": claimed}
        return cls(**{**data, **lists})


def join_facts(project: Project) -> JoinFacts:
    """Return the facts of a project."""
    controllers = project.controllers.controllers if project.controllers else ()
    launch = project.launch
    return JoinFacts(
        joints=tuple(name for name in project.robot.joint_names if name) if project.robot else (),
        hangs=project.robot is not None and hangs_on_others(project.robot),
        claimed=_claimed(project) if project.robot is None and launch is not None and controllers else (),
        declared=tuple(each.full_name for each in controllers if each.declared_at is not None),
        manages=launch is not None and _manages(launch),
        form=launch.ros if launch else None,
        described_in=_described_in(launch) if project.robot is None and launch else (),
        started_in=_started_in(launch) if project.robot is None and launch else (),
        gone=_gone(launch) if project.robot is None and launch else (),
        leftover=launch is not None and launch.is_leftover,
        lost=_lost(launch, exists=False) if launch is not None else "",
        unfound=_lost(launch, exists=None) if project.robot is None and launch is not None else "",
        waits=project.robot is not None and launch is not None and _waits(launch),
        unread=project.robot is None and launch is not None and _is_unread(launch),
        models=_models(launch) if project.robot is None and launch else (),
        simulates=launch is not None and bool(launch.simulations) and not _runs_manager(launch),
        puts=project.robot is None and launch is not None and _puts_model(launch),
        variables=launch.variables if project.robot is None and launch is not None else (),
    )


def _manages(launch: Launch) -> bool:
    """Whether a launch file starts a simulator, or a program that is a controller manager."""
    return bool(launch.simulations) or _runs_manager(launch)


def _runs_manager(launch: Launch) -> bool:
    """Whether a launch file starts a program that is a controller manager."""
    programs = {node.executable.text for node in launch.nodes if not node.executable.text.startswith("spawner")}
    loading = {load.node for load in launch.loads} if launch.ros == 2 else set()  # noqa: PLR2004 (a generation of ROS)
    return "ros2_control_node" in programs or bool(programs & loading)


def _waits(launch: Launch) -> bool:
    """Whether a launch file spawns controllers, and certainly starts nothing that has a controller manager."""
    if launch.ros == 1 or not launch.complete or not launch.spawns or launch.simulations:
        return False
    from urdfctl.control.hosts import hosts_no_manager

    loading = any(load.node and not load.node.startswith("spawner") for load in launch.loads)
    return not loading and all(hosts_no_manager(node) for node in launch.nodes)


def _lost(launch: Launch, *, exists: bool | None) -> str:
    """The path of the first description that a launch file names, and of which `exists` is known: that it does not
    exist, or nothing; empty if there is none."""
    missing = (one.file for one in launch.descriptions if one.sure and one.file.path and one.file.exists is exists)
    return next((file.path or file.text for file in missing), "")


def _is_unread(launch: Launch) -> bool:
    """Whether a launch file starts a robot, and no description that it names is known, or can be named in it."""
    described = [each for each in launch.descriptions if each.node in _DESCRIBED]
    if described or launch.ros == 1:
        return bool(described) and all(each.file.path is None for each in described)
    publishers = (node for node in launch.nodes if node.sure and node.runs(_PUBLISHER, _PUBLISHER))
    return any(not node.complete or any(file.known is None for file in node.files) for node in publishers)


def _puts_model(launch: Launch) -> bool:
    """Whether a launch file puts a model into a simulator."""
    from urdfctl.control.model_spawners import model_spawners

    return bool(model_spawners(launch))


def _models(launch: Launch) -> tuple[str, ...]:
    """The files in SDF from which a launch file spawns models."""
    from urdfctl.control.model_spawners import model_spawners, option_of

    named = (option_of(node, "file") for node in model_spawners(launch))
    return tuple(dict.fromkeys(file.text for file in named if file is not None and file.text.endswith(".sdf")))


def _described_in(launch: Launch) -> tuple[str, ...]:
    """The packages that are not here and that a launch file takes its descriptions from."""
    unknown = (each for each in launch.descriptions if each.file.path is None)
    commands = (f"{each.command or ''} {each.file.text}" for each in unknown)
    return tuple(dict.fromkeys(name for command in commands for name in re.findall(OUTSIDE, command)))


def _started_in(launch: Launch) -> tuple[str, ...]:
    """The packages that are not here and that a launch file starts launch files of, as far as these start robots."""
    if not launch.absent:
        return ()
    from urdfctl.source.workspaces.robot_starts import may_start_robot, package_of

    found = ((package_of(word.text), word) for word in launch.absent)
    return tuple(
        dict.fromkeys(
            name for name, word in found if name and (may_start_robot(name, word.text) or _is_given(word, launch))
        )
    )


def _is_given(word: Word, launch: Launch) -> bool:
    """Whether the include of a launch file of ROS 1 gives it the description of a robot as an argument."""
    data, start = word.at.source.data, word.at.start
    end = data.find(b"</include>", start)
    named = (one for one in launch.references if one.use == "argument" and one.file.at.source is word.at.source)
    described = (one for one in named if (one.file.path or "").endswith(_DESCRIPTIONS) and one.file.exists)
    return launch.ros == 1 and any(start < one.file.at.start < end for one in described)


def _gone(launch: Launch) -> tuple[str, ...]:
    """The first launch file of a package that is here which a launch file includes, which seems to start a robot, and
    which cannot be read: its path, in which `*` is what is not known, and what is wrong with it."""
    if not launch.absent:
        return ()
    from urdfctl.source.workspaces.packages import package_around
    from urdfctl.source.workspaces.robot_starts import may_start_robot

    exists = {one.file.path: one.file.exists for one in launch.references}
    for word in launch.absent:
        folder = os.path.dirname(word.text)
        package = package_around(folder) if os.path.isabs(folder) and not re.search(OUTSIDE, folder) else None
        if package and may_start_robot(os.path.basename(package), word.text):
            why = {True: "cannot be read", False: "does not exist", None: "was not found"}[exists.get(word.text)]
            why = "depends on an argument or a variable" if UNKNOWN in word.text else why
            return word.text.replace(UNKNOWN, "*"), why
    return ()


def _claimed(project: Project) -> tuple[tuple[str, str], ...]:
    """The joints that the controllers of a project command, as far as their types are known."""
    if not project.distros:
        return ()
    from urdfctl.control.session import session_of

    controllers = session_of(project, project.distros[-1]).controllers
    names = {each.name for each in controllers}
    claimed = dict.fromkeys(
        (each.controller.namespace or "", claim.component) for each in controllers for claim in each.claims.command
    )
    return tuple((space, joint) for space, joint in claimed if UNKNOWN not in joint and joint not in names)
