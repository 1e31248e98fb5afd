"""What a ROS 2 launch file is read with: files, packages and the environment."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.source.launch.terms import Term
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class Ros2Sources(NamedTuple):
    """Access to files, packages and the environment for a launch file.

    read: returns the launch description of a file; None if it cannot be read.
    locate: returns the source path of a file, and whether it exists; None if that cannot be checked.
    find: returns the folder of a package that is used at a place; None if it is not among the sources.
    environ: the environment variables.
    values: returns the content of a YAML file; None if it cannot be read.
    blank: returns the value of arguments with an empty default, in this file and the included ones.
    too_long: is told a place at which a text becomes too long.
    written: returns the text that launch files write into a file; None if they write none.
    """

    read: Callable[[str], Term | None]
    locate: Callable[[str], tuple[str, bool | None]]
    find: Callable[[str, Place], str | None]
    environ: Mapping[str, str]
    values: Callable[[str], Term | None] = lambda _: None
    blank: Callable[[], str] = str
    too_long: Callable[[Place], None] = lambda _: None
    written: Callable[[str], Term | None] = lambda _: None
