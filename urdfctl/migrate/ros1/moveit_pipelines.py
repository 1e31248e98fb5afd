"""The planning pipelines that MoveIt's move_group loaded in ROS 1: MoveItConfigsBuilder loads all that it knows, unless
it is told which, and move_group ends where the planner of one is not installed."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfctl.catalog.distros import since
from urdfctl.migrate.edits.markup import children, elements, root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.source.disk.gate import exists
from urdfctl.source.xml.dom import Element

PLANNERS: Mapping[str, str] = {
    "ompl": "moveit_planners_ompl",
    "chomp": "moveit_planners_chomp",
    "pilz_industrial_motion_planner": "pilz_industrial_motion_planner",
    "stomp": "moveit_planners_stomp",
}
"""By planning pipeline: the package with its planner (moveit2 moveit_planners)."""
CARTESIAN_LIMITS, PILZ_LIMITS = "cartesian_limits.yaml", "pilz_cartesian_limits.yaml"
"""The file with the limits of Pilz's planner, as MoveIt for ROS 1 and MoveIt 2 call it."""
_PILZ, _USUAL = "pilz_industrial_motion_planner", "ompl"
_NOT_YET = {"stomp": "jazzy"}
_FILE = "planning_pipeline.launch.xml"
_NAMED = re.compile(rf"/([\w-]+)_{re.escape(_FILE)}\Z")
_ARGUMENT = re.compile(r"\$\(arg (\w+)\)")
_WRITTEN = re.compile(r"planning_pipelines\(pipelines=\[([^\]]*)\]")


def loaded_pipelines(packages: MigratedPackages, folder: str) -> tuple[str, ...]:
    """Return the planning pipelines that the launch file of move_group in a package loads, and MoveIt 2 has."""
    root = root_of(packages.read(os.path.join(folder, "launch", "move_group.launch")))
    named = dict.fromkeys(_named(root)) if root is not None else {}
    found = tuple(name for name in named if _is_there(packages, folder, name))
    return found or (_USUAL,)


def planners_of(launch_file: str) -> Iterator[str]:
    """Yield the packages of the planners that a launch file in Python names for MoveIt."""
    for found in _WRITTEN.finditer(launch_file):
        yield from (PLANNERS[name] for name in re.findall(r"[\w-]+", found[1]) if name in PLANNERS)


def _named(root: Element) -> Iterator[str]:
    defaults = {one.attrs.get("name", ""): one.attrs.get("default", "") for one in elements(root) if _is_arg(one)}
    for include in (one for one in elements(root) if one.tagName == "include"):
        file = include.attrs.get("file", "")
        own = _NAMED.search(file)
        given = (one.attrs.get("value", "") for one in children(include, "arg") if one.attrs.get("name") == "pipeline")
        if own is not None:
            yield own[1]
        elif file.endswith(f"/{_FILE}"):
            yield _ARGUMENT.sub(lambda argument: defaults.get(argument[1], ""), next(given, _USUAL))


def _is_arg(element: Element) -> bool:
    return element.tagName == "arg" and "default" in element.attrs


def _is_there(packages: MigratedPackages, folder: str, name: str) -> bool:
    """Whether MoveIt 2 has the planner of a pipeline, and finds the files that it needs."""
    config = os.path.join(folder, "config")
    if name == _PILZ and not any(exists(os.path.join(config, file)) for file in (CARTESIAN_LIMITS, PILZ_LIMITS)):
        return False
    return name in PLANNERS and (name not in _NOT_YET or packages.options.target in since(_NOT_YET[name]))
