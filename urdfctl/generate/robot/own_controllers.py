"""Read the controllers that the simulator's plugin in a robot loads, for what is written beside them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.generate.robot.facts import OwnController
from urdfctl.load.controller_files import read_controllers
from urdfctl.model.controllers import Controller
from urdfctl.model.robot import Robot
from urdfctl.source.disk.files import Files

_ROS2 = 2


def own_controllers(robot: Robot, files: Files) -> Iterator[OwnController]:
    """Yield the controllers of ROS 2 in the files that plugins of a robot load, in their order."""
    found = read_controllers((), robot, None, files)
    for controller in found.model(_ROS2, None).controllers if found and found.form == _ROS2 else ():
        if controller.type and controller.type.text:
            joints, commanded = (_texts(controller, name) for name in ("joints", "command_interfaces"))
            joints = joints or _texts(controller, "joint")
            yield OwnController(controller.name, controller.type.text, joints, commanded)


def _texts(controller: Controller, name: str) -> tuple[str, ...]:
    value = controller.parameters.value(name)
    return tuple(text for text, _ in value.strings) if value else ()
