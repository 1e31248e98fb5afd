"""What the robots of a folder have to do with control, as urdfctl reads them: sets of facts that can be compared."""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import yaml

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.map_parameters import matching
from urdfctl.config.settings import Settings
from urdfctl.discover.robots import discover_files
from urdfctl.lint.job import Work, Workers, run_on_targets, shared_loader
from urdfctl.lint.planning import planned
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.controllers import Controller
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.source.disk.files import is_launch
from urdfctl.source.opaque import UNKNOWN

KINDS = ("interfaces", "types", "keys", "plugins", "sensors", "bridged", "spawned")
_KNOWN_SOURCES = (UNKNOWN, "$(", "${", "<", "{{")
_PLACEHOLDER = re.compile(r"^/?<\w+>(?=/)")
"""A namespace that a launch file fills in."""
_LIST_OF_TOPICS = (b"ros_topic_name", b"topic_name")
_STATES_ONLY = "states only"

Facts = dict[str, set[tuple[str, ...]]]
"""By kind: (joint, interface), (controller, type), (controller, key), (plugin,), (where, type of sensor), (topic,),
(controller,); also `joints`, all that are controlled, `controllers`, all that are configured, and `robots`: (robot,
joint, interface)."""


def facts_of_folder(folder: str, distro: str | None = None) -> Facts:
    """Return the facts of everything in a folder that can be expanded."""
    settings = Settings(distro=distro, workspace=folder, timeout=60.0)
    files = discover_files([folder]).with_generated()
    plan = [entry.target for entry in planned(files, ())]
    started = [target for target in plan if is_launch(target.path)]
    others = [target for target in plan if not is_launch(target.path)]
    loader = Loader(settings)
    variants = [variant for target in started for variant in loader.variants(target)]
    targets = [*others, *variants, *(Target(path) for path in files.controllers_candidates)]
    targets += [Target(path) for path in map(os.path.abspath, files.others) if Target(path) not in others]
    facts: Facts = defaultdict(set)
    workers = Workers(shared_loader(targets, settings), targets_per_worker=16)
    for result in run_on_targets(facts_work, targets, settings, workers=workers) if targets else ():
        for kind, found in result.items() if isinstance(result, dict) else ():
            facts[kind].update(tuple(fact) for fact in found)
    facts["bridged"].update((topic,) for topic in _topics_in_files(folder))
    return facts


def facts_work(work: Work) -> dict[str, Any]:
    """Collect the facts of one target in a worker."""
    project = work.loader.load(work.target).project
    facts: dict[str, list[tuple[str, ...]]] = defaultdict(list)
    if project.robot is not None and not project.library:
        _of_robot(project.robot, facts)
    _of_controllers(project, facts)
    _of_launch(project, facts)
    return {kind: sorted({fact for fact in found if _is_known(fact)}) for kind, found in facts.items()}


def _is_known(fact: tuple[str, ...]) -> bool:
    return not any(mark in part for part in fact for mark in _KNOWN_SOURCES)


def _of_robot(robot: Robot, facts: dict[str, list[tuple[str, ...]]]) -> None:
    for joint, interface in (*_of_transmissions(robot), *_of_components(robot)):
        facts["joints"].append((joint,))
        facts["interfaces"].append((joint, interface))
        facts["robots"].append((robot.name or "", joint, interface))
    facts["plugins"] += ((name,) for name in _plugins(robot))
    for gazebo in robot.gazebos:
        for sensor in gazebo.tag.named("sensor"):
            facts["sensors"].append((gazebo.reference or "", sensor.attributes.get("type", "")))
    for control in robot.ros2_controls:
        facts["sensors"] += ((part.name or "", "ros2_control") for part in control.of_kind("sensor"))


def _of_transmissions(robot: Robot) -> Iterator[tuple[str, str]]:
    """The joints of ROS 1 with the command interfaces that the same words mean in ROS 2."""
    together = {"posvel": ("position", "velocity"), "posvelacc": ("position", "velocity", "acceleration")}
    for transmission in robot.transmissions:
        for end in transmission.kept_joints:
            for interface in end.named_interfaces:
                name = interface.value.removeprefix("hardware_interface/").removesuffix("JointInterface").lower()
                yield from ((end.name or "", each) for each in together.get(name, (name,)))


def _of_components(robot: Robot) -> Iterator[tuple[str, str]]:
    for control in robot.ros2_controls:
        for part in control.of_kind("joint"):
            commands = [command.name for command in part.commands if command.name]
            yield from ((part.name or "", name) for name in commands or [_STATES_ONLY])


def _plugins(robot: Robot) -> Iterator[str]:
    for plugin in robot.plugins:
        yield plugin.filename or ""
    for control in robot.ros2_controls:
        yield from (text.past_comments for hardware in control.hardware for text in hardware.plugins)
        yield from (text.past_comments for one in control.transmissions for text in one.plugins)


def _of_controllers(project: Project, facts: dict[str, list[tuple[str, ...]]]) -> None:
    for controller in project.controllers.controllers if project.controllers else ():
        facts["controllers"].append((controller.name,))
        if controller.type is not None:
            facts["types"].append((controller.name, controller.type.text))
        facts["keys"] += ((controller.name, name) for name in _keys_of(controller, project.distro))


def _keys_of(controller: Controller, distro: str | None) -> Iterator[str]:
    """The parameters of a controller that its type reads in a distro, and that are not deprecated there."""
    kind = CATALOG.controller(controller.type.text, distro) if controller.type and distro else None
    for parameter in controller.own.leaves:
        found = matching(parameter.name, kind.parameters) if kind else None
        if kind is None or (found and not kind.parameters[found[0]].deprecated):
            yield parameter.name


def _of_launch(project: Project, facts: dict[str, list[tuple[str, ...]]]) -> None:
    launch = project.launch
    if launch is None:
        return
    for spawn in (*launch.spawns, *launch.elsewhere):
        facts["spawned"] += ((name.rpartition("/")[2],) for name, _ in spawn.names)
    for node in launch.nodes:
        if node.executable.text in {"parameter_bridge", "image_bridge"}:
            words = (word.text for word in node.words if not word.text.startswith("-"))
            topics = (word.partition("@")[0].lstrip("/") for word in words if word and ":=" not in word)
            facts["bridged"] += ((_in_ros(topic, node.remaps),) for topic in topics)


def _in_ros(topic: str, remaps: Sequence[tuple[str, str]]) -> str:
    """The name in ROS of a topic that a bridge is given by its name in gz; a namespace before it is not counted."""
    new = next((new for old, new in remaps if old.strip("/") == topic), topic).strip("/")
    return topic if new.endswith(f"/{topic}") else new


def _topics_in_files(folder: str) -> Iterator[str]:
    """The topics in files for ros_gz_bridge's `config_file`."""
    for path in sorted(Path(folder).rglob("*.y*ml")):
        data = path.read_bytes() if path.is_file() else b""
        if not any(name in data for name in _LIST_OF_TOPICS):
            continue
        try:
            entries = yaml.safe_load(data)
        except yaml.YAMLError:
            continue
        for entry in entries if isinstance(entries, list) else ():
            topic = entry.get("ros_topic_name") or entry.get("topic_name") if isinstance(entry, dict) else None
            if isinstance(topic, str):
                yield _PLACEHOLDER.sub("", topic).lstrip("/")
