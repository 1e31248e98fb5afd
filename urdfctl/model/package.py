"""The model of a package, from its manifest and its build files."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class Package(NamedTuple):
    """The package that contains a launch file.

    at: the root element of the manifest.
    ros: the ROS generation of its build system; None if unknown.
    dependencies: its run dependencies, as the manifest lists them.
    reaches: returns whether a package is among its run dependencies, directly or through other source packages.
    installs: returns whether a source file, by its path, is installed to the share folder; None if unknown.
    build_file: the file with the install rules.
    shares_models: returns whether a package, by its name, adds its folder to Gazebo's model path; None if unknown.
    """

    name: str
    folder: str
    at: Place
    ros: int | None
    dependencies: frozenset[str]
    reaches: Callable[[str], bool]
    installs: Callable[[str], bool | None]
    build_file: str
    shares_models: Callable[[str], bool | None] = lambda _: None
    tag: str = "exec_depend"
    """The element for a run dependency in the manifest's format."""

    def holds(self, place: Place) -> bool:
        """Return whether a place is in a file of the package."""
        return place.source.path.startswith(f"{self.folder}/")
