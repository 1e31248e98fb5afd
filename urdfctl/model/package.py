"""A package as its manifest and its build files tell of it."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.record import NamedTuple
from urdfctl.source.span import Place


class Package(NamedTuple):
    """The package that a launch file lies in; `at` is its manifest's root element, `build_file` what tells what it
    installs. `ros` is the generation of ROS that builds it, None where it does not tell.

    `dependencies` are those that its manifest names for running. `reaches` tells whether it needs a package, itself or
    by others among the sources; `installs` whether a file of it, by its path in the sources, comes to its share folder,
    None where the build files do not surely tell.
    """

    name: str
    folder: str
    at: Place
    ros: int | None
    dependencies: frozenset[str]
    reaches: Callable[[str], bool]
    installs: Callable[[str], bool | None]
    build_file: str
    tag: str = "exec_depend"
    """The element that names what is needed for running, in the format of the manifest."""

    def holds(self, place: Place) -> bool:
        """Whether a place is in a file of the package."""
        return place.source.path.startswith(f"{self.folder}/")
