"""UC609."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import takewhile

from urdfctl.catalog.distros import ROS2, in_words
from urdfctl.control.model_spawners import model_spawners, option_name
from urdfctl.control.parameters.spawner_options import DISTROS, INSTEAD, OF_MODEL_SPAWNERS
from urdfctl.model.launch import Node, Spawn
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.launch.common import ROS_2, is_spawner, launch_of, spawners
from urdfctl.rules.launch_samples import BROADCASTER, FILE, MANAGER, PUBLISHER, SOUND, launched, spawner

_MODEL = """
      <node pkg="ros_gz_sim" exec="create" args="{} -z -0.5 -x=1 --allow-renaming"/>"""
_ENTITY = """
      <node pkg="gazebo_ros" exec="spawn_entity.py" args="-topic robot_description {}"/>"""


@rule(
    "UC609",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control spawner.py: argparse ends the program where it does not know an option: 'unrecognized "
    "arguments'; the options of each distro's branch; ros_gz_sim create.cpp: gflags 'unknown command line flag'",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, spawner(f"arm_controller «--controller_manager» /cm {FILE}")),
        launched(PUBLISHER, _MODEL.format("«-topi» robot_description")),
        launched(PUBLISHER, _ENTITY.format("«-name» arm")),
    ],
    good=[SOUND],
)
def spawner_option_unknown(project: Project) -> Iterator[Finding]:
    """Unknown option of a spawner.

    The program exits at once: no controller is loaded, or no model is spawned. Some options of the spawner of controllers
    were removed over time. `--stopped` is now `--inactive`, the controller's type comes from its parameters, and its
    namespace is that of the spawner node.
    """
    launch = launch_of(project, ROS_2)
    if launch is None:
        return
    for spawn in spawners(launch):
        if is_spawner(spawn):
            yield from _of_spawner(project, spawn)
    for node in model_spawners(launch):
        yield from _of_model_spawner(node)


def _of_spawner(project: Project, spawn: Spawn) -> Iterator[Finding]:
    """The options that the spawner of controllers does not have in some distros."""
    for option in spawn.options:
        name = option.name
        begun = [known for known in DISTROS if name.startswith("--") and known.startswith(name)]
        has = {distro for known in ([name] if name in DISTROS else begun) for distro in DISTROS[known]}
        lacking = [distro for distro in project.distros if distro not in has]
        if not is_known(name) or not lacking or name.lstrip("-")[:1].isdigit():
            continue
        if len(lacking) == len(project.distros):
            meant = nearest(name, [known for known in DISTROS if known.startswith("--")])
            hint = f"; {INSTEAD[name]}" if name in INSTEAD else f"; did you mean '{meant}'?" if meant else ""
            fix = replaced(option.at, name, meant) if meant and name not in DISTROS else None
            yield Finding(option.at, f"the spawner has no option '{name}'{hint}", (), fix)
        elif name in INSTEAD and lacking[-1] == project.distros[-1]:
            message = f"the spawner has no option '{name}' in {in_words(lacking)}; {INSTEAD[name]}"
            fix = replaced(option.at, name, "--inactive") if name == "--stopped" else None
            yield Finding(option.at, message, (), fix, Severity.WARNING)


def _of_model_spawner(node: Node) -> Iterator[Finding]:
    """The options that a program that spawns models does not have. Some are told by their beginning."""
    options = OF_MODEL_SPAWNERS.get(node.executable.text, ())
    for word in takewhile(lambda word: word.text != "--ros-args", node.words if options else ()):
        name = option_name(word)
        if not name or not is_known(word.text):
            continue
        told = name if node.executable.text != "create" else name.replace("-", "_")  # to gflags both are the same
        if any(option.startswith(name) for option in options if node.executable.text != "create"):
            continue
        if told not in options:
            meant = nearest(name, options)
            hint = f"; did you mean '-{meant}'?" if meant else ""
            fix = replaced(word.at, f"-{name}", f"-{meant}") if meant else None
            yield Finding(word.at, f"'{node.executable.text}' has no option '-{name}'{hint}", (), fix)
