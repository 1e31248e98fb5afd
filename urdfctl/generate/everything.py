"""Which generators make which files."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from urdfctl.catalog.catalog import Catalog
from urdfctl.errors import UserError
from urdfctl.generate.controllers import Controller, controllers
from urdfctl.generate.controllers_file import controllers_file
from urdfctl.generate.facts import JointFacts, RobotFacts
from urdfctl.generate.options import File, Options
from urdfctl.generate.parse_again import checked
from urdfctl.generate.templates import Templates


class Order(NamedTuple):
    """What is to be made, of what, and with what."""

    joints: tuple[JointFacts, ...]
    options: Options
    catalog: Catalog
    robot: RobotFacts
    templates: Templates

    @property
    def title(self) -> str:
        """What the robot is called."""
        return f"'{self.robot.name}'" if self.robot.name else "these joints"

    def controllers(self) -> tuple[Controller, ...]:
        """The controllers that are asked for."""
        return controllers(self.joints, self.options, self.catalog, self.robot)


def _controllers(order: Order) -> list[File]:
    if not order.options.types:
        raise UserError("what kind of controllers? Say --type, such as --type effort, trajectory or diff_drive")
    return [controllers_file(order.controllers(), order.options, order.templates, order.title)]


GENERATORS: Mapping[str, Callable[[Order], list[File]]] = {
    "gen-controllers": _controllers,
}


def files(command: str, order: Order) -> list[File]:
    """The files of a command, each parsed again. UserError where they cannot be made."""
    return [checked(file) for file in GENERATORS[command](order)]
