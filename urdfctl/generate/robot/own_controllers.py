"""Read the controllers that the simulator's plugin in a robot loads, for what is written beside them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from urdfctl.generate.robot.facts import OwnController
from urdfctl.load.controller_files import read_controllers
from urdfctl.model.controllers import Controller
from urdfctl.model.robot import Robot
from urdfctl.source.disk.files import Files
from urdfctl.source.workspaces.packages import package_around, package_name

_ROS2 = 2


def own_controllers(robot: Robot, files: Files) -> Iterator[OwnController]:
    """Yield the controllers of ROS 2 in the files that plugins of a robot load, in their order."""
    found = read_controllers((), robot, None, files)
    for controller in found.model(_ROS2, None).controllers if found and found.form == _ROS2 else ():
        if controller.type and controller.type.text:
            joints, commanded = (_texts(controller, name) for name in ("joints", "command_interfaces"))
            joints = joints or _texts(controller, "joint")
            yield OwnController(controller.name, controller.type.text, joints, commanded)


def own_file(hosted: Sequence[str]) -> tuple[str, str] | None:
    """Return the package of the only file that the plugins of a robot load, and its path there; None if it has none."""
    if len(hosted) != 1 or not os.path.isabs(hosted[0]):
        return None
    folder = package_around(os.path.dirname(hosted[0]))
    name = package_name(os.path.join(folder, "package.xml")) if folder else None
    return (name, os.path.relpath(hosted[0], folder).replace(os.sep, "/")) if name else None


def _texts(controller: Controller, name: str) -> tuple[str, ...]:
    value = controller.parameters.value(name)
    return tuple(text for text, _ in value.strings) if value else ()
