"""The targets of a run, each loaded and linted on its own."""

from __future__ import annotations

from typing import Any

from urdfctl.startup.records import NamedTuple


class LaunchStart(NamedTuple):
    """A launch file that is started, with its arguments."""

    path: str
    arguments: tuple[tuple[str, str], ...] = ()


class Target(NamedTuple):
    """One robot in one variant, or a controller file or launch file without a robot.

    path: the description; or the controller file or launch file.
    arguments: xacro arguments, or those of the launch file.
    fragment: True if the description is only a part, which other files include.
    controllers: the controller files that belong to the robot.
    launch: the launch file that belongs to the robot.
    by_elimination: True if nothing says that the controller files belong to the robot, but nothing else is there.
    guessed: whether the arguments of a launch file are guessed from the files that exist.
    namespace: that of the robot, if the launch file starts several with the same description.
    beside: the launch files that are started beside the one of the target, in another terminal.
    towards: a launch file that arguments of this one are sought for, with which it is included.
    documented: the choices of arguments with which READMEs and scripts start the launch file, each with its place.
    told_at: where its arguments are documented.
    """

    path: str
    arguments: tuple[tuple[str, str], ...] = ()
    fragment: bool = False
    controllers: tuple[str, ...] = ()
    launch: str | None = None
    by_elimination: bool = False
    guessed: bool = False
    namespace: str | None = None
    beside: tuple[LaunchStart, ...] = ()
    towards: str | None = None
    documented: tuple[tuple[tuple[tuple[str, str], ...], str], ...] = ()
    told_at: str | None = None

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Target:
        """Return the target that `_asdict` and JSON made `data` from."""
        beside = tuple(LaunchStart(path, _pairs(arguments)) for path, arguments in data["beside"])
        lists = {"arguments": _pairs(data["arguments"]), "controllers": tuple(data["controllers"]), "beside": beside}
        documented = tuple((_pairs(arguments), place) for arguments, place in data["documented"])
        return cls(**{**data, **lists, "documented": documented})


def _pairs(data: list[list[Any]]) -> tuple[tuple[str, str], ...]:
    return tuple((str(name), str(value)) for name, value in data)
